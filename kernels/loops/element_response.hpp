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

/// ln V, or ln U along material axes; in single precision from the displacement gradient.
template <int D, class R, class Lanes>
KOKKOS_FORCEINLINE_FUNCTION
FullSym<D, R> left_strain(const SubShape<D, R>& shape, const Lanes& lanes) {
  if constexpr (kSingle<R>) {
    FullSym<D, R> eps{hencky_strain_of_growth(left_growth(shape.gradient), shape.dilation), R(0)};
    if constexpr (Lanes::kGroup > 1) eps.add_identity(shape.shift);
    return eps;
  } else {
    return strain_of<D>(left_cauchy_green(shape.f), shape.jacobian, shape.shift, lanes);
  }
}
template <int D, class R, class Lanes>
KOKKOS_FORCEINLINE_FUNCTION
FullSym<D, R> right_strain(const SubShape<D, R>& shape, const Sym<D, R>& c, const Lanes& lanes) {
  if constexpr (kSingle<R>) {
    const Sym<D, R> growth = congruent(transpose(shape.axes), right_growth(shape.gradient));
    FullSym<D, R> eps{hencky_strain_of_growth(growth, shape.dilation), R(0)};
    if constexpr (Lanes::kGroup > 1) eps.add_identity(shape.shift);
    return eps;
  } else {
    return strain_of<D>(c, shape.jacobian, shape.shift, lanes);
  }
}

/// Isotropic hyperelasticity: nothing to remember, so nothing is read but shapes.
template <int D>
struct HenckyResponse {
  static constexpr bool kAxes = false;
  HenckyElastic law;
  bool flat;

  template <class R, class Lanes>
  KOKKOS_FORCEINLINE_FUNCTION
  FullSym<D, R> respond(const SubShape<D, R>& shape, const Lanes& lanes, int,
                        Sums<element_sum::count>&) const {
    return isotropic(law, left_strain<D>(shape, lanes), flat);
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
  static constexpr bool kAxes = true;  ///< wants to know the material axes
  AnisotropicState<D> state;
  bool flat;            ///< plane stress
  double energy_scale;  ///< thickness / D!

  template <class R, class Lanes>
  KOKKOS_FORCEINLINE_FUNCTION
  FullSym<D, R> respond(const SubShape<D, R>& shape, const Lanes& lanes, int sub,
                        Sums<element_sum::count>& sums) const {
    const Sym<D, R> c = right_cauchy_green(shape.f);
    FullSym<D, R> eps = right_strain<D>(shape, c, lanes);
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
