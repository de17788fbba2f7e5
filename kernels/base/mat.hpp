#pragma once
#include "base/vec.hpp"

namespace breccia {

/// Square matrix, m[i][j] = row i, column j.
template <int N, class R = double>
struct Mat {
  R m[N][N];

  KOKKOS_INLINE_FUNCTION
  R& operator()(int i, int j) { return m[i][j]; }
  KOKKOS_INLINE_FUNCTION
  const R& operator()(int i, int j) const { return m[i][j]; }

  KOKKOS_INLINE_FUNCTION
  static Mat zero() {
    Mat a;
    for (int i = 0; i < N; ++i)
      for (int j = 0; j < N; ++j) a.m[i][j] = R(0);
    return a;
  }
  KOKKOS_INLINE_FUNCTION
  static Mat identity() {
    Mat a = zero();
    for (int i = 0; i < N; ++i) a.m[i][i] = R(1);
    return a;
  }
};

template <int N, class R>
KOKKOS_INLINE_FUNCTION
Mat<N, R> operator*(const Mat<N, R>& a, const Mat<N, R>& b) {
  Mat<N, R> c;
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j) {
      R s = a(i, 0) * b(0, j);
      for (int k = 1; k < N; ++k) s = s + a(i, k) * b(k, j);
      c(i, j) = s;
    }
  return c;
}

template <int N, class R>
KOKKOS_INLINE_FUNCTION
Vec<N, R> operator*(const Mat<N, R>& a, const Vec<N, R>& x) {
  Vec<N, R> y;
  for (int i = 0; i < N; ++i) {
    R s = a(i, 0) * x[0];
    for (int k = 1; k < N; ++k) s = s + a(i, k) * x[k];
    y[i] = s;
  }
  return y;
}

template <int N, class R>
KOKKOS_INLINE_FUNCTION
Mat<N, R> transpose(const Mat<N, R>& a) {
  Mat<N, R> t;
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j) t(i, j) = a(j, i);
  return t;
}

/// Cofactor matrix: cof(a) = det(a) a^-T.
template <class R>
KOKKOS_INLINE_FUNCTION
Mat<2, R> cofactor(const Mat<2, R>& a) {
  return {{{a(1, 1), -a(1, 0)}, {-a(0, 1), a(0, 0)}}};
}

template <class R>
KOKKOS_INLINE_FUNCTION
Mat<3, R> cofactor(const Mat<3, R>& a) {
  Mat<3, R> c;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int p = (i + 1) % 3, q = (i + 2) % 3, r = (j + 1) % 3, s = (j + 2) % 3;
      c(i, j) = a(p, r) * a(q, s) - a(p, s) * a(q, r);
    }
  return c;
}

template <int N, class R>
KOKKOS_INLINE_FUNCTION
R determinant(const Mat<N, R>& a) {
  const Mat<N, R> c = cofactor(a);
  R s = a(0, 0) * c(0, 0);
  for (int j = 1; j < N; ++j) s = s + a(0, j) * c(0, j);
  return s;
}

template <int N, class R>
KOKKOS_INLINE_FUNCTION
Mat<N, R> inverse(const Mat<N, R>& a) {
  const R d = R(1) / determinant(a);
  Mat<N, R> b = transpose(cofactor(a));
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j) b(i, j) = b(i, j) * d;
  return b;
}

/// Symmetric matrix; stored in full order xx, yy, xy (2D) or xx, yy, zz, yz, xz, xy (3D).
template <int N, class R = double>
struct Sym {
  static constexpr int size = N * (N + 1) / 2;
  R s[size];

  /// Place of component (i, j) in `s`.
  KOKKOS_INLINE_FUNCTION
  static constexpr int at(int i, int j) { return i == j ? i : (N == 2 ? 2 : 6 - i - j); }
  KOKKOS_INLINE_FUNCTION
  R& operator()(int i, int j) { return s[at(i, j)]; }
  KOKKOS_INLINE_FUNCTION
  const R& operator()(int i, int j) const { return s[at(i, j)]; }

