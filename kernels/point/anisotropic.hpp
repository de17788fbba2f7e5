#pragma once
#include "point/full_sym.hpp"

namespace breccia {

/// Linear elasticity of any symmetry in logarithmic strain along material axes.
///
// symbols  eps = ln U [1] in material axes   t = C eps [Pa] conjugate to it   w = eps : C : eps / 2
// source   ALGORITHMS. The stress on the element is the exact derivative of w
//          (point/hencky_stress.hpp), so closed strain cycles give their work back.
struct Anisotropic {
  /// Rows and columns xx, yy, zz, yz, xz, xy; acts on tensor components: the columns of shear are
  /// doubled. Pa.
  double c[6][6] = {};

  /// eq:solid-14 t = C eps; in the plane the shears across are zero.
  template <int D, class R>
  KOKKOS_FUNCTION
  FullSym<D, R> stress(const FullSym<D, R>& eps) const {
    FullSym<D, R> t;
    constexpr int kPlace[6] = {0, 1, D == 2 ? 5 : 2, D == 2 ? 2 : 3, 4, 5};
    for (int i = 0; i < FullSym<D, R>::size; ++i) {
      R sum = R(c[kPlace[i]][kPlace[0]]) * eps[0];
      for (int j = 1; j < FullSym<D, R>::size; ++j) sum = sum + R(c[kPlace[i]][kPlace[j]]) * eps[j];
      t[i] = sum;
    }
    return t;
  }
};

}  // namespace breccia
