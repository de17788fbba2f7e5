#pragma once
#include "base/vec.hpp"

namespace breccia {

/// When a bonded face is replaced by an interface.
///
// symbols  t [Pa] traction on the face, t_n, t_s its normal and shear parts
//          f_t, c_0 [Pa] tensile strength, cohesion   mu_i [1] friction of the intact face
// source   ALGORITHMS
// page     docs/modules/fracture.md
struct CohesiveOnset {
  double tension = 0, cohesion = 0, friction = 0;
  double alpha = 1;
  bool elliptic = false;

  /// Share of the strength that is used; 1 on the envelope.
  template <int D>
  KOKKOS_FUNCTION
  double measure(const Vec<D>& traction, const Vec<D>& normal) const {
    const double t_n = dot(traction, normal);
    const double t_s = norm(traction - normal * t_n);
    const double f_te = t_n / tension;  // eq:cohesive-17
    if (elliptic) {
      // eq:cohesive-18  f^2 = max(f_te, 0)^2 + (t_s / (c_0 - mu_i t_n))^2
      const double strength = cohesion - friction * t_n;
      if (!(strength > 0)) return f_te > 1 ? f_te : 1;
      const double opening = f_te > 0 ? f_te : 0, sliding = t_s / strength;
      return Kokkos::sqrt(opening * opening + sliding * sliding);
    }
    const double f_sh = (t_s + friction * t_n) / cohesion;  // eq:cohesive-19
    return f_te > f_sh ? f_te : f_sh;
  }
};

}  // namespace breccia
