#pragma once
#include <Kokkos_Core.hpp>

namespace breccia {

/// Vector of N numbers of type R (a scalar or a SIMD pack).
template <int N, class R = double>
struct Vec {
  R v[N];

  KOKKOS_INLINE_FUNCTION
  R& operator[](int i) { return v[i]; }
  KOKKOS_INLINE_FUNCTION
  const R& operator[](int i) const { return v[i]; }

  KOKKOS_INLINE_FUNCTION
  static Vec zero() {
    Vec r;
    for (int i = 0; i < N; ++i) r.v[i] = R(0);
    return r;
  }
  KOKKOS_INLINE_FUNCTION
  Vec& operator+=(const Vec& b) {
    for (int i = 0; i < N; ++i) v[i] = v[i] + b.v[i];
    return *this;
  }
  KOKKOS_INLINE_FUNCTION
  Vec& operator-=(const Vec& b) {
    for (int i = 0; i < N; ++i) v[i] = v[i] - b.v[i];
    return *this;
  }
  KOKKOS_INLINE_FUNCTION
  Vec& operator*=(const R& s) {
    for (int i = 0; i < N; ++i) v[i] = v[i] * s;
    return *this;
  }
  friend KOKKOS_INLINE_FUNCTION
  Vec operator+(Vec a, const Vec& b) { return a += b; }
  friend KOKKOS_INLINE_FUNCTION
  Vec operator-(Vec a, const Vec& b) { return a -= b; }
  friend KOKKOS_INLINE_FUNCTION
  Vec operator*(Vec a, const R& s) { return a *= s; }
  friend KOKKOS_INLINE_FUNCTION
  Vec operator*(const R& s, Vec a) { return a *= s; }
  friend KOKKOS_INLINE_FUNCTION
  Vec operator-(Vec a) {
    for (int i = 0; i < N; ++i) a.v[i] = -a.v[i];
    return a;
  }
};

template <int N, class R>
KOKKOS_INLINE_FUNCTION
R dot(const Vec<N, R>& a, const Vec<N, R>& b) {
  R s = a[0] * b[0];
  for (int i = 1; i < N; ++i) s = s + a[i] * b[i];
  return s;
}

template <int N, class R>
KOKKOS_INLINE_FUNCTION
R norm2(const Vec<N, R>& a) {
  return dot(a, a);
}

template <int N, class R>
KOKKOS_INLINE_FUNCTION
R norm(const Vec<N, R>& a) {
  using Kokkos::sqrt;
  return sqrt(dot(a, a));
}

/// z component of the cross product of two plane vectors.
template <class R>
KOKKOS_INLINE_FUNCTION
R cross(const Vec<2, R>& a, const Vec<2, R>& b) {
  return a[0] * b[1] - a[1] * b[0];
}

template <class R>
KOKKOS_INLINE_FUNCTION
Vec<3, R> cross(const Vec<3, R>& a, const Vec<3, R>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace breccia
