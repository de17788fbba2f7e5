#pragma once
#include <cstdint>

namespace breccia {

/// Where the leapfrog stands at the start of step n (ALGORITHMS ): positions at `time`,
/// velocities half of `dt_before` behind.
struct Clock {
  std::int64_t step = 0;
  double time = 0;       ///< t^n, s
  double dt = 0;         ///< length of this step, s
  double dt_before = 0;  ///< length of the last step; 0 at the start, so the first kick is half

  /// Time over which the forces at t^n act on the velocities.
  double kick() const { return 0.5 * (dt_before + dt); }
  double middle() const { return time + 0.5 * dt; }
};

}  // namespace breccia
