#pragma once
#include "base/mat.hpp"
#include "base/pack.hpp"

#include <algorithm>
#include <cmath>

namespace breccia {

/// Bound on how near the stress in an element comes to opening a face on any plane. Neither roots
/// nor quotients: all elements are watched in each step, and hardly one is near.
///
// symbols  tau = J sigma [Pa] Kirchhoff stress   s1, s3 largest, smallest principal stress
//          m = mean (in the plane of s1 and s3)   radius = (s1 - s3) / 2 in the plane, sqrt(J2) in
//          space   f_t, c_0 [Pa] tensile strength, cohesion   mu_i [1] tangent of friction angle
// source   Mohr's circle; the onset measure f of ALGORITHMS is convex in the stress, so the
//          average of two elements never exceeds the larger of their bounds.
template <int D>
struct StressWatch {
  bool on = false;
  double tension = 0, tension_mean = 0;  ///< opens where radius > tension J - tension_mean m
  double shear = 0, shear_mean = 0;      ///< slides where radius > shear J - shear_mean m
  double far2 = 0;                       ///< Pa2; neither where sigma : sigma is below it

  StressWatch() = default;

  /// 1 / (alpha f_t), 1 / (alpha c_0) in 1/Pa, mu_i. A `per_tension` of 0 watches nothing.
  StressWatch(double per_tension, double per_cohesion, double friction) : on(per_tension > 0) {
    if (!on) return;
    // In space s1 <= m + 2 sqrt(J2 / 3), (s1 - s3) / 2 <= sqrt(J2), (s1 + s3) / 2 <=
    // m + sqrt(J2 / 3), each reached in some state; in the plane all is exact.
    const double s1 = D == 2 ? 1 : 2 / std::sqrt(3.0);
    const double slope =
        std::sqrt(1 + friction * friction) + (D == 2 ? 0 : friction / std::sqrt(3.0));
    tension = 1 / (per_tension * s1);
    tension_mean = 1 / s1;
    shear = 1 / (per_cohesion * slope);
    shear_mean = friction / slope;
    // Largest t_s + mu_i t_n of all stresses with sigma : sigma = 1, by Cauchy and Schwarz: m is
    // their part along 1, sqrt(2) in the plane and sqrt(3) in space times m, radius the other one.
    const double slides = std::sqrt(friction * friction / D + 0.5 * slope * slope);
    const double nearest = std::max(per_tension, per_cohesion * slides);
    far2 = 1 / (nearest * nearest);
  }

  /// True in all lanes where room() is sure to be above 0: most of a body, with little to compute.
  template <class R>
  KOKKOS_FORCEINLINE_FUNCTION
  bool is_far(const Sym<D, R>& tau, const R& jacobian) const {
    return !any(R(far2) * jacobian * jacobian <= contract(tau, tau));
  }

  /// Above 0 while max over planes of max(t_n / f_t, (t_s + mu_i t_n) / c_0) / alpha is below 1,
  /// Pa2.
  template <class R>
  KOKKOS_FORCEINLINE_FUNCTION
  R room(const Sym<D, R>& tau, const R& jacobian) const {
    R m, radius2;
    measure(tau, m, radius2);
    const R most = minimum(R(tension) * jacobian - R(tension_mean) * m,
                           R(shear) * jacobian - R(shear_mean) * m);
    return most * absolute(most) - radius2;
  }

 private:
  template <class R>
  KOKKOS_FORCEINLINE_FUNCTION
  static void measure(const Sym<2, R>& tau, R& m, R& radius2) {
    m = R(0.5) * (tau.s[0] + tau.s[1]);
    const R half = R(0.5) * (tau.s[0] - tau.s[1]);
    radius2 = half * half + tau.s[2] * tau.s[2];
  }

  template <class R>
  KOKKOS_FORCEINLINE_FUNCTION
  static void measure(const Sym<3, R>& tau, R& m, R& radius2) {
    m = trace(tau) * R(1.0 / 3.0);
    Sym<3, R> s = tau;
    for (int i = 0; i < 3; ++i) s.s[i] = s.s[i] - m;
    radius2 = R(0.5) * contract(s, s);
  }
};

}  // namespace breccia
