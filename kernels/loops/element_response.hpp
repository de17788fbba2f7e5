#pragma once
#include "loops/element_launch.hpp"
#include "loops/element_laws.hpp"
#include "point/hencky_stress.hpp"

namespace breccia {

/// Logarithmic strain of a sub-element with the dilation that its group shares.
template <int D, class R, class Lanes>
KOKKOS_FORCEINLINE_FUNCTION
FullSym<D, R> strain_of(const Sym<D, R>& metric, const R& jacobian, const R& shift, const Lanes&) {
  FullSym<D, R> eps{hencky_strain(metric, jacobian), R(0)};
  if constexpr (Lanes::kGroup > 1) eps.add_identity(shift);
  return eps;
}

/// In single precision: ln U along material axes from C - 1, and its trace, which is known better
/// than the sum of three numbers would tell (what is nearly incompressible makes much of it).
template <int D, class R, class Lanes>
KOKKOS_FORCEINLINE_FUNCTION
FullSym<D, R> strain_of_growth(const SubShape<D, R>& shape, bool flat, const Lanes&, R& dilation) {
  FullSym<D, R> eps{hencky_strain_of_growth(shape.growth, shape.dilation), R(0)};
  dilation = trace(eps);
  if ((D == 2 && Lanes::kGroup == 1) || flat) return eps;
  dilation = Lanes::kGroup > 1 ? shape.shift : log_of_one_plus(shape.dilation);
  eps.add_identity((dilation - trace(eps)) * R(1.0 / 3));
  return eps;
}

/// eq:solid-20  F^-T t F^T, symmetric: what is a function of C turned to space.
template <int D, class R>
KOKKOS_FORCEINLINE_FUNCTION
Sym<D, R> turned(const Mat<D, R>& f, const R& jacobian, const Sym<D, R>& t) {
  const Mat<D, R> c = cofactor(f);
  const R over = R(1) / jacobian;
  Sym<D, R> tau;
  for (int j = 0; j < D; ++j) {
    Vec<D, R> row;
    for (int i = 0; i < D; ++i) row[i] = f(j, i) * over;
    const Vec<D, R> column = t * row;
    for (int i = 0; i <= j; ++i) {
      R sum = c(i, 0) * column[0];
      for (int k = 1; k < D; ++k) sum = sum + c(i, k) * column[k];
      tau(i, j) = sum;
    }
  }
  return tau;
}

/// Isotropic hyperelasticity: nothing to remember, so nothing is read but shapes.
template <int D>
struct HenckyResponse {
  HenckyElastic law;
  bool flat;

  template <class R, class Lanes>
  KOKKOS_FORCEINLINE_FUNCTION
  FullSym<D, R> respond(const SubShape<D, R>& shape, const Lanes& lanes, int,
                        Sums<element_sum::count>&) const {
    if constexpr (kSingle<R>) {
      R dilation;
      const FullSym<D, R> eps = strain_of_growth<D>(shape, flat, lanes, dilation);
      FullSym<D, R> t = isotropic(law, eps, flat);
      if (!flat) {
        t = eps * R(2 * law.mu);
        t.add_identity(R(law.lambda + 2 * law.mu / 3) * dilation - R(2 * law.mu / 3) * trace(eps));
      }
      return {turned(shape.f, shape.jacobian, t.in), t.zz};
    } else {
      const Sym<D, R> b = left_cauchy_green(shape.f);
      return isotropic(law, strain_of<D>(b, shape.jacobian, shape.shift, lanes), flat);
    }
  }

  template <int Group, class R, class Lanes>
  KOKKOS_FORCEINLINE_FUNCTION
  R settle(const Lanes&, const GroupVolume<R>& volume, const SubShape<D, R> (&shape)[Group],
           FullSym<D, R> (&tau)[Group], Sums<element_sum::count>&) const {
    if constexpr (Group > 1)
      if (!flat) share_mean<D, Group>(volume, shape, tau);
    return R(law.lambda + 2 * law.mu);
  }
};

/// Elasticity of any symmetry along material axes, from a state of initial strain.
template <int D>
struct AnisotropicResponse {
  AnisotropicState<D> state;
  bool flat;            ///< plane stress
  double energy_scale;  ///< thickness / D!

  template <class R, class Lanes>
  KOKKOS_FORCEINLINE_FUNCTION
  FullSym<D, R> respond(const SubShape<D, R>& shape, const Lanes& lanes, int sub,
                        Sums<element_sum::count>& sums) const {
    const Sym<D, R> c = right_cauchy_green(shape.f);
    FullSym<D, R> eps;
    if constexpr (kSingle<R>) {
      R dilation;
      eps = strain_of_growth<D>(shape, flat, lanes, dilation);
    } else {
      eps = strain_of<D>(c, shape.jacobian, shape.shift, lanes);
    }
    if (state.initial.extent(0) > 0)
      for (int i = 0; i < FullSym<D>::size; ++i)
        eps[i] = eps[i] + lanes.read(state.initial, sub, i);
    const FullSym<D, R> t = state.law.stress(eps);
    book_stored(lanes,
                R(0.5 * energy_scale) * contract(t, eps) * shape.share * shape.det / shape.jacobian,
                sums);
    return {congruent(shape.f, second_piola(t.in, c, shape.jacobian)), t.zz};
  }

  template <int Group, class R, class Lanes>
  KOKKOS_FORCEINLINE_FUNCTION
  R settle(const Lanes&, const GroupVolume<R>& volume, const SubShape<D, R> (&shape)[Group],
           FullSym<D, R> (&tau)[Group], Sums<element_sum::count>&) const {
    if constexpr (Group > 1)
      if (!flat) share_mean<D, Group>(volume, shape, tau);
    return R(state.modulus);
  }
};

}  // namespace breccia
