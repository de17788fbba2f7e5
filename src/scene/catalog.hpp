#pragma once
#include "core/schema.hpp"
#include "step/module.hpp"

#include <memory>
#include <vector>

namespace breccia {

/// The one list of modules: those that the scene calls for, in the order in which their tasks
/// run within a stage.
template <int D>
std::vector<std::unique_ptr<Module<D>>> make_modules(const Settings& scene);

/// The keys of the modules that have sections of their own.
void declare_module_keys(Schema& schema);

/// An effect of this build: whether the scene calls for it, and by what.
struct EffectState {
  std::string name;
  bool on;
  std::string why;  ///< "contact, line 31"; of one that is off "no [contact]"
};
/// "line 31" of "disc/scene.toml:31"; other places as they are.
std::string line_of(const std::string& place);

/// In the order of the modules.
std::vector<EffectState> effects_of(const Settings& scene);

}  // namespace breccia
