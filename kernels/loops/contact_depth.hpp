#pragma once
#include "base/mat.hpp"
#include "loops/contact_surface.hpp"
#include "loops/element.hpp"
#include "point/contact_potential.hpp"

namespace breccia {

/// Level of nodes that are not near the surface.
inline constexpr std::uint8_t kFarLevel = 255;

/// A chord no deeper than this share of its length is surface.
inline constexpr double kOnSurface = 1e-9;

/// The reference mesh near the surface as the loops over nodes and targets see it.
template <int D>
struct SurfaceMesh {
  ConstConnectivity<D> nodes;
  ConstVectors<D> reference;
  ConstRanges corners;
  Kokkos::View<const Index*, Memory> corner_list;
  Kokkos::View<const std::uint8_t*, Memory> surface;
  Array<std::uint8_t> level, edge;

  /// On the surface, or inserted and open along its whole length.
  KOKKOS_FUNCTION
  bool on_surface(Index e, int f) const {
    constexpr int kOpen = ((1 << D) - 1) * surface_mark::first_node;
    const int mark = surface(e * (D + 1) + f);
    return (mark & surface_mark::facet) != 0 || (mark & kOpen) == kOpen;
  }

  KOKKOS_FUNCTION
  double square_distance(const Vec<D>& q, Index facet) const {
    const Index e = facet / (D + 1);
    const int f = facet % (D + 1);
    Vec<D> x[D];
    for (int i = 0; i < D; ++i) x[i] = row<D>(reference, nodes(e, face_node<D>(f, i)));
    return square_distance_to_face<D>(x, q);
  }

  /// All nodes of the element are near the surface.
  KOKKOS_FUNCTION
  bool known(Index e) const {
    bool is = true;
    for (int a = 0; a <= D; ++a) is = is && level(nodes(e, a)) != kFarLevel;
    return is;
  }

  KOKKOS_FUNCTION
  void place(Index e, Vec<D> (&x)[D + 1]) const {
    for (int a = 0; a <= D; ++a) x[a] = row<D>(reference, nodes(e, a));
  }

  /// Facet nearest to a point so far.
  struct Nearest {
    Index facet = kNone;
    double d2 = 0;
  };

  KOKKOS_FUNCTION
  void offer(const Vec<D>& q, Index facet, Nearest& best) const {
    if (facet == kNone || facet == best.facet) return;
    const double d2 = square_distance(q, facet);
    if (best.facet != kNone && (d2 > best.d2 || (d2 == best.d2 && facet > best.facet))) return;
    best = {facet, d2};
  }

  /// Offers the facets at a surface node.
  KOKKOS_FUNCTION
  void offer_star(const Vec<D>& q, Index node, Nearest& best) const {
    for (Index k = corners(node, 0); k < corners(node, 1); ++k) {
      const Index corner = corner_list(k), e = corner / (D + 1);
      const int a = corner % (D + 1);
      for (int f = 0; f <= D; ++f)
        if (f != a && on_surface(e, f)) offer(q, e * (D + 1) + f, best);
    }
  }

  /// Walks along the surface as long as that leads nearer.
  KOKKOS_FUNCTION
  void walk(const Vec<D>& q, Nearest& best) const {
    for (int way = 0; way < 8 && best.facet != kNone; ++way) {
      const Index from = best.facet, e = from / (D + 1);
      for (int i = 0; i < D; ++i) offer_star(q, nodes(e, face_node<D>(from % (D + 1), i)), best);
      if (best.facet == from) return;
    }
  }
};

/// Nearest facet of a ring node from its neighbours; `lower` admits only nodes nearer to the
/// surface.
template <int D>
struct NearestFacet {
  SurfaceMesh<D> mesh;
  Array<Index> ring, from, to;
  Array<double> depth;
  bool lower;

