#pragma once
#include "base/sums.hpp"
#include "loops/element.hpp"
#include "point/hencky.hpp"

namespace breccia {

/// Stress of single elements, for onset checks and pictures: the same law as the element loop, one
/// element at a time.
template <int D>
struct ElementStress {
  ConstConnectivity<D> nodes;
  ConstVectors<D> x;
  ConstMatrices<D> reference;
  Kokkos::View<const Index*, Memory> material;
  ConstVectors<2> lame;  ///< lambda, mu of each material, Pa
  double thickness = 1;
  bool flat = false;           ///< plane stress
  ConstFullTensors<D> stored;  ///< Cauchy stress as the element loop left it; empty: computed anew
  Kokkos::View<const double*, Memory> share;  ///< of its stress that an element carries, or empty
  Kokkos::View<const std::uint8_t*, Memory> own;  ///< 1 where sums count it; empty: everywhere

  KOKKOS_FUNCTION
  HenckyElastic law(Index e) const { return {lame(material(e), 0), lame(material(e), 1)}; }

  KOKKOS_FUNCTION
  Sym<D> strain(Index e, double& jacobian) const {
    Vec<D> at[D + 1];
    gather(nodes, x, e, e, at);
    Mat<D> inverse_edges;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) inverse_edges(i, j) = reference(e, i, j);
    const Mat<D> f = edges<D, double>(at) * inverse_edges;
    jacobian = determinant(f);
    return hencky_strain(left_cauchy_green(f), jacobian);
  }

  /// Cauchy stress without its viscous part, Pa.
  KOKKOS_FUNCTION
  FullSym<D> full_cauchy(Index e) const {
    FullSym<D> sigma;
    if (stored.extent(0) > 0) {
      for (int i = 0; i < FullSym<D>::size; ++i) sigma[i] = stored(e, i);
      return sigma;
    }
    double jacobian;
    const FullSym<D> eps{strain(e, jacobian), 0};
    return isotropic(law(e), eps, flat) * (1 / jacobian);
  }
  KOKKOS_FUNCTION
  Sym<D> cauchy(Index e) const { return full_cauchy(e).in; }

  /// Reference volume, m3 (area times thickness in the plane).
  KOKKOS_FUNCTION
  double volume(Index e) const {
    Mat<D> inverse_edges;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) inverse_edges(i, j) = reference(e, i, j);
    return thickness / (kFactorial<D> * determinant(inverse_edges));
  }
};

/// Strain energy of hyperelastic elements [begin, end) of one material, in groups that share their
/// dilation, J; added up in a fixed order.
template <int D>
double strain_energy(const ElementStress<D>& stress, Index begin, Index end, int group);

/// Cauchy stress of elements [0, n): (element, component of FullSym<D>), Pa.
template <int D>
Kokkos::View<double**, Rows, Memory> cauchy_stress(const ElementStress<D>& stress, Index n);

extern template double strain_energy<2>(const ElementStress<2>&, Index, Index, int);
extern template double strain_energy<3>(const ElementStress<3>&, Index, Index, int);
extern template Kokkos::View<double**, Rows, Memory> cauchy_stress<2>(const ElementStress<2>&,
                                                                      Index);
extern template Kokkos::View<double**, Rows, Memory> cauchy_stress<3>(const ElementStress<3>&,
                                                                      Index);

}  // namespace breccia
