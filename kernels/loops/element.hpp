#pragma once
#include "base/mat.hpp"
#include "base/pack.hpp"
#include "base/views.hpp"

namespace breccia {

/// Edge matrix [a1 - a0, ...] of a simplex (columns are edges) from any node vectors.
template <int D, class R>
KOKKOS_FORCEINLINE_FUNCTION
Mat<D, R> edges(const Vec<D, R> (&a)[D + 1]) {
  Mat<D, R> g;
  for (int j = 0; j < D; ++j)
    for (int i = 0; i < D; ++i) g(i, j) = a[j + 1][i] - a[0][i];
  return g;
}

/// D!, the ratio of a parallelepiped's volume to a simplex's.
template <int D>
inline constexpr double kFactorial = D == 2 ? 2.0 : 6.0;

/// Node vectors of the elements in a pack.
template <int D, class R, class Nodes, class Field>
KOKKOS_FORCEINLINE_FUNCTION
void gather(const Nodes& nodes, const Field& field, Index first, Index last,
            Vec<D, R> (&to)[D + 1]) {
  for (int a = 0; a <= D; ++a) {
    Index n[lanes<R>()];
    for (int l = 0; l < lanes<R>(); ++l) n[l] = nodes(first + l < last ? first + l : last, a);
    for (int d = 0; d < D; ++d) to[a][d] = fill<R>([&](int l) { return field(n[l], d); });
  }
}

/// Element constants that lie side by side. Fields of elements have room for a whole pack
/// behind the last element (scene/build.cpp).
template <int D, class R>
KOKKOS_FORCEINLINE_FUNCTION
Mat<D, R> stream(const ConstMatrices<D>& a, Index first) {
  Mat<D, R> m;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) m(i, j) = load<R>(&a(first, i, j));
  return m;
}

}  // namespace breccia
