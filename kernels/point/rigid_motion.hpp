#pragma once
#include "base/mat.hpp"

namespace breccia {

/// Unit quaternion of a rotation by the angle 2 atan2(|u|, w) about u.
struct Quaternion {
  double w;
  Vec<3> u;

  KOKKOS_INLINE_FUNCTION
  static Quaternion identity() { return {1, Vec<3>::zero()}; }
  /// Rotation by the vector `turn`, rad.
  KOKKOS_INLINE_FUNCTION
  static Quaternion of(const Vec<3>& turn) {
    const double angle = norm(turn);
    if (angle == 0) return identity();
    return {Kokkos::cos(0.5 * angle), turn * (Kokkos::sin(0.5 * angle) / angle)};
  }
};

/// First b, then a.
KOKKOS_INLINE_FUNCTION
Quaternion operator*(const Quaternion& a, const Quaternion& b) {
  return {a.w * b.w - dot(a.u, b.u), a.w * b.u + b.w * a.u + cross(a.u, b.u)};
}

KOKKOS_INLINE_FUNCTION
Quaternion normalised(const Quaternion& q) {
  const double size = 1 / Kokkos::sqrt(q.w * q.w + norm2(q.u));
  return {q.w * size, q.u * size};
}

/// The matrix of a x ... .
KOKKOS_INLINE_FUNCTION
Mat<3> cross_matrix(const Vec<3>& a) {
  return {{{0, -a[2], a[1]}, {a[2], 0, -a[0]}, {-a[1], a[0], 0}}};
}

/// R - 1 without the loss of digits that the subtraction would bring for small angles:
/// 2 (w [u]x + [u]x [u]x).
KOKKOS_INLINE_FUNCTION
Mat<3> turn_less_one(const Quaternion& q) {
  const Mat<3> a = cross_matrix(q.u), b = a * a;
  Mat<3> r;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) r(i, j) = 2 * (q.w * a(i, j) + b(i, j));
  return r;
}

KOKKOS_INLINE_FUNCTION
Mat<3> matrix_of(const Quaternion& q) {
  Mat<3> r = turn_less_one(q);
  for (int i = 0; i < 3; ++i) r(i, i) += 1;
  return r;
}

/// Rotation of a body that no torque acts on, over one step, along its principal axes.
///
/// The kinetic energy is split into that of one axis at a time, whose motion is a rotation that is
/// known exactly; three symmetric sweeps make it fourth order. The angular momentum is only ever
/// turned, so its size stays to round-off; the map is symplectic, so the energy does not drift.
///
// symbols  m [N m s] angular momentum along the principal axes   1/I [1/(kg m2)]   h [s] step
// source   Dullweber, Leimkuhler and McLachlan, J. Chem. Phys. 107 (1997) 5840, the splitting;
//          Yoshida, Phys. Lett. A 150 (1990) 262, the composition
struct FreeRotor {
  Vec<3> inverse_inertia;  ///< 1/(kg m2); 0 about an axis that does not turn

  /// The rotation of the body during h, in its own axes: q(t + h) = q(t) * result.
  KOKKOS_FUNCTION
  Quaternion turn(Vec<3> m, double h) const {
    constexpr double kOuter = 1.3512071919596578;  // 1 / (2 - cbrt 2)
    Quaternion whole = Quaternion::identity();
    sweep(kOuter * h, m, whole);
    sweep((1 - 2 * kOuter) * h, m, whole);
    sweep(kOuter * h, m, whole);
    return whole;
  }

 private:
  KOKKOS_INLINE_FUNCTION
  void sweep(double h, Vec<3>& m, Quaternion& whole) const {
    about(0, 0.5 * h, m, whole);
    about(1, 0.5 * h, m, whole);
    about(2, h, m, whole);
    about(1, 0.5 * h, m, whole);
    about(0, 0.5 * h, m, whole);
  }

  KOKKOS_INLINE_FUNCTION
  void about(int axis, double h, Vec<3>& m, Quaternion& whole) const {
    const double angle = h * m[axis] * inverse_inertia[axis];
    if (angle == 0) return;
    const double c = Kokkos::cos(0.5 * angle), s = Kokkos::sin(0.5 * angle);
    Quaternion part{c, Vec<3>::zero()};
    part.u[axis] = s;
    whole = whole * part;
    // In its own axes the body sees its momentum turn backwards.
    const double cosine = c * c - s * s, sine = 2 * c * s;
    const int j = (axis + 1) % 3, k = (axis + 2) % 3;
    const double mj = cosine * m[j] + sine * m[k];
    m[k] = cosine * m[k] - sine * m[j];
    m[j] = mj;
  }
};

}  // namespace breccia