  KOKKOS_FUNCTION
  void operator()(Index i) const {
    const Index n = ring(i);
    const std::uint8_t level = mesh.level(n);
    if (mesh.edge(n) != 0) {
      depth(n) = 0;
      to(n) = kNone;
      return;
    }
    const Vec<D> q = row<D>(mesh.reference, n);
    typename SurfaceMesh<D>::Nearest best;
    double bound = -1;
    if (!lower) mesh.offer(q, from(n), best);
    for (Index k = mesh.corners(n, 0); k < mesh.corners(n, 1); ++k) {
      const Index e = mesh.corner_list(k) / (D + 1);
      for (int a = 0; a <= D; ++a) {
        const Index m = mesh.nodes(e, a);
        const std::uint8_t other = mesh.level(m);
        if (m == n || other == kFarLevel) continue;
        if (mesh.edge(m) != 0) {
          const double d2 = norm2(row<D>(mesh.reference, m) - q);
          bound = bound < 0 || d2 < bound ? d2 : bound;
          mesh.offer_star(q, m, best);
        } else if (!lower || other < level) {
          mesh.offer(q, from(m), best);
        }
      }
    }
    mesh.walk(q, best);
    to(n) = best.facet;
    const bool node_is_nearer = best.facet == kNone || (bound >= 0 && bound < best.d2);
    depth(n) = Kokkos::sqrt(node_is_nearer ? bound : best.d2);
  }
};

/// Depth at the middle of a chord, all of whose nodes lie on the surface.
template <int D>
KOKKOS_FUNCTION
double depth_of_chord(const SurfaceMesh<D>& mesh, Index e, int chord, const Vec<D> (&x)[D + 1]) {
  const int size = chord_size<D>(chord);
  Vec<D> middle = Vec<D>::zero();
  for (int i = 0; i < size; ++i) middle += x[chord_node<D>(chord, i)] * (1.0 / size);
  typename SurfaceMesh<D>::Nearest best;
  for (int i = 0; i < size; ++i)
    mesh.offer_star(middle, mesh.nodes(e, chord_node<D>(chord, i)), best);
  mesh.walk(middle, best);
  if (best.facet != kNone) return Kokkos::sqrt(best.d2);
  return norm(x[chord_node<D>(chord, 0)] - middle);
}

/// The same where it is a chord, else 0.
template <int D>
KOKKOS_FUNCTION
double depth_if_chord(const SurfaceMesh<D>& mesh, Index e, int c, const Vec<D> (&x)[D + 1]) {
  if (c <= D && mesh.on_surface(e, c)) return 0;
  for (int i = 0; i < chord_size<D>(c); ++i)
    if (mesh.edge(mesh.nodes(e, chord_node<D>(c, i))) == 0) return 0;
  const double depth = depth_of_chord<D>(mesh, e, c, x);
  const double length = norm(x[chord_node<D>(c, 1)] - x[chord_node<D>(c, 0)]);
  return depth > kOnSurface * length ? depth : 0;
}

/// Bubbles of an element (eq:contact-potential-1 and -2); most elements have none.
template <int D>
KOKKOS_FUNCTION
void find_bubbles(const SurfaceMesh<D>& mesh, Index e, double (&bubble)[kChords<D>]) {
  int outer = 0, faces = 0;
  for (int c = 0; c < kChords<D>; ++c) bubble[c] = 0;
  for (int a = 0; a <= D; ++a) outer += mesh.edge(mesh.nodes(e, a)) != 0 ? 1 : 0;
  if (outer < 2) return;
  Vec<D> x[D + 1];
  mesh.place(e, x);
  for (int f = 0; f <= D; ++f) faces += mesh.on_surface(e, f) ? 1 : 0;
  if (faces == D + 1) {
    for (int c = 0; c <= D; ++c) {
      Vec<D> face[D];
      for (int i = 0; i < D; ++i) face[i] = x[face_node<D>(c, i)];
      bubble[c] = -determinant(edge_matrix<D>(x)) / ((D - 1) * norm(face_normal(face)));
    }
    return;
  }
  for (int c = kFirstEdge<D>; c < kChords<D>; ++c) bubble[c] = 2 * depth_if_chord<D>(mesh, e, c, x);
  if constexpr (D == 3) {
    // What the edges leave at the middles of faces.
    ContactPotential<D> edges{};
    for (int c = 0; c < kChords<D>; ++c) edges.bubble[c] = bubble[c];
    for (int c = 0; c <= D; ++c) {
      double middle[D + 1];
      for (int k = 0; k <= D; ++k) middle[k] = k == c ? 0.0 : 1.0 / D;
      const double left = depth_if_chord<D>(mesh, e, c, x) - edges.value(middle).phi;
      bubble[c] = D * Kokkos::max(0.0, left);
    }
  }
}

/// Directions from a corner into its element, as weights of the other nodes; all see as much of it.
template <int D>
inline constexpr int kLooks = D == 2 ? 2 : 6;
template <int D>
KOKKOS_INLINE_FUNCTION
constexpr double look_weight(int look, int i) {
  if constexpr (D == 2) {
    return look == i ? 0.75 : 0.25;
  } else {
    constexpr double weight[6][3] = {{0.6, 0.3, 0.1}, {0.6, 0.1, 0.3}, {0.3, 0.6, 0.1},
                                     {0.1, 0.6, 0.3}, {0.3, 0.1, 0.6}, {0.1, 0.3, 0.6}};
    return weight[look][i];
  }
}

/// A mean of gradients.
template <int D>
struct GradientShare {
  Vec<D> sum = Vec<D>::zero();
  double weight = 0;

