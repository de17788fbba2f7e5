#pragma once
#include "point/inelastic.hpp"
#include "point/plastic_root.hpp"

namespace breccia {

/// Brittle damage of rock and ceramics after Johnson and Holmquist: a strength that depends on
/// pressure and falls from that of the intact to that of the crushed material. It is the worked
/// example of docs/extend/material.md.
///
// symbols  P = -sm [Pa], compression > 0   q = sqrt(3 J2) [Pa]   D [1] damage, 0 intact ... 1
//          ep [1] plastic strain, rate [1/s] of it   P* = P / p_hel, T* = tension / p_hel
//          ev [1] plastic volume strain of the tension limit
// eq:plastic-18  Yi = s_hel A (P* + T*)^N R,  Yf = s_hel min(B max(0, P*)^M R, most)
// eq:plastic-19  q <= Yi - D (Yi - Yf),  R = 1 + C ln max(1, rate / rate0)
// eq:plastic-20  P >= -tension (1 - D)
// eq:plastic-21  dD = (dep + dev) / max(least, D1 (P* + T*)^D2)
// source   Johnson and Holmquist, AIP Conf. Proc. 309 (1994) 981; without bulking of what is
//          crushed. `least` keeps a break in tension from being a jump.
struct Holmquist {
  static constexpr bool kRadial = true;
  static constexpr int kHistory = 2;
  static constexpr std::array<HistoryEntry, 2> kHistoryEntries{
      kPlasticStrain, HistoryEntry{"bulk_damage", "1", "damage of the material, 1: crushed"}};
  double bulk = 0, shear = 0;                 ///< Pa
  double hel_stress = 0;                      ///< s_hel, Pa: q at the Hugoniot elastic limit
  double hel_pressure = 0;                    ///< p_hel, Pa
  double intact = 0, intact_power = 0;        ///< A, N
  double fractured = 0, fractured_power = 0;  ///< B, M
  double fractured_most = 1e300;              ///< in units of s_hel
  double rate_strength = 0;                   ///< C
  double rate_reference = 1;                  ///< rate0, 1/s
  double tension = 0;                         ///< T, Pa
  double ductility = 0, ductility_power = 0;  ///< D1, D2
  double ductility_least = 1e-3;              ///< plastic strain

  /// Strengths of the intact and of the crushed material at a rate factor, Pa.
  struct Strength {
    double intact, fractured;
    KOKKOS_INLINE_FUNCTION
    double at(double damage) const { return intact - minimum(1.0, damage) * (intact - fractured); }
  };
  KOKKOS_INLINE_FUNCTION
  Strength strength(double pressure, double rate_factor) const {
    const double p = pressure / hel_pressure, with_tension = p + tension / hel_pressure;
    const double yi =
        with_tension > 0 ? intact * Kokkos::pow(with_tension, intact_power) * rate_factor : 0;
    const double yf =
        p > 0 ? minimum(fractured * Kokkos::pow(p, fractured_power) * rate_factor, fractured_most)
              : 0;
    return {hel_stress * yi, hel_stress * minimum(yi, yf)};
  }
  KOKKOS_INLINE_FUNCTION
  double failure_strain(double pressure) const {
    const double p = maximum(0.0, (pressure + tension) / hel_pressure);
    return maximum(ductility_least, ductility * Kokkos::pow(p, ductility_power));
  }
  KOKKOS_INLINE_FUNCTION
  Residual rate_factor(double rate) const {
    return rate > rate_reference ? Residual{1 + rate_strength * Kokkos::log(rate / rate_reference),
                                            rate_strength / rate}
                                 : Residual{1, 0};
  }
  /// Largest stress in simple tension of the intact material, Pa: q = Yi at P = -q / 3.
  KOKKOS_INLINE_FUNCTION
  double uniaxial_tension() const {
    return bracketed_root(
        [&](double q) {
          return Residual{strength(-q / 3, 1).intact - q, 0};
        },
        0.0, 3 * tension);
  }

