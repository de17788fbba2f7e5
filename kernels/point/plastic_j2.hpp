#pragma once
#include "point/inelastic.hpp"

namespace breccia {

/// Von Mises plasticity, perfect or with linear isotropic hardening (ALGORITHMS A-1.7a).
///
// symbols  q = sqrt(3 J2) [Pa]   sy = yield + H ep [Pa]   ep [1] accumulated plastic strain
// eq:plastic-2  q <= yield + H ep
// eq:plastic-3  dg = (q_trial - sy) / (3 G + H), s = s_trial (1 - 3 G dg / q_trial), ep += dg
// source   Wilkins 1964; Simo and Hughes, Computational Inelasticity (1998), box 3.1
struct J2 {
  static constexpr bool kRadial = true;
  static constexpr int kHistory = 1;
  static constexpr std::array<HistoryEntry, 1> kHistoryEntries{kPlasticStrain};
  double bulk = 0, shear = 0;  ///< Pa
  double yield = 0;            ///< Pa, above 0
  double hardening = 0;        ///< H, Pa; above -3 G

  template <class R>
  KOKKOS_FUNCTION
  R beyond(const R& /*mean*/, const R& root_j2, const R* history) const {
    return R(1.7320508075688773) * root_j2 - (R(yield) + R(hardening) * history[0]);
  }

  /// `update` for a pack: the factor of the deviator e' of this e' : e'.
  template <class R>
  KOKKOS_FUNCTION
  R radial(const R& squared_deviator, R (&history)[kMaxHistory], R& work) const {
    const R q = R(shear * 2.449489742783178) * square_root(squared_deviator);
    const R strength = maximum(R(0), R(yield) + R(hardening) * history[0]);
    const R most = q * R(1 / (3 * shear));
    const R step = minimum(most, maximum(R(0), (q - strength) * R(1 / (3 * shear + hardening))));
    const R left = q - R(3 * shear) * step;
    history[0] = history[0] + step;
    work = R(0.5) * (strength + left) * step;
    return left / maximum(q, R(1e-300));
  }

  KOKKOS_FUNCTION
  double update(double (&strain)[3], double (&history)[kMaxHistory], double /*dt*/) const {
    const double q = 1.7320508075688773 * PrincipalStress::of(strain, bulk, shear).root_j2();
    double strength = yield + hardening * history[0];
    if (strength < 0) strength = 0;  // softened away
    if (!(q > strength)) return 0;
    double step = (q - strength) / (3 * shear + hardening);
    if (step > q / (3 * shear)) step = q / (3 * shear);
    const double left = q - 3 * shear * step;
    set_invariants(strain, left / q, strain[0] + strain[1] + strain[2]);
    history[0] += step;
    return 0.5 * (strength + left) * step;  // strength is linear in the step: exact
  }
};
static_assert(InelasticLaw<J2>);

}  // namespace breccia
