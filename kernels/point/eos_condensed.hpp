#pragma once
#include "point/eos_state.hpp"

namespace breccia {

// Solids and liquids whose pressure is linear in energy.

/// eq:eos-1  p = K mu + Gamma rho0 e, not below -spall
struct LinearEos {
  double rho0 = 0;       ///< kg/m3
  double bulk = 0;       ///< K, Pa
  double gruneisen = 0;  ///< Gamma, 1
  double spall = 1e300;  ///< largest tension, Pa

  KOKKOS_FUNCTION
  EosPoint at(double rho, double e) const {
    const double p_e = gruneisen * rho0;
    const double p = bulk * (rho / rho0 - 1) + p_e * e;
    if (p < -spall) return {-spall, bulk / rho0, 0};
    return {p, bulk / rho0, p_e};
  }
};

/// Mie and Grueneisen on the Hugoniot of a linear relation U_s = c0 + s u_p.
///
// eq:eos-2  p = pH (1 - Gamma eta / 2) + Gamma rho0 e, pH = rho0 c0^2 eta / (1 - s eta)^2, eta >= 0
// eq:eos-3  p = rho0 c0^2 eta + Gamma rho0 e, not below -spall, eta < 0
// Beyond 1 - s eta = 0.1 the Hugoniot goes on along its tangent: at full density it has a pole.
struct MieGruneisen {
  double rho0 = 0;       ///< kg/m3
  double c0 = 0;         ///< m/s
  double s = 0;          ///< 1
  double gruneisen = 0;  ///< Gamma, 1
  double spall = 1e300;  ///< largest tension, Pa

  KOKKOS_FUNCTION
  EosPoint at(double rho, double e) const {
    const double k = rho0 * c0 * c0, p_e = gruneisen * rho0, eta = 1 - rho0 / rho;
    const double eta_rho = rho0 / (rho * rho);
    if (eta < 0) {
      const double p = k * eta + p_e * e;
      return p < -spall ? EosPoint{-spall, k * eta_rho, 0} : EosPoint{p, k * eta_rho, p_e};
    }
    const double end = s > 0 ? 0.9 / s : 2.0, at = eta < end ? eta : end;
    const double d = 1 - s * at;
    const double slope = k * (1 + s * at) / (d * d * d);
    const double hugoniot = k * at / (d * d) + slope * (eta - at);
    const double factor = 1 - 0.5 * gruneisen * eta;
    const double p = hugoniot * factor + p_e * e;
    const double p_rho = (slope * factor - 0.5 * gruneisen * hugoniot) * eta_rho;
    return p < -spall ? EosPoint{-spall, p_rho, 0} : EosPoint{p, p_rho, p_e};
  }
};

}  // namespace breccia
