#pragma once

#include "batch/sweep.hpp"

namespace breccia {

/// What has become of a variant, kept in its folder.
struct VariantState {
  enum class Stage { waiting, queued, running, complete, failed, stopped };

  Stage stage = Stage::waiting;
  int attempts = 0;    ///< since the sweep was last started
  std::string reason;  ///< why it is not complete
  /// It was ended from outside, so that the next attempt goes on from its checkpoint.
  bool cut_off = false;
};

/// "complete", "not run".
std::string stage_text(VariantState::Stage stage);

/// States of all variants that are resolved. One whose results are of another scene or another
/// build waits again with `overwrite`. \throws Error without, naming the first.
std::vector<VariantState> load_states(const Sweep& sweep, bool overwrite);

void save_state(const Sweep& sweep, std::size_t variant, const VariantState& state);

}  // namespace breccia
