#pragma once
#include "base/mat.hpp"

namespace breccia {

/// Principal values of a symmetric matrix and their axes: column k of `axes` belongs to value[k].
template <int D>
struct Principal {
  double value[D];
  Mat<D> axes;

  /// The matrix with the same axes and other values.
  KOKKOS_FUNCTION
  Sym<D> with(const double* values) const {
    Sym<D> a = Sym<D>::zero();
    for (int k = 0; k < D; ++k)
      for (int i = 0; i < D; ++i)
        for (int j = i; j < D; ++j) a(i, j) += values[k] * axes(i, k) * axes(j, k);
    return a;
  }
};

namespace principal {

/// One Jacobi rotation in the plane of axes p and r that makes a(p, r) zero (Golub and Van Loan,
/// Matrix Computations, section 8.5).
template <int D>
KOKKOS_INLINE_FUNCTION
void rotate(double (&a)[D][D], Mat<D>& axes, int p, int r) {
  if (a[p][r] == 0) return;
  const double theta = (a[r][r] - a[p][p]) / (2 * a[p][r]);
  const double t =
      (theta >= 0 ? 1.0 : -1.0) / (Kokkos::abs(theta) + Kokkos::sqrt(theta * theta + 1));
  const double c = 1 / Kokkos::sqrt(t * t + 1), s = t * c;
  for (int k = 0; k < D; ++k) {
    const double kp = a[k][p], kr = a[k][r];
    a[k][p] = c * kp - s * kr;
    a[k][r] = s * kp + c * kr;
  }
  for (int k = 0; k < D; ++k) {
    const double pk = a[p][k], rk = a[r][k];
    a[p][k] = c * pk - s * rk;
    a[r][k] = s * pk + c * rk;
    const double qp = axes(k, p), qr = axes(k, r);
    axes(k, p) = c * qp - s * qr;
    axes(k, r) = s * qp + c * qr;
  }
}

}  // namespace principal

/// Cyclic Jacobi rotations: one in the plane, in space mostly four rounds. A round squares what is
/// left beside the diagonal, so the one that begins below 1e-10 of the differences on it is the
/// last.
template <int D>
KOKKOS_INLINE_FUNCTION
Principal<D> principal_of(const Sym<D>& m) {
  Principal<D> result;
  result.axes = Mat<D>::identity();
  double a[D][D];
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) a[i][j] = m(i, j);
  for (int round = 0; round < (D == 2 ? 1 : 12); ++round) {
    double beside = 0, apart = Kokkos::abs(a[0][0] - a[1][1]);
    for (int p = 0; p < D - 1; ++p)
      for (int r = p + 1; r < D; ++r) {
        beside += Kokkos::abs(a[p][r]);
        const double gap = Kokkos::abs(a[p][p] - a[r][r]);
        if (gap < apart) apart = gap;
      }
    for (int p = 0; p < D - 1; ++p)
      for (int r = p + 1; r < D; ++r) principal::rotate<D>(a, result.axes, p, r);
    if (beside <= 1e-10 * apart) break;
  }
  for (int k = 0; k < D; ++k) result.value[k] = a[k][k];
  return result;
}

}  // namespace breccia
