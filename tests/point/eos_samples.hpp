#pragma once
#include "point/eos.hpp"

#include <cmath>
#include <vector>

// Materials of the tests of equations of state.
namespace breccia::eos_samples {

inline Eos finished(Eos eos) {
  const EosPoint q = eos.at(eos.rho0, eos.energy0, eos.pores.alpha);
  eos.modulus0 = eos.rho0 * q.p_rho + q.p / eos.rho0 * q.p_e;
  return eos;
}

inline Eos mie_gruneisen(double rho0, double c0, double s, double gruneisen) {
  Eos eos;
  eos.kind = EosKind::mie_gruneisen;
  eos.rho0 = rho0;
  eos.mie_gruneisen = {rho0, c0, s, gruneisen, 1e300};
  return finished(eos);
}

/// Marsh, LASL Shock Hugoniot Data (1980): U_s = 3940 m/s + 1.489 u_p at 8930 kg/m3.
inline Eos copper() {
  return mie_gruneisen(8930, 3940, 1.489, 1.99);
}

/// Melosh, Impact Cratering (1989), table AII.2: U_s = 2600 m/s + 1.62 u_p at 2860 kg/m3.
inline Eos basalt() {
  return mie_gruneisen(2860, 2600, 1.62, 1.0);
}

inline Eos linear() {
  Eos eos;
  eos.rho0 = 2650;
  eos.linear = {2650, 40e9, 1.5, 1e300};
  return finished(eos);
}

inline Eos tillotson(double rho0, double a, double b, double bulk, double bulk2, double e0,
                     double e_iv, double e_cv) {
  Eos eos;
  eos.kind = EosKind::tillotson;
  eos.rho0 = rho0;
  eos.tillotson = {rho0, a, b, bulk, bulk2, 5, 5, e0, e_iv, e_cv, 1e300};
  return finished(eos);
}

// V-030.
inline Eos aluminium() {
  return tillotson(2700, .5, 1.63, 75.2e9, 65e9, 5e6, 3e6, 13.9e6);
}
inline Eos granite() {
  return tillotson(2680, .5, 1.3, 18e9, 18e9, 16e6, 3.5e6, 18e6);
}
inline Eos iron() {
  return tillotson(7800, .5, 1.5, 128e9, 105e9, 9.5e6, 2.4e6, 8.67e6);
}

inline Eos air() {
  Eos eos;
  eos.kind = EosKind::ideal_gas;
  eos.rho0 = 1.2;
  eos.ideal_gas.gamma = 1.4;
  eos.energy0 = 1e5 / (0.4 * 1.2);
  return finished(eos);
}

///
inline Eos tnt() {
  Eos eos;
  eos.kind = EosKind::jwl;
  eos.rho0 = 1630;
  eos.jwl = {1630, 371.2e9, 3.231e9, 4.15, 0.95, 0.30};
  eos.energy0 = 7.0e9 / 1630;
  return finished(eos);
}

/// A rock with a fifth of pores.
inline Eos tuff() {
  Eos eos = mie_gruneisen(2650, 3500, 1.4, 0.8);
  eos.pores = {1.25, 20e6, 1.5e9};
  eos.rho0 /= 1.25;
  return finished(eos);
}

inline std::vector<Eos> all() {
  return {linear(), copper(), basalt(), aluminium(), granite(), iron(), air(), tnt(), tuff()};
}

}  // namespace breccia::eos_samples
