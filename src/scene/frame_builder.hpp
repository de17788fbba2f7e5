#pragma once
#include "io/frame_series.hpp"
#include "scene/force_chains.hpp"
#include "scene/fragments.hpp"
#include "step/clock.hpp"
#include "step/model.hpp"
#include "step/observation.hpp"

#include <optional>
#include <vector>

namespace breccia {

/// One frame: the mesh where it is now, with displacement, velocity, body and fragment, and what
/// the modules drew.
template <int D>
class FrameBuilder {
 public:
  FrameBuilder(const Model<D>& model, const Clock& clock, const Picture& picture,
               const Fragments& fragments);
  void write(FrameSeries& series) const;
  /// Of all numbers of the frame, before compression.
  std::size_t bytes() const;

 private:
  void add_cracks(const std::vector<CrackFace>& cracks);
  CrackFrame cracks() const;

  double time_;
  std::int64_t step_;
  const Picture& picture_;
  bool with_cracks_;
  std::vector<double> points_, displacement_, velocity_;
  std::vector<std::int32_t> connectivity_, body_, fragment_;
  std::vector<double> crack_points_, damage_, mode_, opening_, slip_, break_time_, energy_;
  std::vector<std::int32_t> crack_connectivity_, status_;
  std::optional<ForceChains> chains_;
};

}  // namespace breccia
