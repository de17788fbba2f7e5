#pragma once
#include "point/inelastic.hpp"
#include "point/plastic_root.hpp"

namespace breccia {

enum class RateFactor { none, johnson_cook, perzyna };

/// Von Mises plasticity whose yield stress depends on plastic strain, its rate and temperature
/// (ALGORITHMS A-1.7a).
///
// symbols  ep [1] plastic strain, rate [1/s] of it   T* [1] = (T - room) / (melting - room), 0...1
//          q = sqrt(3 J2) [Pa]   dg [1] growth of ep in this step
// eq:plastic-4  sy = (A + B ep^n) R(rate) (1 - T*^m)
// eq:plastic-5  R = 1 + C ln max(1, rate / rate0) (Johnson, Cook), 1 + (rate / rate0)^C (Perzyna)
// eq:plastic-6  q_trial - 3 G dg = sy(ep + dg, dg / dt, T)
// eq:plastic-7  T += chi (work of plastic flow) / (rho0 c_v)
// Temperature lags by a step, which leaves one equation in dg with a bracketed root.
// source   Johnson and Cook, 7th Int. Symp. Ballistics (1983); Perzyna, Adv. Appl. Mech. 9 (1966)
struct JohnsonCook {
  static constexpr bool kRadial = true;
  static constexpr int kHistory = 3;
  static constexpr std::array<HistoryEntry, 3> kHistoryEntries{
      kPlasticStrain, HistoryEntry{"temperature_rise", "K", "rise of temperature by plastic flow"},
      HistoryEntry{"yield_rise", "Pa", "static yield stress now above the one at rest"}};
  double bulk = 0, shear = 0;  ///< Pa
  double yield = 0;            ///< A, Pa
  double hardening = 0;        ///< B, Pa
  double exponent = 1;         ///< n
  RateFactor rate_law = RateFactor::none;
  double rate_strength = 0;   ///< C
  double rate_reference = 1;  ///< rate0, 1/s
  double start = 0;           ///< T at rest minus room, K
  double melting = 0;         ///< melting temperature minus room, K; 0: strength ignores heat
  double softening = 1;       ///< m
  double heat = 0;            ///< chi / (rho0 c_v), K m3/J

  /// 1 - T*^m
  KOKKOS_INLINE_FUNCTION
  double thermal(double rise) const {
    if (!(melting > 0)) return 1;
    const double t = (start + rise) / melting;
    if (t <= 0) return 1;
    return t < 1 ? 1 - Kokkos::pow(t, softening) : 0;
  }
  /// A + B ep^n with its slope
  KOKKOS_INLINE_FUNCTION
  Residual hardened(double ep) const {
    if (exponent == 1) return {yield + hardening * ep, hardening};
    if (!(ep > 0)) return {yield, 0};
    const double power = hardening * Kokkos::pow(ep, exponent);
    return {yield + power, exponent * power / ep};
  }
  /// eq:plastic-5 with its slope
  KOKKOS_INLINE_FUNCTION
  Residual rate_factor(double rate) const {
    const double x = rate / rate_reference;
    if (rate_law == RateFactor::johnson_cook) {
      return x > 1 ? Residual{1 + rate_strength * Kokkos::log(x), rate_strength / rate}
                   : Residual{1, 0};
    }
    if (rate_law == RateFactor::perzyna && x > 0) {
      const double power = Kokkos::pow(x, rate_strength);
      return {1 + power, rate_strength * power / rate};
    }
    return {1, 0};
  }

  template <class R>
  KOKKOS_FUNCTION
  R beyond(const R& /*mean*/, const R& root_j2, const R* history) const {
    return R(1.7320508075688773) * root_j2 - (R(yield * thermal(0)) + history[2]);
  }

  KOKKOS_FUNCTION
  double update(double (&strain)[3], double (&history)[kMaxHistory], double dt) const {
    const double q = 1.7320508075688773 * PrincipalStress::of(strain, bulk, shear).root_j2();
    const double ep = history[0], soft = thermal(history[1]), start_stress = hardened(ep).value;
    if (!(q > start_stress * soft)) return 0;
    const double most = q / (3 * shear), per_time = dt > 0 ? 1 / dt : 0;
    const auto residual = [&](double dg) {  // eq:plastic-6
      const Residual h = hardened(ep + dg), r = rate_factor(dg * per_time);
      return Residual{q - 3 * shear * dg - h.value * r.value * soft,
                      -3 * shear - (h.slope * r.value + h.value * r.slope * per_time) * soft};
    };
    const double dg = bracketed_root(residual, 0.0, most);
    set_invariants(strain, 1 - dg / most, strain[0] + strain[1] + strain[2]);
    const double left = q - 3 * shear * dg;
    const double work = 0.5 * dg * (left + start_stress * rate_factor(dg * per_time).value * soft);
    history[0] += dg;
    history[1] += heat * work;
    history[2] = hardened(history[0]).value * thermal(history[1]) - yield * thermal(0);
    return work;
  }
};
static_assert(InelasticLaw<JohnsonCook>);

}  // namespace breccia
