#pragma once
#include "loops/element_force.hpp"
#include "loops/element_group.hpp"

namespace breccia {

/// What the loop is asked to do besides forces, known when the code is compiled (the simplest
/// elements) or when it runs.
template <bool kDamped, bool kWatched, bool kStored>
struct FixedWishes {
  static constexpr bool damped = kDamped, watched = kWatched, stored = kStored, shocked = false,
                        shared = false, paced = false;
};
struct Wishes {
  bool damped, watched, stored;
  bool shocked;  ///< bulk viscosity
  bool shared;   ///< elements carry a share of their stress
  bool paced;    ///< the time step wants to know moduli
};

template <int D>
Wishes wishes_of(const ElementForceIn<D>& in, const ElementForceOut<D>& out) {
  return {in.damping > 0,           in.watch.on,
          out.stress.extent(0) > 0, in.shock_quadratic > 0 || in.shock_linear > 0,
          in.share.extent(0) > 0,   out.modulus.extent(0) > 0};
}

/// Shape of one sub-element now.
template <int D, class R>
struct SubShape {
  Mat<D, R> f;          ///< deformation gradient, columns along the material axes
  Mat<D, R> cofactors;  ///< of the edge matrix
  R det;                ///< of the edge matrix: D! times the volume
  R jacobian;
  R shift;  ///< what the shared dilation adds to each normal strain; in single precision itself
  R share;  ///< of its stress that the element carries
  R work;   ///< of plastic flow in this step per reference volume, J/m3
  R shock;  ///< bulk viscosity, Pa

  // In single precision only:
  Sym<D, R> growth;  ///< C - 1, along the material axes
  R dilation;        ///< J - 1
};

/// Volume of a group, times D! and over the thickness, and what bulk viscosity does to it.
template <class R>
struct GroupVolume {
  R now, original;
  R growth;      ///< now / original - 1, in single precision only
  R shock_work;  ///< heat of bulk viscosity in this step per reference volume, J/m3
};

/// eq:solid-16  tau = dev tau + (J / Jbar) mbar 1, mbar = sum V0 m / V0 with m the mean stress:
/// with eq:solid-15 the exact derivative of the group's energy sum V0 w(eps).
template <int D, int Group, class R>
KOKKOS_FORCEINLINE_FUNCTION
void share_mean(const GroupVolume<R>& volume, const SubShape<D, R> (&shape)[Group],
                FullSym<D, R> (&tau)[Group]) {
  R mean[Group], sum = R(0);
  for (int s = 0; s < Group; ++s) {
    mean[s] = trace(tau[s]) * R(1.0 / 3);
    sum = sum + mean[s] * shape[s].det / shape[s].jacobian;
  }
  const R shared = sum / volume.now;
  for (int s = 0; s < Group; ++s) tau[s].add_identity(shape[s].jacobian * shared - mean[s]);
}

/// Rounds numbers to a common grain of some 2^-22 of the largest, so that their sum is exact: an
/// element of single precision pushes itself by nothing at all, and momentum is kept to the
/// round-off of double. Adding and taking away four times the largest leaves multiples of one unit
/// that three of them do not outgrow.
template <int D, class T>
KOKKOS_FORCEINLINE_FUNCTION
void round_together(T (&a)[D]) {
  T largest = absolute(a[0]);
  for (int i = 1; i < D; ++i) largest = maximum(largest, absolute(a[i]));
  const T anchor = largest * T(4);
  for (int i = 0; i < D; ++i) {
    const T sum = a[i] + anchor;
    a[i] = sum - anchor;
  }
}

/// Adds what each lane stores, J.
template <class Lanes, class R>
KOKKOS_FORCEINLINE_FUNCTION
void book_stored(const Lanes& lanes, const R& energy, Sums<element_sum::count>& sums) {
  double e[Lanes::W];
  store(energy, e);
  for (int l = 0; l < lanes.count(); ++l)
    if (lanes.counts(l)) sums[element_sum::stored] += e[l];
}

}  // namespace breccia
