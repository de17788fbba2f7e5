#pragma once
#include "point/eos_state.hpp"

namespace breccia {

/// eq:eos-10  p = (gamma - 1) rho e
struct IdealGas {
  double gamma = 1.4;

  KOKKOS_FUNCTION
  EosPoint at(double rho, double e) const {
    return {(gamma - 1) * rho * e, (gamma - 1) * e, (gamma - 1) * rho};
  }
};

/// Gases of a detonated explosive after Jones, Wilkins and Lee.
///
// symbols  V = rho0 / rho   w [1]   e [J/kg] = E / rho0 of the energy per first volume E
// eq:eos-11  p = A (1 - w / (R1 V)) exp(-R1 V) + B (1 - w / (R2 V)) exp(-R2 V) + w rho e
// source     Lee, Hornig and Kury, UCRL-50422 (1968)
struct Jwl {
  double rho0 = 0;      ///< kg/m3, of the explosive
  double a = 0, b = 0;  ///< A, B, Pa
  double r1 = 0, r2 = 0, w = 0;

  KOKKOS_FUNCTION
  EosPoint at(double rho, double e) const {
    const double v = rho0 / rho;
    const EosPoint x = term(a, r1, v), y = term(b, r2, v);
    // dV/drho = -V / rho
    return {x.p + y.p + w * rho * e, -(x.p_rho + y.p_rho) * v / rho + w * e, w * rho};
  }

 private:
  /// One exponential with its derivative by V.
  KOKKOS_INLINE_FUNCTION
  EosPoint term(double size, double r, double v) const {
    const double wave = size * Kokkos::exp(-r * v), bracket = 1 - w / (r * v);
    return {wave * bracket, wave * (w / (r * v * v) - r * bracket), 0};
  }
};

}  // namespace breccia
