#pragma once
#include "base/sums.hpp"
#include "fields/field.hpp"
#include "loops/node_motion.hpp"

namespace breccia {

/// omega_e^2 times the mass at a corner; looked at anew now and then.
struct ElementRate {
  using View = Array<double>;
  static constexpr FieldInfo info{"element_rate", Entity::element, "N/m", Restart::yes,
                                  "largest rate squared of the element times its corner mass"};
};

/// Velocity before the kick, kept for history rows only.
template <int D>
struct NodeVelocityBefore {
  using View = Vectors<D>;
  static constexpr FieldInfo info{"node_velocity_before", Entity::node, "m/s", Restart::no,
                                  "velocity at t^(n-1/2) while a history row is taken"};
};

}  // namespace breccia
