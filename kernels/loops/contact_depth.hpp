#pragma once
#include "base/mat.hpp"
#include "loops/contact_surface.hpp"
#include "point/contact_potential.hpp"

namespace breccia {

/// Level of nodes that are not near the surface.
inline constexpr std::uint8_t kFarLevel = 255;

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

/// Bubbles of an element (eq:contact-potential-1 and -2); most elements have none.
template <int D>
KOKKOS_FUNCTION
void find_bubbles(const SurfaceMesh<D>& mesh, Index e, double (&bubble)[D + 1]) {
  static_assert(D == 2, "contact in space follows");
  int edges = 0;
  for (int a = 0; a <= D; ++a) {
    bubble[a] = 0;
    edges += mesh.edge(mesh.nodes(e, a)) != 0 ? 1 : 0;
  }
  if (edges < D) return;
  Vec<D> x[D + 1];
  mesh.place(e, x);
  int faces = 0;
  for (int f = 0; f <= D; ++f) faces += mesh.on_surface(e, f) ? 1 : 0;
  const Mat<D> g = edge_matrix<D>(x);
  for (int f = 0; f <= D; ++f) {
    const int i = face_node<D>(f, 0), j = face_node<D>(f, 1);
    const double length = norm(x[j] - x[i]);
    if (faces == D + 1) {
      bubble[f] = -determinant(g) / length;
      continue;
    }
    if (mesh.on_surface(e, f) || mesh.edge(mesh.nodes(e, i)) == 0 ||
        mesh.edge(mesh.nodes(e, j)) == 0)
      continue;
    const Vec<D> middle = (x[i] + x[j]) * 0.5;
    typename SurfaceMesh<D>::Nearest best;
    mesh.offer_star(middle, mesh.nodes(e, i), best);
    mesh.offer_star(middle, mesh.nodes(e, j), best);
    mesh.walk(middle, best);
    const double d = best.facet == kNone ? 0.5 * length : Kokkos::sqrt(best.d2);
    bubble[f] = D * d;
  }
}

/// Adds an element's share of the smooth gradient at its corner a: gradient times `weight`.
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
void gradient_at_corner(const SurfaceMesh<D>& mesh, const CornerNumbers<D>& bubble,
                        const Array<double>& depth, Index e, int a, GradientShare<D>& share) {
  static_assert(D == 2, "contact in space follows");
  Vec<D> x[D + 1];
  mesh.place(e, x);
  const Mat<D> g = edge_matrix<D>(x);
  const Mat<D> inverted = inverse(g);
  const double volume = 0.5 * determinant(g);
  Vec<D> of[D + 1];  // gradients of the barycentric coordinates
  of[0] = Vec<D>::zero();
  for (int k = 1; k <= D; ++k) {
    for (int i = 0; i < D; ++i) of[k][i] = inverted(k - 1, i);
    of[0] -= of[k];
  }
  double b[D + 1];
  for (int f = 0; f <= D; ++f) b[f] = bubble(e, f);
  if (b[0] < 0) {
    // -b[f] * of[f] is the unit normal; the part under face f is as large as its length.
    for (int f = 0; f <= D; ++f)
      if (f != a) share.add(of[f] * -b[f], volume / 3);
    return;
  }
  Vec<D> base = Vec<D>::zero();
  for (int k = 0; k <= D; ++k) base += of[k] * depth(mesh.nodes(e, k));
  int parts = 0;
  for (int f = 0; f <= D; ++f) parts += f != a && b[f] > 0 ? 1 : 0;
  for (int f = 0; f <= D; ++f)  // chords that end here: phi grows towards their other end
    if (f != a && b[f] > 0) share.add(base + of[3 - a - f] * b[f], volume / parts);
  if (parts > 0) return;
  if (b[a] > 0) {
    for (int k = 0; k <= D; ++k)
      if (k != a) share.add(base + of[k] * b[a], volume / 2);
    return;
  }
  share.add(base, volume);
}

/// Smooth gradient of a ring node: the mean over the parts of its elements (ALGORITHMS ).
template <int D>
struct SmoothGradient {
  SurfaceMesh<D> mesh;
  Array<Index> ring;
  CornerNumbers<D> bubble;
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
    const bool sharp = norm(share.sum) <= kSharp * share.weight;
    set_row<D>(gradient, n, sharp ? Vec<D>::zero() : share.sum * (1 / share.weight));
  }
};

}  // namespace breccia