  KOKKOS_FUNCTION
  void add(const Vec<D>& g, double w) {
    sum += g * w;
    weight += w;
  }
};

/// Gradient of phi next to corner a of an element, averaged over the parts of the element that
/// touch the corner.
template <int D>
KOKKOS_FUNCTION
void gradient_at_corner(const SurfaceMesh<D>& mesh, const ChordNumbers<D>& bubble,
                        const Array<double>& depth, Index e, int a, GradientShare<D>& share) {
  constexpr double kNear = 0.001;
  Vec<D> x[D + 1];
  mesh.place(e, x);
  const Mat<D> g = edge_matrix<D>(x);
  const Mat<D> inverted = inverse(g);
  const double volume = determinant(g) / kFactorial<D>;
  ContactPotential<D> potential;
  bool plain = true;
  for (int c = 0; c < kChords<D>; ++c) {
    potential.bubble[c] = bubble(e, c);
    plain = plain && potential.bubble[c] == 0;
  }
  for (int k = 0; k <= D; ++k) potential.depth[k] = depth(mesh.nodes(e, k));
  const int looks = plain ? 1 : kLooks<D>;
  for (int look = 0; look < looks; ++look) {
    double l[D + 1];
    l[a] = 1 - kNear;
    for (int k = 0, i = 0; k <= D; ++k)
      if (k != a) l[k] = kNear * look_weight<D>(look, i++);
    share.add(gradient_in_space<D>(inverted, potential.value(l).edge), volume / looks);
  }
}

/// Smooth gradient of a ring node: the mean over the parts of its elements (ALGORITHMS ).
template <int D>
struct SmoothGradient {
  SurfaceMesh<D> mesh;
  Array<Index> ring;
  ChordNumbers<D> bubble;
  Array<double> depth;
  Vectors<D> gradient;

  KOKKOS_FUNCTION
  void operator()(Index i) const {
    const Index n = ring(i);
    GradientShare<D> share;
    for (Index k = mesh.corners(n, 0); k < mesh.corners(n, 1); ++k) {
      const Index corner = mesh.corner_list(k), e = corner / (D + 1);
      if (mesh.known(e)) gradient_at_corner<D>(mesh, bubble, depth, e, corner % (D + 1), share);
    }
    const bool sharp = norm(share.sum) <= kSharp<D> * share.weight;
    set_row<D>(gradient, n, sharp ? Vec<D>::zero() : share.sum * (1 / share.weight));
  }
};

}  // namespace breccia
