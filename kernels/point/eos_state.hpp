#pragma once
#include <Kokkos_Core.hpp>

namespace breccia {

// Equations of state: pressure p(rho, e) of a solid, a liquid or a gas (ALGORITHMS ).
//
// symbols  rho [kg/m3] density now   rho0 [kg/m3] at p = 0, e = 0   e [J/kg] energy per mass
//          p [Pa], compression > 0   mu = rho / rho0 - 1   eta = 1 - rho0 / rho
// page     docs/modules/eos.md

/// What an equation of state keeps per element.
struct EosState {
  double rho = 0;    ///< kg/m3
  double e = 0;      ///< J/kg
  double p = 0;      ///< Pa, compression positive
  double alpha = 1;  ///< distension of a porous material: solid density over density
};

/// Pressure and its derivatives at one state.
struct EosPoint {
  double p;      ///< Pa
  double p_rho;  ///< dp/drho at constant e, J/kg; of the curve without a tension limit
  double p_e;    ///< dp/de at constant rho, kg/m3; 0 where a tension limit holds
};

}  // namespace breccia
