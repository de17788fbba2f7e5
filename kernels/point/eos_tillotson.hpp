#pragma once
#include "point/eos_state.hpp"

namespace breccia {

/// Tillotson's equation of state of impacts: from a compressed solid to its vapour
/// (ALGORITHMS ).
///
// symbols  eta = rho / rho0, mu = eta - 1   w = 1 + e / (e0 eta^2)   x = 1 / eta - 1
//          e_iv, e_cv [J/kg] begin and end of vaporisation
// eq:eos-6  p1 = (a + b / w) rho e + A mu + B mu^2                    rho >= rho0 or e <= e_iv
// eq:eos-7  p2 = a rho e + (b rho e / w + A mu exp(-beta x)) exp(-alpha x^2)     e >= e_cv
// eq:eos-8  p = ((e - e_iv) p2 + (e_cv - e) p1) / (e_cv - e_iv)       between
// eq:eos-9  p1 < 0: times a ramp from 1 at eta = 0.55 to 0 at eta = 0.45; p not below -spall
// A cold solid that has swollen to twice its volume has come apart: without the ramp A mu would go
// on pulling at it, and at its vapour between e_iv and e_cv. An energy below 0 counts as 0 in w,
// which has a pole there.
// source   Tillotson, General Atomic report GA-3216 (1962); Melosh, Impact Cratering (1989)
struct Tillotson {
  double rho0 = 0;             ///< kg/m3
  double a = 0, b = 0;         ///< 1
  double bulk = 0, bulk2 = 0;  ///< A, B, Pa
  double alpha = 5, beta = 5;  ///< 1
  double e0 = 0;               ///< J/kg
  double e_iv = 0, e_cv = 0;   ///< J/kg, e_iv < e_cv
  double spall = 1e300;        ///< largest tension, Pa

  static constexpr double kPullsAbove = 0.45, kPullsFully = 0.55;  ///< eta

  KOKKOS_FUNCTION
  EosPoint at(double rho, double e) const {
    const double eta = rho / rho0;
    EosPoint p;
    if (eta >= 1 || e <= e_iv) {
      p = condensed(rho, e);
    } else if (e >= e_cv) {
      p = vapour(rho, e);
    } else {
      const EosPoint cold = condensed(rho, e), hot = vapour(rho, e);
      const double share = (e - e_iv) / (e_cv - e_iv);
      p = {cold.p + share * (hot.p - cold.p), cold.p_rho + share * (hot.p_rho - cold.p_rho),
           cold.p_e + share * (hot.p_e - cold.p_e) + (hot.p - cold.p) / (e_cv - e_iv)};
    }
    return p.p < -spall ? EosPoint{-spall, p.p_rho, 0} : p;
  }

 private:
  /// b / w with its derivatives by rho and e.
  KOKKOS_INLINE_FUNCTION
  EosPoint heated(double rho, double e) const {
    if (!(e > 0)) return {b, 0, 0};
    const double eta = rho / rho0, ratio = e / (e0 * eta * eta), w = 1 + ratio;
    return {b / w, 2 * b * ratio / (w * w * rho), -b * ratio / (w * w * e)};
  }
  KOKKOS_INLINE_FUNCTION
  EosPoint condensed(double rho, double e) const {  // eq:eos-6, eq:eos-9
    const EosPoint h = heated(rho, e);
    const double eta = rho / rho0, mu = eta - 1;
    const EosPoint p{(a + h.p) * rho * e + (bulk + bulk2 * mu) * mu,
                     (a + h.p + h.p_rho * rho) * e + (bulk + 2 * bulk2 * mu) / rho0,
                     (a + h.p + h.p_e * e) * rho};
    if (p.p >= 0 || eta >= kPullsFully) return p;
    const double slope = 1 / (kPullsFully - kPullsAbove);
    const double ramp = eta > kPullsAbove ? (eta - kPullsAbove) * slope : 0;
    return {p.p * ramp, p.p_rho * ramp + (ramp > 0 ? p.p * slope / rho0 : 0), p.p_e * ramp};
  }
  KOKKOS_INLINE_FUNCTION
  EosPoint vapour(double rho, double e) const {  // eq:eos-7
    const EosPoint h = heated(rho, e);
    const double mu = rho / rho0 - 1, x = rho0 / rho - 1, x_rho = -rho0 / (rho * rho);
    const double spread = Kokkos::exp(-alpha * x * x), pull = bulk * Kokkos::exp(-beta * x);
    const double inner = h.p * rho * e + pull * mu;
    const double inner_rho = (h.p + h.p_rho * rho) * e + pull * (1 / rho0 - beta * x_rho * mu);
    return {a * rho * e + inner * spread,
            a * e + (inner_rho - 2 * alpha * x * x_rho * inner) * spread,
            a * rho + (h.p + h.p_e * e) * rho * spread};
  }
};

}  // namespace breccia
