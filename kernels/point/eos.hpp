#pragma once
#include "point/eos_condensed.hpp"

namespace breccia {

enum class EosKind { linear, mie_gruneisen };

/// One equation of state: which, and its numbers.
struct Eos {
  EosKind kind = EosKind::linear;
  double rho0 = 0;      ///< kg/m3, of the material at rest
  double energy0 = 0;   ///< J/kg, at rest
  double modulus0 = 0;  ///< Pa, rho c^2 at rest, above 0
  LinearEos linear;
  MieGruneisen mie_gruneisen;

  /// The bulk modulus is never below this share of the one at rest, so that time steps and
  /// viscosities stay finite where a curve is flat or unstable.
  static constexpr double kFloor = 1e-3;

  KOKKOS_FUNCTION
  EosPoint at(double rho, double e) const {
    switch (kind) {
      case EosKind::linear:
        return linear.at(rho, e);
      case EosKind::mie_gruneisen:
        return mie_gruneisen.at(rho, e);
    }
    return {0, 0, 0};
  }

  KOKKOS_FUNCTION
  double pressure(double rho, double e) const { return at(rho, e).p; }

  /// eq:eos-4  rho c^2 = rho dp/drho|e + p / rho dp/de, at least kFloor modulus0
  KOKKOS_FUNCTION
  double bulk_modulus(double rho, double e) const {
    const EosPoint q = at(rho, e);
    const double k = rho * q.p_rho + q.p / rho * q.p_e;
    return k > kFloor * modulus0 ? k : kFloor * modulus0;
  }

  /// The material at rest.
  KOKKOS_FUNCTION
  EosState start() const { return {rho0, energy0, pressure(rho0, energy0), 1}; }

  /// eq:eos-5  e' = e + work - (p + p') / 2 (1 / rho' - 1 / rho), p' = p(rho', e')
  /// `work` is what else heats in this step: plastic flow, viscosity, J/kg. By Newton's method:
  /// one iteration where p is linear in e, two across a tension limit.
  KOKKOS_FUNCTION
  void advance(EosState& state, double rho, double work) const {
    const double half = 0.5 * (1 / rho - 1 / state.rho);
    const double fixed = state.e + work - half * state.p;
    double e = state.e;
    EosPoint q = at(rho, e);
    for (int i = 0; i < kIterations; ++i) {
      const double slope = 1 + half * q.p_e;
      const double next = e - (e - fixed + half * q.p) / (slope > 0.1 ? slope : 0.1);
      const double change = next - e;
      e = next;
      q = at(rho, e);
      if (Kokkos::abs(change) <= 1e-15 * Kokkos::abs(e)) break;
    }
    state = {rho, e, q.p, state.alpha};
  }

  static constexpr int kIterations = 20;
};

}  // namespace breccia
