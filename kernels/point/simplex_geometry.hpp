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

/// Side of the plane through a, b, c on which q lies: +1 where (b - a) x (c - a) points, else -1,
/// never 0. A point on the plane is moved by (epsilon, epsilon^2, epsilon^3), see side_of_line.
KOKKOS_INLINE_FUNCTION
int side_of_plane(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c, const Vec<3>& q) {
  const Vec<3> u = b - a, v = c - a, reach = q - a;
  const Vec<3> n = cross(u, v);
  bool at_b = true, at_c = true;
  for (int d = 0; d < 3; ++d) {
    at_b = at_b && reach[d] == u[d];
    at_c = at_c && reach[d] == v[d];
  }
  const double s = at_b || at_c ? 0.0 : dot(n, reach);
  if (s != 0) return s > 0 ? 1 : -1;
  for (int d = 0; d < 2; ++d)
    if (n[d] != 0) return n[d] > 0 ? 1 : -1;
  return n[2] > 0 ? 1 : -1;
}

/// Side of face f of a simplex: -1 outside. The nodes of the face are taken in ascending order, so
/// that the two elements that share it see the same bits.
template <int D>
KOKKOS_INLINE_FUNCTION
int side_of_face(const Vec<D> (&x)[D + 1], const Index (&node)[D + 1], int f, const Vec<D>& q) {
  int i = face_node<D>(f, 0), j = face_node<D>(f, 1);
  int turn = 1;
  const auto order = [&](int& a, int& b) {
    if (node[a] < node[b]) return;
    const int c = a;
    a = b;
    b = c;
    turn = -turn;
  };
  if constexpr (D == 2) {
    order(i, j);
    return turn * side_of_line(x[i], x[j], q);
  } else {
    int k = face_node<D>(f, 2);
    order(i, j);
    order(j, k);
    order(i, j);
    return -turn * side_of_plane(x[i], x[j], x[k], q);
  }
}

/// Products that tell on which side of each face q lies: the barycentric coordinates of q times the
/// determinant of the edges.
KOKKOS_INLINE_FUNCTION
void face_products(const Vec<2> (&edge)[2], const Vec<2>& reach, double (&s)[3]) {
  s[1] = cross(reach, edge[1]);
  s[2] = cross(edge[0], reach);
  s[0] = cross(edge[0], edge[1]) - s[1] - s[2];
}
KOKKOS_INLINE_FUNCTION
void face_products(const Vec<3> (&edge)[3], const Vec<3>& reach, double (&s)[4]) {
  const Vec<3> across = cross(edge[1], edge[2]), lever = cross(edge[0], reach);
  s[1] = dot(reach, across);
  s[2] = dot(lever, edge[2]);
  s[3] = -dot(lever, edge[1]);
  s[0] = dot(edge[0], across) - s[1] - s[2] - s[3];
}

/// Whether q lies in the positively oriented simplex, as far as rounding lets plain products tell:
/// +1 inside, -1 outside, 0 too near a face to say.
template <int D>
KOKKOS_INLINE_FUNCTION
int clear_side(const Vec<D> (&x)[D + 1], const Vec<D>& q) {
  constexpr double kRounding = 1e-13;  // some 500 units in the last place
  Vec<D> edge[D];
  const Vec<D> reach = q - x[0];
  double size = 0;
  for (int d = 0; d < D; ++d) {
    size = Kokkos::max(size, Kokkos::abs(reach[d]));
    for (int j = 0; j < D; ++j) {
      edge[j][d] = x[j + 1][d] - x[0][d];
      size = Kokkos::max(size, Kokkos::abs(edge[j][d]));
    }
  }
  double s[D + 1];
  face_products(edge, reach, s);
  double least = s[0];
  for (int f = 1; f <= D; ++f) least = Kokkos::min(least, s[f]);
  const double doubt = kRounding * (D == 2 ? size * size : size * size * size);
  return least > doubt ? 1 : (least < -doubt ? -1 : 0);
}

