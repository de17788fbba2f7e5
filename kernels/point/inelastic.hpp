#pragma once
#include "base/pack.hpp"

#include <Kokkos_Core.hpp>

#include <array>
#include <concepts>
#include <type_traits>

namespace breccia {

// What an inelastic law of a solid is.
//
// The kinematics are multiplicative in logarithmic strain (ALGORITHMS ): an isotropic
// law sees the three principal elastic Hencky strains and its own history, nothing else. In these
// variables its return map is that of small strains, and pressure does not disturb the volume.
//
// symbols  e_i [1] principal elastic Hencky strain   tau_i = J sigma_i [Pa] Kirchhoff stress
//          K, G [Pa] bulk and shear modulus   sm = (tau_1 + tau_2 + tau_3) / 3 [Pa], tension > 0
//          J2 = s : s / 2 with s = tau - sm 1 [Pa2]
// eq:plastic-1  tau_i = (K - 2 G / 3) (e_1 + e_2 + e_3) + 2 G e_i
// page     docs/modules/plasticity.md, docs/extend/material.md
//
// A law is a trivially copyable struct with
//   static constexpr int kHistory        numbers kept per point; all are 0 at the start, the
//                                        first is the accumulated plastic strain
//   static constexpr std::array<HistoryEntry, kHistory> kHistoryEntries    for pictures
//   double bulk, shear                   Pa
//   R beyond(mean, root_j2, history)     for R a number or a pack: an upper bound, cheap, that is
//                                        above 0 wherever the trial state (sm, sqrt(J2)) may lie
//                                        outside the elastic domain
//   double update(strain, history, dt)   returns a trial state to the elastic domain
// `update` gets the trial e_i in any order and puts the elastic ones in their places; it moves
// the history on by dt [s] and gives the plastic work per reference volume [J/m3], never negative.
// It is called where `beyond` is above 0; at every point where the law says kAlwaysUpdate = true (a
// history that moves in the elastic domain too).
// A law that scales the deviator and changes the trace, by what these two say, declares
// kRadial = true and is spared principal axes (point/radial_return.hpp).
// With an equation of state the caller chooses the trial strain such that K (e_1 + e_2 + e_3) is
// minus the pressure of that equation, and afterwards takes the deviator only.

inline constexpr int kMaxHistory = 4;

/// Name, unit and meaning of one number of a law's history.
struct HistoryEntry {
  const char* name;
  const char* unit;
  const char* text;
};

inline constexpr HistoryEntry kPlasticStrain{"plastic_strain", "1", "accumulated plastic strain"};

template <class L>
concept InelasticLaw = std::is_trivially_copyable_v<L> && L::kHistory >= 0 &&
                       L::kHistory <= kMaxHistory&& L::kHistoryEntries.size() ==
                           static_cast<std::size_t>(L::kHistory) &&
                       requires(const L& law, double x, const double* history, double (&strain)[3],
                                double (&memory)[kMaxHistory]) {
  { law.bulk } -> std::convertible_to<double>;
  { law.shear } -> std::convertible_to<double>;
  { law.beyond(x, x, history) } -> std::same_as<double>;
  { law.update(strain, memory, x) } -> std::same_as<double>;
};

/// A law that asks to be called for points in the elastic domain too.
template <class L>
inline constexpr bool kAlwaysUpdates = requires {
  requires L::kAlwaysUpdate;
};

/// eq:plastic-1 and its inverse.
struct PrincipalStress {
  double tau[3];  ///< Pa

  KOKKOS_INLINE_FUNCTION
  static PrincipalStress of(const double (&e)[3], double bulk, double shear) {
    const double p = (bulk - 2 * shear / 3) * (e[0] + e[1] + e[2]);
    return {{p + 2 * shear * e[0], p + 2 * shear * e[1], p + 2 * shear * e[2]}};
  }
  KOKKOS_INLINE_FUNCTION
  double mean() const { return (tau[0] + tau[1] + tau[2]) / 3; }
  /// sqrt(J2), from differences so that a large pressure costs no digits.
  KOKKOS_INLINE_FUNCTION
  double root_j2() const {
    const double a = tau[0] - tau[1], b = tau[1] - tau[2], c = tau[2] - tau[0];
    return Kokkos::sqrt((a * a + b * b + c * c) / 6);
  }
  KOKKOS_INLINE_FUNCTION
  void to_strain(double bulk, double shear, double (&e)[3]) const {
    const double m = mean();
    for (int i = 0; i < 3; ++i) e[i] = m / (3 * bulk) + (tau[i] - m) / (2 * shear);
  }
};

/// Scales the deviator of a strain and sets its trace.
KOKKOS_INLINE_FUNCTION
void set_invariants(double (&e)[3], double deviator_factor, double new_trace) {
  const double mean = (e[0] + e[1] + e[2]) / 3;
  for (int i = 0; i < 3; ++i) e[i] = deviator_factor * (e[i] - mean) + new_trace / 3;
}

/// Elastic for ever: the law of a material without plasticity.
struct NoYield {
  static constexpr int kHistory = 0;
  static constexpr std::array<HistoryEntry, 0> kHistoryEntries{};
  double bulk = 0, shear = 0;  ///< Pa

  template <class R>
  KOKKOS_FUNCTION
  R beyond(const R& /*mean*/, const R& /*root_j2*/, const R* /*history*/) const { return R(-1); }
  KOKKOS_FUNCTION
  double update(double (&/*strain*/)[3], double (&/*history*/)[kMaxHistory], double /*dt*/) const {
    return 0;
  }
};
static_assert(InelasticLaw<NoYield>);

}  // namespace breccia
