#pragma once
#include "base/index.hpp"
#include "base/mat.hpp"
#include "base/simplex.hpp"

namespace breccia {

/// Side of the line a -> b on which q lies: +1 left, -1 right, never 0. A point on the line is
/// moved by
/// (epsilon, epsilon^2), the same for every line, so that a point belongs to exactly one element of
/// a mesh.
KOKKOS_INLINE_FUNCTION
int side_of_line(const Vec<2>& a, const Vec<2>& b, const Vec<2>& q) {
  const Vec<2> along = b - a;
  const Vec<2> reach = q - a;
  // At b itself the product is zero but for the rounding of a fused multiply-add.
  const bool at_end = reach[0] == along[0] && reach[1] == along[1];
  const double s = at_end ? 0.0 : cross(along, reach);
  if (s != 0) return s > 0 ? 1 : -1;
  if (along[1] != 0) return along[1] < 0 ? 1 : -1;
  return along[0] > 0 ? 1 : -1;
}

/// True when q lies in the positively oriented triangle. Each edge is looked at from its smaller to
/// its larger node,
/// so that the two elements that share it see the same bits and exactly one of them claims q.
template <int D>
KOKKOS_FUNCTION
bool claims(const Vec<D> (&x)[D + 1], const Index (&node)[D + 1], const Vec<D>& q) {
  static_assert(D == 2, "contact in space follows");
  for (int f = 0; f <= D; ++f) {
    const int i = face_node<D>(f, 0), j = face_node<D>(f, 1);
    const bool ordered = node[i] < node[j];
    const int side = ordered ? side_of_line(x[i], x[j], q) : -side_of_line(x[j], x[i], q);
    if (side < 0) return false;
  }
  return true;
}

/// Edge matrix [x1 - x0, ...] of a simplex.
template <int D>
KOKKOS_INLINE_FUNCTION
Mat<D> edge_matrix(const Vec<D> (&x)[D + 1]) {
  Mat<D> g;
  for (int j = 0; j < D; ++j)
    for (int i = 0; i < D; ++i) g(i, j) = x[j + 1][i] - x[0][i];
  return g;
}

/// Barycentric coordinates of q; they add up to one to the last bit of the first.
template <int D>
KOKKOS_INLINE_FUNCTION
void barycentric(const Mat<D>& inverse_edges, const Vec<D>& x0, const Vec<D>& q,
                 double (&l)[D + 1]) {
  const Vec<D> inner = inverse_edges * (q - x0);
  l[0] = 1;
  for (int k = 0; k < D; ++k) {
    l[k + 1] = inner[k];
    l[0] -= inner[k];
  }
}

/// Square of the distance from q to the segment a b.
template <int D>
KOKKOS_INLINE_FUNCTION
double square_distance_to_segment(const Vec<D>& a, const Vec<D>& b, const Vec<D>& q) {
  const Vec<D> along = b - a;
  const double length2 = norm2(along);
  double s = length2 > 0 ? dot(q - a, along) / length2 : 0;
  s = s < 0 ? 0 : (s > 1 ? 1 : s);
  return norm2(q - a - along * s);
}

/// Square of the distance from q to a face, given by its D nodes.
template <int D>
KOKKOS_INLINE_FUNCTION
double square_distance_to_face(const Vec<D> (&x)[D], const Vec<D>& q) {
  static_assert(D == 2, "contact in space follows");
  return square_distance_to_segment(x[0], x[1], q);
}

/// Square of the distance from q to a simplex; zero inside. `l` receives barycentric weights of the
/// nearest point.
template <int D>
KOKKOS_FUNCTION
double square_distance_to_simplex(const Vec<D> (&x)[D + 1], const Vec<D>& q, double (&l)[D + 1]) {
  static_assert(D == 2, "contact in space follows");
  barycentric(inverse(edge_matrix<D>(x)), x[0], q, l);
  bool within = true;
  for (int k = 0; k <= D; ++k) within = within && l[k] >= 0;
  if (within) return 0;
  double best = -1;
  for (int f = 0; f <= D; ++f) {
    const int i = face_node<D>(f, 0), j = face_node<D>(f, 1);
    const Vec<D> along = x[j] - x[i];
    const double length2 = norm2(along);
    double s = length2 > 0 ? dot(q - x[i], along) / length2 : 0;
    s = s < 0 ? 0 : (s > 1 ? 1 : s);
    const double d2 = norm2(q - x[i] - along * s);
    if (best >= 0 && d2 >= best) continue;
    best = d2;
    l[f] = 0;
    l[i] = 1 - s;
    l[j] = s;
  }
  return best;
}

}  // namespace breccia
