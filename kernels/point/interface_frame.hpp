#pragma once
#include "base/vec.hpp"

namespace breccia {

/// Axes of a face: normal from left to right, then along its first edge, then their cross product.
/// Components in it do not change when the pair moves as a rigid body.
template <int D>
struct InterfaceFrame {
  Vec<D> axis[D];

  KOKKOS_FUNCTION
  const Vec<D>& normal() const { return axis[0]; }

  KOKKOS_FUNCTION
  Vec<D> to_local(const Vec<D>& a) const {
    Vec<D> r;
    for (int i = 0; i < D; ++i) r[i] = dot(axis[i], a);
    return r;
  }

  KOKKOS_FUNCTION
  Vec<D> to_global(const Vec<D>& a) const {
    Vec<D> r = axis[0] * a[0];
    for (int i = 1; i < D; ++i) r += axis[i] * a[i];
    return r;
  }
};

/// Frame of the mid-surface through the corners in the order of the left element's face
/// (base/simplex.hpp): that order makes the normal point from left to right.
KOKKOS_INLINE_FUNCTION
InterfaceFrame<2> frame_of(const Vec<2> (&x)[2]) {
  const Vec<2> edge = x[1] - x[0];
  const Vec<2> t = edge * (1 / norm(edge));
  return {{{{t[1], -t[0]}}, t}};
}

KOKKOS_INLINE_FUNCTION
InterfaceFrame<3> frame_of(const Vec<3> (&x)[3]) {
  const Vec<3> edge = x[1] - x[0];
  const Vec<3> area = cross(edge, x[2] - x[0]);
  const Vec<3> n = area * (1 / norm(area));
  const Vec<3> t = edge * (1 / norm(edge));
  return {{n, t, cross(n, t)}};
}

}  // namespace breccia
