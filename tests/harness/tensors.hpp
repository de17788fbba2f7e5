#pragma once
#include "base/mat.hpp"
#include "core/random.hpp"

#include <algorithm>
#include <cmath>

namespace breccia {

// Tensors for tests of laws: made from numbers whose result is known beforehand.

inline Mat<2> rotation_matrix(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {{{c, -s}, {s, c}}};
}

/// Rotation by `angle` about the direction of `axis` (Rodrigues).
inline Mat<3> rotation_matrix(Vec<3> axis, double angle) {
  axis *= 1 / norm(axis);
  const double c = std::cos(angle), s = std::sin(angle);
  Mat<3> r;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) r(i, j) = (i == j ? c : 0.0) + (1 - c) * axis[i] * axis[j];
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    r(j, i) += s * axis[k];
    r(i, j) -= s * axis[k];
  }
  return r;
}

/// A rotation that belongs to the number `id`.
template <int D>
Mat<D> random_rotation(const Random& random, std::uint64_t id) {
  const double angle = 6.283185307179586 * random.uniform(id, 90);
  if constexpr (D == 2) {
    return rotation_matrix(angle);
  } else {
    return rotation_matrix({random.normal(id, 91), random.normal(id, 92), random.normal(id, 93)},
                           angle);
  }
}

/// q diag(values) q^T.
template <int D>
Sym<D> spectral(const Mat<D>& q, const Vec<D>& values) {
  Sym<D> a = Sym<D>::zero();
  for (int i = 0; i < D; ++i)
    for (int j = i; j < D; ++j)
      for (int k = 0; k < D; ++k) a(i, j) += q(i, k) * values[k] * q(j, k);
  return a;
}

template <int D>
Mat<D> full(const Sym<D>& a) {
  Mat<D> m;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) m(i, j) = a(i, j);
  return m;
}

/// q a q^T.
template <int D>
Sym<D> rotated(const Sym<D>& a, const Mat<D>& q) {
  return symmetric_part(q * full(a) * transpose(q));
}

template <int D>
double largest(const Sym<D>& a) {
  double most = 0;
  for (const double c : a.s) most = std::max(most, std::abs(c));
  return most;
}

/// Largest difference of two components.
template <int D>
double distance(const Sym<D>& a, const Sym<D>& b) {
  return largest(a + b * -1.0);
}

}  // namespace breccia
