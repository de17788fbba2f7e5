#pragma once
#include "point/inelastic.hpp"

namespace breccia {

/// A law of rock whose strengths rise with the rate of strain (ALGORITHMS A-1.7d).
///
// symbols  rate [1/s] of the size of the elastic trial strain, sqrt(e : e), filtered
// eq:plastic-16  strengths times max(1, (rate / rate_c)^n)
// eq:plastic-17  rate += w (|size_trial - size| / dt - rate), w = min(1/20, dt / time)
// The rate of one step is noise fed back; the filter spans twenty steps or more. In simple tension
// or compression the size grows 1 to 1.2 times as fast as the axial strain.
template <class Law>
struct RateDependent : Law {
  static_assert(Law::kHistory == 1);
  static constexpr int kHistory = 3;
  static constexpr bool kAlwaysUpdate = true;  ///< the rate is to be known before anything yields
  static constexpr std::array<HistoryEntry, 3> kHistoryEntries{
      kPlasticStrain, HistoryEntry{"strain_size", "1", "size of the elastic strain"},
      HistoryEntry{"strain_rate", "1/s", "filtered rate of strain"}};
  double rate_reference = 1;  ///< rate_c, 1/s
  double rate_exponent = 0;   ///< n
  double filter_time = 0;     ///< s; 0: twenty steps

  /// Everywhere, see kAlwaysUpdate.
  template <class R>
  KOKKOS_FUNCTION
  R beyond(const R& /*mean*/, const R& /*root_j2*/, const R* /*history*/) const { return R(1); }

  KOKKOS_FUNCTION
  double update(double (&strain)[3], double (&history)[kMaxHistory], double dt) const {
    if (dt > 0) {
      const double now = Kokkos::abs(size(strain) - history[1]) / dt;
      const double w = filter_time > 20 * dt ? dt / filter_time : 0.05;
      history[2] += w * (now - history[2]);
    }
    Law law = *this;
    law.strength_factor = factor(history[2]);
    const double work = law.update(strain, history, dt);
    history[1] = size(strain);
    return work;
  }

  KOKKOS_INLINE_FUNCTION
  double factor(double rate) const {
    return rate > rate_reference ? Kokkos::pow(rate / rate_reference, rate_exponent) : 1;
  }
  KOKKOS_INLINE_FUNCTION
  static double size(const double (&e)[3]) {
    return Kokkos::sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
  }
};

}  // namespace breccia
