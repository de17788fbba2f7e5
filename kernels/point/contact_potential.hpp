#pragma once
#include "base/simplex.hpp"
#include "point/simplex_geometry.hpp"

namespace breccia {

/// Chords of an element: faces, then in space edges, all of whose nodes may lie on the surface
/// while they themselves are inside. In the plane the faces are the edges.
template <int D>
inline constexpr int kChords = D == 2 ? 3 : 10;
template <int D>
inline constexpr int kFirstEdge = D == 2 ? 0 : D + 1;

template <int D>
KOKKOS_INLINE_FUNCTION
constexpr int chord_size(int chord) {
  return chord <= D ? D : 2;
}

/// Node i of a chord.
template <int D>
KOKKOS_INLINE_FUNCTION
constexpr int chord_node(int chord, int i) {
  if (chord <= D) return face_node<D>(chord, i);
  constexpr int edge[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
  return edge[chord - D - 1][i];
}

/// Contact potential of one element: how deep a point is inside its piece of material (ALGORITHMS
///
///
// symbols  phi [m] depth below the surface      L_k [1] barycentric coordinates of the point
//          phi_k [m] depth of node k, measured in the reference configuration; 0 on the surface
//          b_ij, b_f [m] bubbles of edges and faces, see below
//          C_i [1] sum of the L_k of all nodes k that a chord joins to node i
//          G [1] gradient of phi, of length about 1
//          s_k,j [m] reference gradient at node k times reference edge j: the edges deform, the
//          numbers do not
// eq:contact-potential-1   phi = sum_k L_k phi_k
//                                + sum over edges ij of b_ij L_i L_j / max(C_i, C_j)
//                                + max over faces f of b_f min over the nodes i of f (L_i)
//   The further terms serve edges and faces that are not surface but whose nodes all are (a chord
//   across a corner or a thin strip): without them phi would vanish there. b_ij is twice the depth
//   at the middle of the edge: a tent min(L_i, L_j) where it is the only one, and the exact depth
//   in a strip or plate one element thick, where the L of each side add up. b_f is three times what
//   the edges leave of the depth at the middle of a face in space.
// eq:contact-potential-2   phi = min_f h_f L_f in an element all of whose faces are surface: its
//   exact depth. The heights h_f are stored as negative bubbles of the faces.
template <int D>
struct ContactPotential {
  double depth[D + 1];
  double bubble[kChords<D>];
  double slope[D + 1][D];

  KOKKOS_INLINE_FUNCTION
  bool single() const { return bubble[0] < 0; }

  struct Value {
    double phi;      ///< m
    double edge[D];  ///< gradient of phi in the element times edge j, m
  };

  /// phi and its gradient inside the element (eq:contact-potential-1 and -2).
  KOKKOS_FUNCTION
  Value value(const double (&l)[D + 1]) const {
    if (single()) return single_value(l);
    Value r{0, {}};
    for (int k = 0; k <= D; ++k) r.phi += l[k] * depth[k];
    for (int j = 0; j < D; ++j) r.edge[j] = depth[j + 1] - depth[0];
    bool any = false;
    for (int c = 0; c < kChords<D>; ++c) any = any || bubble[c] != 0;
    if (!any) return r;
    add_edges(l, r);
    if constexpr (D == 3) add_faces(l, r);
    return r;
  }

  /// Smooth gradient: that of the nodes, interpolated. Where a node has none (all zero, see kSharp)
  /// the exact one of the element, `own`, stands in for it; where that node is a sharp corner of
  /// the body, in the whole element: a flat side pushes along its normal up to its end, and
  /// half-smooth directions next to a corner would make energy.
  KOKKOS_FUNCTION
  void smooth(const double (&l)[D + 1], const double (&own)[D], double (&edge)[D]) const {
    bool sharp[D + 1], corner = false;
    for (int k = 0; k <= D; ++k) {
      sharp[k] = true;
      for (int j = 0; j < D; ++j) sharp[k] = sharp[k] && slope[k][j] == 0;
      corner = corner || (sharp[k] && depth[k] == 0);
    }
    for (int j = 0; j < D; ++j) {
      edge[j] = 0;
      for (int k = 0; k <= D; ++k) edge[j] += l[k] * (corner || sharp[k] ? own[j] : slope[k][j]);
    }
  }

 private:
  KOKKOS_FUNCTION
  Value single_value(const double (&l)[D + 1]) const {
    Value r{-bubble[0] * l[0], {}};
    int least = 0;
    for (int f = 1; f <= D; ++f)
      if (-bubble[f] * l[f] < r.phi) {
        r.phi = -bubble[f] * l[f];
        least = f;
      }
    for (int j = 0; j < D; ++j) r.edge[j] = 0;
    add_weight(least, -bubble[least], r.edge);
    return r;
  }

  KOKKOS_FUNCTION
  void add_edges(const double (&l)[D + 1], Value& r) const {
    double joined[D + 1];
    for (int k = 0; k <= D; ++k) joined[k] = 0;
    for_each_edge([&](int i, int j, double) {
      joined[i] += l[j];
      joined[j] += l[i];
    });
    for_each_edge([&](int i, int j, double height) {
      const int most = joined[i] < joined[j] ? j : i;
      if (!(joined[most] > 0)) return;
      const double share = height / joined[most], part = share * l[i] * l[j];
      r.phi += part;
      add_weight(i, share * l[j], r.edge);
      add_weight(j, share * l[i], r.edge);
      for_each_edge([&](int a, int b, double) {
        if (a == most) add_weight(b, -part / joined[most], r.edge);
        if (b == most) add_weight(a, -part / joined[most], r.edge);
      });
    });
  }

  KOKKOS_FUNCTION
  void add_faces(const double (&l)[D + 1], Value& r) const {
    int node = -1;
    double most = 0, height = 0;
    for (int c = 0; c < kFirstEdge<D>; ++c) {
      if (bubble[c] == 0) continue;
      int least = chord_node<D>(c, 0);
      for (int i = 1; i < chord_size<D>(c); ++i)
        if (l[chord_node<D>(c, i)] < l[least]) least = chord_node<D>(c, i);
      if (node >= 0 && !(bubble[c] * l[least] > most)) continue;
      most = bubble[c] * l[least];
      height = bubble[c];
      node = least;
    }
    if (node < 0) return;
    r.phi += most;
    add_weight(node, height, r.edge);
  }

  /// f(node, node, bubble) for the edges that are chords.
  template <class Function>
  KOKKOS_INLINE_FUNCTION
  void for_each_edge(const Function& f) const {
    for (int c = kFirstEdge<D>; c < kChords<D>; ++c)
      if (bubble[c] != 0) f(chord_node<D>(c, 0), chord_node<D>(c, 1), bubble[c]);
  }

  /// Adds height times the gradient of L_node.
  KOKKOS_INLINE_FUNCTION
  static void add_weight(int node, double height, double (&edge)[D]) {
    for (int j = 0; j < D; ++j) edge[j] += node == 0 ? -height : (node == j + 1 ? height : 0.0);
  }
};

/// A gradient given by its products with the edges, in space: solves G . edge_j = product_j.
template <int D>
KOKKOS_INLINE_FUNCTION
Vec<D> gradient_in_space(const Mat<D>& inverse_edges, const double (&product)[D]) {
  Vec<D> g = Vec<D>::zero();
  for (int j = 0; j < D; ++j)
    for (int i = 0; i < D; ++i) g[i] += inverse_edges(j, i) * product[j];
  return g;
}

/// The mean of unit gradients is the shorter the more they differ: cos(a / 2) where two faces meet
/// at an angle a. Shorter than this (a above 40 degrees in the plane, 50 in space) the node is a
/// corner that nobody meant to be round, and is left unsmoothed. In the plane smoothed heptagons
/// (51 degrees) made a quarter more energy out of their collisions.
template <int D>
inline constexpr double kSharp = D == 2 ? 0.94 : 0.9;

/// Shorter than this, a gradient says nothing (in the middle of a thin strip, say).
inline constexpr double kShortGradient = 0.2;

/// How phi falls at a point.
template <int D>
struct ContactDirection {
  Vec<D> normal;  ///< of the target, outwards
  double slope;   ///< length of the gradient, 1 in the reference configuration of a flat surface
};

/// Along the smooth gradient, or (`smooth` false) along the exact gradient of phi in the element.
/// When both are too short, along `instead` of any length (the reversed normal of the contactor's
/// face).
template <int D>
KOKKOS_FUNCTION
ContactDirection<D> contact_direction(const ContactPotential<D>& potential,
                                      const double (&l)[D + 1], const double (&edge)[D],
                                      const Mat<D>& inverse_edges, bool smooth,
                                      const Vec<D>& instead) {
  if (smooth) {
    double product[D];
    potential.smooth(l, edge, product);
    const Vec<D> g = gradient_in_space<D>(inverse_edges, product);
    const double length = norm(g);
    if (length >= kShortGradient) return {g * (-1 / length), length};
  }
  const Vec<D> g = gradient_in_space<D>(inverse_edges, edge);
  const double length = norm(g);
  if (length >= kShortGradient) return {g * (-1 / length), length};
  return {instead * (1 / norm(instead)), 1};
}

}  // namespace breccia
