#pragma once
#include "point/eos_condensed.hpp"
#include "point/eos_gas.hpp"
#include "point/eos_tillotson.hpp"

namespace breccia {

enum class EosKind { linear, mie_gruneisen, tillotson, ideal_gas, jwl };

/// Pores that close under pressure (Herrmann's P-alpha).
///
// symbols  alpha = solid density / density   p_e, p_c [Pa] begin and end of crushing
// eq:eos-12  p = p_solid(alpha rho, e) / alpha
// eq:eos-13  alpha <= 1 + (alpha0 - 1) ((p_c - p) / (p_c - p_e))^2, p_e <= p <= p_c; 1 above
// Crushing is for good: alpha never grows. Below p_e and while unloading it stays.
// source     Herrmann, J. Appl. Phys. 40 (1969) 2490, doi:10.1063/1.1658021
struct Pores {
  double alpha = 1;  ///< at rest; 1: no pores
  double begin = 0;  ///< p_e, Pa
  double end = 0;    ///< p_c, Pa, above p_e

  /// Pressure at which alpha begins to go below a value.
  KOKKOS_INLINE_FUNCTION
  double crushing(double alpha_now) const {
    const double share = (alpha_now - 1) / (alpha - 1);
    return end - (end - begin) * Kokkos::sqrt(share > 0 ? share : 0);
  }
};

/// One equation of state: which, and its numbers.
struct Eos {
  EosKind kind = EosKind::linear;
  double rho0 = 0;      ///< kg/m3, of the material at rest, with its pores
  double energy0 = 0;   ///< J/kg, at rest
  double modulus0 = 0;  ///< Pa, rho c^2 at rest, above 0
  Pores pores;
  LinearEos linear;
  MieGruneisen mie_gruneisen;
  Tillotson tillotson;
  IdealGas ideal_gas;
  Jwl jwl;

  /// The speed of sound is never below the square root of this share of that at rest, so that time
  /// steps stay finite where a curve is flat or unstable.
  static constexpr double kFloor = 1e-3;
  static constexpr int kIterations = 30;

  /// eq:eos-12 and its derivatives at a distension that stays.
  KOKKOS_FUNCTION
  EosPoint at(double rho, double e, double alpha = 1) const {
    EosPoint q = solid(alpha * rho, e);
    q.p /= alpha;
    q.p_e /= alpha;
    return q;
  }

  KOKKOS_FUNCTION
  double pressure(double rho, double e, double alpha = 1) const { return at(rho, e, alpha).p; }

  /// eq:eos-4  rho c^2 = rho dp/drho|e + p / rho dp/de, at least kFloor modulus0 rho / rho0
  KOKKOS_FUNCTION
  double bulk_modulus(double rho, double e, double alpha = 1) const {
    const EosPoint q = at(rho, e, alpha);
    const double k = rho * q.p_rho + q.p / rho * q.p_e, least = kFloor * modulus0 * rho / rho0;
    return k > least ? k : least;
  }

  KOKKOS_FUNCTION
  double bulk_modulus(const EosState& s) const { return bulk_modulus(s.rho, s.e, s.alpha); }

  /// The material at rest.
  KOKKOS_FUNCTION
  EosState start() const {
    return {rho0, energy0, pressure(rho0, energy0, pores.alpha), pores.alpha};
  }

  /// eq:eos-5  e' = e + work - (p + p') / 2 (1 / rho' - 1 / rho), p' = p(rho', e')
  /// `work` is what else heats in this step: plastic flow, viscosity, J/kg.
  KOKKOS_FUNCTION
  void advance(EosState& state, double rho, double work) const {
    const double half = 0.5 * (1 / rho - 1 / state.rho);
    const double fixed = state.e + work - half * state.p;
    EosState next = balanced(rho, state.alpha, state.e, fixed, half);
    if (state.alpha > 1 && next.p > pores.crushing(state.alpha)) {
      next = crushed(next, fixed, half);
    }
    state = next;
  }

 private:
  KOKKOS_INLINE_FUNCTION
  EosPoint solid(double rho, double e) const {
    switch (kind) {
      case EosKind::linear:
        return linear.at(rho, e);
      case EosKind::mie_gruneisen:
        return mie_gruneisen.at(rho, e);
      case EosKind::tillotson:
        return tillotson.at(rho, e);
      case EosKind::ideal_gas:
        return ideal_gas.at(rho, e);
      case EosKind::jwl:
        return jwl.at(rho, e);
    }
    return {0, 0, 0};
  }

  /// eq:eos-5 at a given distension by Newton's method: one iteration where p is linear in e, two
  /// across a tension limit, a few on the curves of Tillotson.
  KOKKOS_INLINE_FUNCTION
  EosState balanced(double rho, double alpha, double e, double fixed, double half) const {
    EosPoint q = at(rho, e, alpha);
    for (int i = 0; i < kIterations; ++i) {
      const double slope = 1 + half * q.p_e;
      const double change = (fixed - half * q.p - e) / (slope > 0.1 ? slope : 0.1);
      e += change;
      q = at(rho, e, alpha);
      if (Kokkos::abs(change) <= 1e-15 * Kokkos::abs(e)) break;
    }
    return {rho, e, q.p, alpha};
  }

  /// eq:eos-13: the distension at which pressure and crushing agree, by false position between 1
  /// and the old one (Illinois rule).
  KOKKOS_INLINE_FUNCTION
  EosState crushed(const EosState& open, double fixed, double half) const {
    EosState low = balanced(open.rho, 1, open.e, fixed, half);
    double f_low = low.p - pores.crushing(1), f_high = open.p - pores.crushing(open.alpha);
    if (f_low >= 0) return low;  // no pore is left
    double a = 1, b = open.alpha;
    EosState now = low;
    int side = 0;
    for (int i = 0; i < 60; ++i) {
      const double alpha = (a * f_high - b * f_low) / (f_high - f_low);
      now = balanced(open.rho, alpha, now.e, fixed, half);
      const double f = now.p - pores.crushing(alpha);
      if (Kokkos::abs(f) <= 1e-14 * pores.end || !(alpha > a && alpha < b)) break;
      if (f < 0) {
        a = alpha;
        f_low = f;
        if (side < 0) f_high *= 0.5;
        side = -1;
      } else {
        b = alpha;
        f_high = f;
        if (side > 0) f_low *= 0.5;
        side = 1;
      }
    }
    return now;
  }
};

}  // namespace breccia