/// True when q lies in the positively oriented simplex; exactly one element of a mesh claims q.
template <int D>
KOKKOS_FUNCTION
bool claims(const Vec<D> (&x)[D + 1], const Index (&node)[D + 1], const Vec<D>& q) {
  const int clear = clear_side<D>(x, q);
  if (clear != 0) return clear > 0;
  for (int f = 0; f <= D; ++f)
    if (side_of_face<D>(x, node, f, q) < 0) return false;
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

/// Outward normal of a face, given by its nodes in the order of face_node, times its length (in the
/// plane) or area.
KOKKOS_INLINE_FUNCTION
Vec<2> face_normal(const Vec<2> (&x)[2]) {
  const Vec<2> along = x[1] - x[0];
  return {{along[1], -along[0]}};
}
KOKKOS_INLINE_FUNCTION
Vec<3> face_normal(const Vec<3> (&x)[3]) {
  return cross(x[1] - x[0], x[2] - x[0]) * 0.5;
}

/// Weights of the point of a segment that is nearest to q.
template <int D>
KOKKOS_INLINE_FUNCTION
void nearest_on(const Vec<D> (&x)[2], const Vec<D>& q, double (&w)[2]) {
  const Vec<D> along = x[1] - x[0];
  const double length2 = norm2(along);
  const double s = length2 > 0 ? dot(q - x[0], along) / length2 : 0;
  w[1] = s < 0 ? 0 : (s > 1 ? 1 : s);
  w[0] = 1 - w[1];
}

/// Weights of the point of a triangle that is nearest to q.
KOKKOS_FUNCTION
inline void nearest_on(const Vec<3> (&x)[3], const Vec<3>& q, double (&w)[3]) {
  const Vec<3> u = x[1] - x[0], v = x[2] - x[0], r = q - x[0];
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), ru = dot(r, u), rv = dot(r, v);
  const double area2 = uu * vv - uv * uv;
  w[1] = vv * ru - uv * rv;
  w[2] = uu * rv - uv * ru;
  if (area2 > 0 && w[1] >= 0 && w[2] >= 0 && w[1] + w[2] <= area2) {
    w[1] /= area2;
    w[2] /= area2;
    w[0] = 1 - w[1] - w[2];
    return;
  }
  double best = -1;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const Vec<3> edge[2] = {x[i], x[j]};
    double s[2];
    nearest_on<3>(edge, q, s);
    const double d2 = norm2(q - x[i] * s[0] - x[j] * s[1]);
    if (best >= 0 && d2 >= best) continue;
    best = d2;
    w[i] = s[0];
    w[j] = s[1];
    w[3 - i - j] = 0;
  }
}

/// Square of the distance from q to a face, given by its D nodes.
template <int D>
KOKKOS_INLINE_FUNCTION
double square_distance_to_face(const Vec<D> (&x)[D], const Vec<D>& q) {
  double w[D];
  nearest_on(x, q, w);
  Vec<D> gap = q;
  for (int i = 0; i < D; ++i) gap -= x[i] * w[i];
  return norm2(gap);
}

/// Square of the distance from q, outside of a simplex, to it. `l`: barycentric coordinates of q,
/// becomes those of the nearest point. That lies on a face which q is outside of.
template <int D>
KOKKOS_FUNCTION
double square_distance_from_outside(const Vec<D> (&x)[D + 1], const Vec<D>& q, double (&l)[D + 1]) {
  double best = -1, nearest[D + 1];
  for (int f = 0; f <= D; ++f) {
    if (l[f] >= 0) continue;
    Vec<D> face[D], gap = q;
    for (int i = 0; i < D; ++i) face[i] = x[face_node<D>(f, i)];
    double w[D];
    nearest_on(face, q, w);
    for (int i = 0; i < D; ++i) gap -= face[i] * w[i];
    const double d2 = norm2(gap);
    if (best >= 0 && d2 >= best) continue;
    best = d2;
    nearest[f] = 0;
    for (int i = 0; i < D; ++i) nearest[face_node<D>(f, i)] = w[i];
  }
  for (int k = 0; k <= D; ++k) l[k] = nearest[k];
  return best;
}

/// The same to the simplex: zero inside.
template <int D>
KOKKOS_FUNCTION
double square_distance_to_simplex(const Vec<D> (&x)[D + 1], const Vec<D>& q, double (&l)[D + 1]) {
  barycentric(inverse(edge_matrix<D>(x)), x[0], q, l);
  bool within = true;
  for (int k = 0; k <= D; ++k) within = within && l[k] >= 0;
  return within ? 0 : square_distance_from_outside<D>(x, q, l);
}

}  // namespace breccia
