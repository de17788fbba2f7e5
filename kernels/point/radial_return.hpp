#pragma once
#include "point/full_sym.hpp"
#include "point/inelastic.hpp"

namespace breccia {

// Return of laws that only scale the deviator of the trial strain and change its trace: they need
// no principal axes, and what becomes of the plastic metric is a product with a small exponential.

/// A law whose return is radial says kRadial = true: what `update` does to the strain follows from
/// trace and size of the deviator alone.
template <class L>
inline constexpr bool kIsRadial = requires {
  requires L::kRadial;
};

/// A radial law that keeps the trace and has a closed form for packs: radial(e' : e', history,
/// work) gives the factor and moves the history on; where it does not flow, it changes nothing.
template <class L, class R>
inline constexpr bool kHasClosedForm = requires(const L& law, R value, R (&history)[kMaxHistory]) {
  {law.radial(value, history, value)};
};

/// What a radial return does: e_i := m' + factor (e_i - m), with 3 m' = trace + growth.
struct RadialReturn {
  double factor = 1, growth = 0;
  double work = 0;  ///< plastic, per reference volume, J/m3

  /// Asks a law with a strain of this trace and this e' : e', whatever its third invariant.
  template <class Law>
  KOKKOS_FUNCTION
  static RadialReturn of(const Law& law, double trace, double squared_deviator,
                         double (&history)[kMaxHistory], double dt) {
    const double mean = trace / 3, size = Kokkos::sqrt(0.5 * squared_deviator);
    double strain[3] = {mean + size, mean - size, mean};
    RadialReturn r;
    r.work = law.update(strain, history, dt);
    if (size > 0) r.factor = (strain[0] - strain[1]) / (2 * size);
    r.growth = strain[0] + strain[1] + strain[2] - trace;
    return r;
  }
};

/// Largest size of a strain whose exponential the series gives to round-off.
inline constexpr double kSmallExponent = 0.02;

/// exp(a) for |a| below kSmallExponent, by Horner's rule: the first term left out is below
/// 0.02^8 / 8! = 6e-19.
template <int D, class R>
KOKKOS_FUNCTION
Sym<D, R> small_exponential(const Sym<D, R>& a) {
  Sym<D, R> e = a * R(1.0 / 7);
  for (int k = 6; k >= 1; --k) {
    for (int i = 0; i < D; ++i) e.s[i] = e.s[i] + R(1);
    e = commuting_product(a, e) * R(1.0 / k);
  }
  for (int i = 0; i < D; ++i) e.s[i] = e.s[i] + R(1);
  return e;
}
template <class R>
KOKKOS_FUNCTION
R small_exponential(const R& a) {
  R e = R(1) + a * R(1.0 / 7);
  for (int k = 6; k >= 1; --k) e = R(1) + a * e * R(1.0 / k);
  return e;
}

}  // namespace breccia
