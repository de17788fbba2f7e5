#pragma once
#include "loops/node_motion.hpp"

namespace breccia {

/// All forces on a node but for what holds it, N; as the motion loop gathers them.
template <int D>
struct NetForce {
  NodeMotionIn<D> in;

  KOKKOS_FUNCTION
  Vec<D> operator()(Index n) const {
    const std::uint32_t flags = in.flags(n);
    const double added = in.added_mass.extent(0) > 0 ? in.added_mass(n) : 0.0;
    Vec<D> f = in.gravity * (in.mass(n) - added);
    for (Index k = in.corners(n, 0); k < in.corners(n, 1); ++k) {
      const auto at = static_cast<std::ptrdiff_t>(in.corner_list(k)) * D;
      for (int d = 0; d < D; ++d) f[d] += in.element_force.at(in.corner_list(k), d);
      for (int c = 0; c < kExtraClasses; ++c) {
        if ((flags & in.extra_bit[c]) == 0) continue;
        for (int d = 0; d < D; ++d) f[d] += in.extra[c].data()[at + d];
      }
    }
    return f;
  }
};

}  // namespace breccia