  template <class R>
  KOKKOS_FUNCTION
  R beyond(const R& mean, const R& root_j2, const R* history) const {
    const R q = R(1.7320508075688773) * root_j2;
    double pressure[lanes<R>()], damage[lanes<R>()], yield[lanes<R>()];
    store(R(0) - mean, pressure);
    store(history[1], damage);
    for (int l = 0; l < lanes<R>(); ++l) yield[l] = strength(pressure[l], 1).at(damage[l]);
    const R cut = mean - R(tension) * (R(1) - history[1]);
    return maximum(q - load<R>(yield), cut);
  }

  KOKKOS_FUNCTION
  double update(double (&strain)[3], double (&history)[kMaxHistory], double dt) const;

 private:
  /// Flow at a pressure: q and damage become those after it. Returns the growth of ep.
  KOKKOS_INLINE_FUNCTION
  double flow(double pressure, double dt, double& q, double& damage, double& work) const;
};
static_assert(InelasticLaw<Holmquist>);

KOKKOS_INLINE_FUNCTION
double Holmquist::flow(double pressure, double dt, double& q, double& damage, double& work) const {
  const Strength still = strength(pressure, 1);
  const double before = damage;
  if (!(q > still.at(before))) return 0;
  const double most = q / (3 * shear), per_time = dt > 0 ? 1 / dt : 0;
  const double per_strain = 1 / failure_strain(pressure);
  const auto residual = [&](double dg) {  // eq:plastic-19 with D of eq:plastic-21
    const Residual r = rate_factor(dg * per_time);
    const Strength y = strength(pressure, r.value);
    const double d = before + dg * per_strain, y_r = still.at(d) * r.slope * per_time;
    const double y_d = d < 1 ? (y.intact - y.fractured) * per_strain : 0;
    return Residual{q - 3 * shear * dg - y.at(d), -3 * shear - y_r + y_d};
  };
  const double dg = bracketed_root(residual, 0.0, most);
  const double start = strength(pressure, rate_factor(dg * per_time).value).at(before);
  q -= 3 * shear * dg;
  damage = minimum(1.0, before + dg * per_strain);
  work += 0.5 * dg * (q + minimum(start, q + 3 * shear * dg));
  return dg;
}

KOKKOS_INLINE_FUNCTION
double Holmquist::update(double (&strain)[3], double (&history)[kMaxHistory], double dt) const {
  const PrincipalStress trial = PrincipalStress::of(strain, bulk, shear);
  const double q0 = 1.7320508075688773 * trial.root_j2(), mean0 = trial.mean();
  double q = q0, mean = mean0, damage = history[1], work = 0;
  const double limit0 = tension * (1 - damage);
  double grown = flow(-minimum(mean, limit0), dt, q, damage, work);
  if (mean > tension * (1 - damage)) {  // eq:plastic-20 with D of eq:plastic-21
    const double per_strain = 1 / failure_strain(-tension), over = mean - tension * (1 - damage);
    const double stiff = bulk - tension * per_strain;
    double volume = stiff > 0 ? over / stiff : mean / bulk;
    if (damage + volume * per_strain > 1) volume = mean / bulk;
    damage = minimum(1.0, damage + volume * per_strain);
    mean = tension * (1 - damage);
    work += 0.5 * (mean + minimum(limit0, mean0)) * (mean0 - mean) / bulk;
    const double most = strength(-mean, 1).at(damage);  // what is left at this damage
    if (q > most) {
      work += 0.5 * (q + most) * (q - most) / (3 * shear);
      grown += (q - most) / (3 * shear);
      q = most;
    }
    grown += (mean0 - mean) / bulk;
  }
  if (q == q0 && mean == mean0) return 0;
  set_invariants(strain, q0 > 0 ? q / q0 : 1, mean / bulk);
  history[0] += grown;
  history[1] = damage;
  return work;
}

}  // namespace breccia
