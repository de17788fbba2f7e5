#pragma once
#include "base/mat.hpp"
#include "base/pack.hpp"

namespace breccia {

/// Bound on how near the stress in an element comes to opening a face on any plane.
///
// symbols  s1, s3 [Pa] largest, smallest principal stress   m = mean   J2 [Pa2] of the deviator
//          f_t, c_0 [Pa] tensile strength, cohesion   mu_i [1] tangent of the friction angle
// source   Mohr's circle; the onset measure f of ALGORITHMS is convex in the stress, so the
//          average of two elements never exceeds the larger of their bounds.
struct StressWatch {
  double per_tension = 0;   ///< 1 / (alpha f_t); 0 switches the watch off
  double per_cohesion = 0;  ///< 1 / (alpha c_0)
  double friction = 0;      ///< mu_i

  KOKKOS_INLINE_FUNCTION
  bool on() const { return per_tension > 0; }

  /// max over planes of max(t_n / f_t, (t_s + mu_i t_n) / c_0) / alpha. Exact in the plane.
  template <class R>
  KOKKOS_FUNCTION
  R reach(const Sym<2, R>& sigma) const {
    const R m = R(0.5) * (sigma.s[0] + sigma.s[1]);
    const R half = R(0.5) * (sigma.s[0] - sigma.s[1]);
    const R radius = square_root(half * half + sigma.s[2] * sigma.s[2]);
    return larger(m + radius, m, radius);
  }

  /// The same in space, from above: s1 <= m + 2 sqrt(J2 / 3), (s1 - s3) / 2 <= sqrt(J2),
  /// (s1 + s3) / 2 <= m + sqrt(J2 / 3), each reached in some state.
  template <class R>
  KOKKOS_FUNCTION
  R reach(const Sym<3, R>& sigma) const {
    const R m = trace(sigma) * R(1.0 / 3.0);
    Sym<3, R> s = sigma;
    for (int i = 0; i < 3; ++i) s.s[i] = s.s[i] - m;
    const R j2 = R(0.5) * contract(s, s);
    const R third = square_root(j2 * R(1.0 / 3.0));
    return larger(m + R(2) * third, m + third, square_root(j2));
  }

 private:
  template <class R>
  KOKKOS_FUNCTION
  R larger(const R& s1, const R& centre, const R& radius) const {
    const double slope = Kokkos::sqrt(1 + friction * friction);
    const R tension = s1 * R(per_tension);
    const R shear = (R(slope) * radius + R(friction) * centre) * R(per_cohesion);
    return maximum(tension, shear);
  }
};

}  // namespace breccia
