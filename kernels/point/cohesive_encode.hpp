#pragma once
#include "point/cohesive.hpp"

namespace breccia {

/// Stands for a slip or an opening that no motion ever reaches.
inline constexpr double kNeverReached = 1e30;

/// Least lengths of softening, in peak openings and in elastic slips: keep the law single-valued
/// where a traction at insertion is far above the strength. Such a corner spends more than G.
inline constexpr double kLeastOpeningReach = 0.1;
inline constexpr double kLeastSlipReach = 1.5;

/// The state of a corner whose first traction is T0, so that insertion changes no force.
///
// symbols  as in cohesive.hpp; c_S, steepest as in softening.hpp   T0p = max(T0_n, 0)
// source   ALGORITHMS; c_0* here also covers shear under tension, where would start
//          above the envelope
template <int D, class Softening>
KOKKOS_FUNCTION
CohesiveState<D> encode(const CohesiveStrength& p, const CohesiveSprings& k, const Vec<D>& t0) {
  CohesiveState<D> s;
  double shear2 = 0;
  for (int i = 1; i < D; ++i) shear2 += t0[i] * t0[i];
  const double pulled = Kokkos::max(0.0, t0[0]);
  s.offset = t0[0] / k.normal;  // eq:cohesive-14  k_n d0 = T0_n, k_s xi_0 = T0_s
  for (int i = 0; i < D - 1; ++i) s.plastic[i] = -t0[i + 1] / k.shear;
  // eq:cohesive-15  f_t* = max(f_t, T0_n), c_0* = max(c_0, |T0_s| + mu_i T0_n)
  s.strength = Kokkos::max(p.tension, pulled);
  s.cohesion = Kokkos::max(p.cohesion, Kokkos::sqrt(shear2) + p.friction * t0[0]);
  // eq:cohesive-16  G_soft = G_I - (f_t*^2 - T0p^2)/(2 k_n) - c_S T0p f_t*/k_n,
  //                 w_f - w_p = G_soft/(c_S f_t*), s_f = G_II/(c_S c_0*)
  const double peak_opening = s.strength / k.normal;
  const double soft = p.energy_tension -
                      0.5 * (s.strength * peak_opening - pulled * pulled / k.normal) -
                      Softening::area * pulled * peak_opening;
  s.opening_reach = s.strength > 0 ? Kokkos::max(soft / (Softening::area * s.strength),
                                                 kLeastOpeningReach * peak_opening)
                                   : kNeverReached;
  s.slip_reach = s.cohesion > 0
                     ? Kokkos::max(p.energy_shear / (Softening::area * s.cohesion),
                                   kLeastSlipReach * Softening::steepest * s.cohesion / k.shear)
                     : kNeverReached;
  s.opening = Kokkos::max(0.0, s.offset);
  s.slip = 0;
  s.damage = s.strength > 0 || s.cohesion > 0 ? 0.0 : 1.0;
  s.jump = Vec<D>::zero();
  s.viscous = Vec<D>::zero();
  return s;
}

/// Energy of the slip that a corner is born with, J/m2: it was not put in by any motion, so the
/// ledger takes it off again.
template <int D>
KOKKOS_FUNCTION
double encoded_energy(const CohesiveSprings& k, const CohesiveState<D>& born) {
  return 0.5 * k.shear * norm2(born.plastic);
}

}  // namespace breccia