  KOKKOS_INLINE_FUNCTION
  static Sym zero() {
    Sym a;
    for (int i = 0; i < size; ++i) a.s[i] = R(0);
    return a;
  }
  KOKKOS_INLINE_FUNCTION
  static Sym identity() {
    Sym a = zero();
    for (int i = 0; i < N; ++i) a.s[i] = R(1);
    return a;
  }
  KOKKOS_INLINE_FUNCTION
  Sym& operator+=(const Sym& b) {
    for (int i = 0; i < size; ++i) s[i] = s[i] + b.s[i];
    return *this;
  }
  KOKKOS_INLINE_FUNCTION
  Sym& operator*=(const R& f) {
    for (int i = 0; i < size; ++i) s[i] = s[i] * f;
    return *this;
  }
  friend KOKKOS_INLINE_FUNCTION
  Sym operator+(Sym a, const Sym& b) { return a += b; }
  friend KOKKOS_INLINE_FUNCTION
  Sym operator*(Sym a, const R& f) { return a *= f; }
};

template <int N, class R>
KOKKOS_INLINE_FUNCTION
R trace(const Sym<N, R>& a) {
  R t = a.s[0];
  for (int i = 1; i < N; ++i) t = t + a.s[i];
  return t;
}

/// a : b, with both off-diagonal places counted.
template <int N, class R>
KOKKOS_INLINE_FUNCTION
R contract(const Sym<N, R>& a, const Sym<N, R>& b) {
  R d = a.s[0] * b.s[0];
  for (int i = 1; i < N; ++i) d = d + a.s[i] * b.s[i];
  R o = a.s[N] * b.s[N];
  for (int i = N + 1; i < Sym<N, R>::size; ++i) o = o + a.s[i] * b.s[i];
  return d + R(2) * o;
}

template <int N, class R>
KOKKOS_INLINE_FUNCTION
Vec<N, R> operator*(const Sym<N, R>& a, const Vec<N, R>& x) {
  Vec<N, R> y;
  for (int i = 0; i < N; ++i) {
    R t = a(i, 0) * x[0];
    for (int k = 1; k < N; ++k) t = t + a(i, k) * x[k];
    y[i] = t;
  }
  return y;
}

/// F F^T.
template <int N, class R>
KOKKOS_INLINE_FUNCTION
Sym<N, R> left_cauchy_green(const Mat<N, R>& f) {
  Sym<N, R> b;
  for (int i = 0; i < N; ++i)
    for (int j = i; j < N; ++j) {
      R t = f(i, 0) * f(j, 0);
      for (int k = 1; k < N; ++k) t = t + f(i, k) * f(j, k);
      b(i, j) = t;
    }
  return b;
}

/// F^T F.
template <int N, class R>
KOKKOS_INLINE_FUNCTION
Sym<N, R> right_cauchy_green(const Mat<N, R>& f) {
  Sym<N, R> c;
  for (int i = 0; i < N; ++i)
    for (int j = i; j < N; ++j) {
      R t = f(0, i) * f(0, j);
      for (int k = 1; k < N; ++k) t = t + f(k, i) * f(k, j);
      c(i, j) = t;
    }
  return c;
}

/// F S F^T of a symmetric S.
template <int N, class R>
KOKKOS_INLINE_FUNCTION
Sym<N, R> congruent(const Mat<N, R>& f, const Sym<N, R>& s) {
  Mat<N, R> fs;
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j) {
      R t = f(i, 0) * s(0, j);
      for (int k = 1; k < N; ++k) t = t + f(i, k) * s(k, j);
      fs(i, j) = t;
    }
  Sym<N, R> r;
  for (int i = 0; i < N; ++i)
    for (int j = i; j < N; ++j) {
      R t = fs(i, 0) * f(j, 0);
      for (int k = 1; k < N; ++k) t = t + fs(i, k) * f(j, k);
      r(i, j) = t;
    }
  return r;
}

/// (a + a^T) / 2.
template <int N, class R>
KOKKOS_INLINE_FUNCTION
Sym<N, R> symmetric_part(const Mat<N, R>& a) {
  Sym<N, R> d;
  for (int i = 0; i < N; ++i)
    for (int j = i; j < N; ++j) d(i, j) = R(0.5) * (a(i, j) + a(j, i));
  return d;
}

/// Symmetric part of the product of two symmetric matrices that commute (so it is the product).
template <int N, class R>
KOKKOS_INLINE_FUNCTION
Sym<N, R> commuting_product(const Sym<N, R>& a, const Sym<N, R>& b) {
  Sym<N, R> c;
  for (int i = 0; i < N; ++i)
    for (int j = i; j < N; ++j) {
      R t = a(i, 0) * b(0, j);
      for (int k = 1; k < N; ++k) t = t + a(i, k) * b(k, j);
      c(i, j) = t;
    }
  return c;
}

}  // namespace breccia
