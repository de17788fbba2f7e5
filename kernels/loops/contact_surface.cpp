#include "loops/contact_surface.hpp"

#include "loops/contact_depth.hpp"
#include "loops/list_tools.hpp"

namespace breccia {

namespace {

/// Marks the faces that are surface and measures the elements behind them.
template <int D>
struct MarkFacet {
  ContactSurfaceIn<D> in;
  Array<std::uint8_t> surface, edge;
  Array<double> height;

  KOKKOS_FUNCTION
  double ratio(Index e, int f) const {
    Vec<D> x[D + 1];
    for (int a = 0; a <= D; ++a) x[a] = row<D>(in.reference, in.element_nodes(e, a));
    Vec<D> face[D];
    for (int i = 0; i < D; ++i) face[i] = x[face_node<D>(f, i)];
    return determinant(edge_matrix<D>(x)) / (kFactorial<D> * norm(face_normal(face)));
  }

  KOKKOS_FUNCTION
  void facet(Index e, int f, double h) const {
    surface(e * (D + 1) + f) = surface_mark::facet;
    height(e * (D + 1) + f) = h;
    for (int k = 0; k < D; ++k) expose(e, f, k);
  }

  /// Several threads may do this to one node, all of them the same.
  KOKKOS_FUNCTION
  void expose(Index e, int f, int k) const {
    Kokkos::atomic_store(&edge(in.element_nodes(e, face_node<D>(f, k))), std::uint8_t(1));
  }

  KOKKOS_FUNCTION
  void free(Index i) const {
    const Index number = in.free_facet(i), e = number / (D + 1);
    facet(e, number % (D + 1), ratio(e, number % (D + 1)));
  }

  KOKKOS_FUNCTION
  void shared(Index face) const {
    const std::uint8_t status = in.face_status(face), code = in.face_code(face);
    if (status != in.released && status != in.inserted) return;
    const Index left = in.face_elements(face, 0), right = in.face_elements(face, 1);
    const int i = code & 3, j = (code >> 2) & 3;
    if (status == in.released) {
      const double h = 0.5 * (ratio(left, i) + ratio(right, j));
      facet(left, i, h);
      facet(right, j, h);
      return;
    }
    std::uint8_t of_left = 0, of_right = 0;
    for (int k = 0; k < D; ++k) {
      const int m = opposite_face_node<D>(code >> 4, k);
      if (in.element_nodes(left, face_node<D>(i, k)) == in.element_nodes(right, face_node<D>(j, m)))
        continue;
      of_left |= surface_mark::first_node << k;
      of_right |= surface_mark::first_node << m;
      expose(left, i, k);
      expose(right, j, m);
    }
    surface(left * (D + 1) + i) = of_left;
    surface(right * (D + 1) + j) = of_right;
  }
};

template <int D>
void find_facets(const ContactSurfaceIn<D>& in, ContactScratch<D>& scratch,
                 ContactSurface<D>& surface) {
  const Index sides = in.elements * (D + 1);
  make_room(scratch.surface, sides);
  make_room(scratch.height, sides);
  Kokkos::deep_copy(Exec(), scratch.surface, std::uint8_t(0));
  make_room(scratch.edge, in.nodes);
  Kokkos::deep_copy(Exec(), scratch.edge, std::uint8_t(0));
  const MarkFacet<D> mark{in, scratch.surface, scratch.edge, scratch.height};
  for_each(
      "breccia::contact::free_faces", static_cast<Index>(in.free_facet.extent(0)),
      KOKKOS_LAMBDA(Index i) { mark.free(i); });
  if (in.face_status.extent(0) > 0)
    for_each(
        "breccia::contact::released_faces", in.faces, KOKKOS_LAMBDA(Index i) { mark.shared(i); });
  const Array<std::uint8_t> marked = scratch.surface;
  surface.facets = list_where(
      "breccia::contact::facets", sides,
      KOKKOS_LAMBDA(Index i) { return (marked(i) & surface_mark::facet) != 0; }, surface.facet);
}

/// Nodes by their distance to the surface in edges, up to layers + 1; returns how many lie on the
/// last level.
template <int D>
Index find_ring(const ContactSurfaceIn<D>& in, ContactScratch<D>& scratch,
                const ContactSurface<D>& surface, Index& ring_nodes) {
  make_room(scratch.level, in.nodes);
  Kokkos::deep_copy(Exec(), scratch.level, kFarLevel);
  const Array<std::uint8_t> level = scratch.level;
  const Array<Index> facet = surface.facet;
  // Several threads may write one place, all of them the same value.
  for_each(
      "breccia::contact::surface_nodes", surface.facets, KOKKOS_LAMBDA(Index i) {
        const Index e = facet(i) / (D + 1);
        for (int k = 0; k < D; ++k)
          Kokkos::atomic_store(&level(in.element_nodes(e, face_node<D>(facet(i) % (D + 1), k))),
                               std::uint8_t(0));
      });
  Index last = 0;
  for (Index s = 0; s <= in.layers; ++s) {
    const auto now = static_cast<std::uint8_t>(s), next = static_cast<std::uint8_t>(s + 1);
    last = list_where(
        "breccia::contact::ring", in.nodes, KOKKOS_LAMBDA(Index n) { return level(n) == now; },
        scratch.ring);
    const Array<Index> front = scratch.ring;
    for_each(
        "breccia::contact::next_level", last, KOKKOS_LAMBDA(Index i) {
          const Index n = front(i);
          for (Index k = in.corners(n, 0); k < in.corners(n, 1); ++k)
            for (int a = 0; a <= D; ++a) {
              std::uint8_t& other = level(in.element_nodes(in.corner_list(k) / (D + 1), a));
              if (Kokkos::atomic_load(&other) == kFarLevel) Kokkos::atomic_store(&other, next);
            }
        });
  }
  const auto deepest = static_cast<std::uint8_t>(in.layers + 1);
  last = count_where(
      "breccia::contact::ring", in.nodes, KOKKOS_LAMBDA(Index n) {
        return level(n) == deepest && (in.mass.extent(0) == 0 || in.mass(n) > 0);
      });
  ring_nodes = list_where(
      "breccia::contact::ring", in.nodes, KOKKOS_LAMBDA(Index n) { return level(n) != kFarLevel; },
      scratch.ring);
  return last;
}

template <int D>
void find_targets(const ContactSurfaceIn<D>& in, ContactScratch<D>& scratch,
                  ContactSurface<D>& surface, Index ring_nodes) {
  make_room(scratch.chosen, in.elements);
  Kokkos::deep_copy(Exec(), scratch.chosen, std::uint8_t(0));
  const Array<std::uint8_t> chosen = scratch.chosen, level = scratch.level;
  const Array<Index> ring = scratch.ring;
  const Index layers = in.layers;
  for_each(
      "breccia::contact::choose", ring_nodes, KOKKOS_LAMBDA(Index i) {
        const Index n = ring(i);
        if (level(n) > layers) return;
        for (Index k = in.corners(n, 0); k < in.corners(n, 1); ++k) {
          const Index e = in.corner_list(k) / (D + 1);
          if (in.share.extent(0) > 0 && in.share(e) < 1) continue;
          Kokkos::atomic_store(&chosen(e), std::uint8_t(1));
        }
      });
  surface.targets = list_where(
      "breccia::contact::targets", in.elements, KOKKOS_LAMBDA(Index e) { return chosen(e) != 0; },
      surface.target);
  make_room(surface.piece, surface.targets);
  Kokkos::deep_copy(Exec(), surface.piece, kNone);
  make_room(surface.rim, surface.targets);
  make_room(surface.nodes, surface.targets);
  make_room(surface.place, surface.targets);
  make_room(surface.depth, surface.targets);
  make_room(surface.bubble, surface.targets);
  make_room(surface.slope, surface.targets);
}

template <int D>
void find_depth(const SurfaceMesh<D>& mesh, const ContactSurfaceIn<D>& in,
                ContactScratch<D>& scratch, Index ring_nodes) {
  make_room(scratch.nearest, in.nodes);
  make_room(scratch.nearer, in.nodes);
  make_room(scratch.depth, in.nodes);
  make_room(scratch.gradient, in.nodes);
  make_room(scratch.bubble, in.elements);
  const ChordNumbers<D> bubble = scratch.bubble;
  for_each(
      "breccia::contact::bubbles", in.elements, KOKKOS_LAMBDA(Index e) {
        if (!mesh.known(e)) return;
        double b[kChords<D>];
        find_bubbles<D>(mesh, e, b);
        for (int c = 0; c < kChords<D>; ++c) bubble(e, c) = b[c];
      });
  NearestFacet<D> nearest{mesh,          scratch.ring, scratch.nearest, scratch.nearest,
                          scratch.depth, true};
  // A level looks at lower ones only, so nobody reads what another one writes.
  for (Index s = 0; s <= in.layers + 1; ++s) {
    const auto now = static_cast<std::uint8_t>(s);
    const Array<Index> ring = scratch.ring;
    const Array<std::uint8_t> level = scratch.level;
    for_each(
        "breccia::contact::depth", ring_nodes, KOKKOS_LAMBDA(Index i) {
          if (level(ring(i)) == now) nearest(i);
        });
  }
  nearest.lower = false;
  nearest.to = scratch.nearer;
  for_each("breccia::contact::depth", ring_nodes, nearest);
  for_each("breccia::contact::gradient", ring_nodes,
           SmoothGradient<D>{mesh, scratch.ring, bubble, scratch.depth, scratch.gradient});
}

template <int D>
struct FillTarget {
  SurfaceMesh<D> mesh;
  ContactSurface<D> surface;
  ChordNumbers<D> bubble;
  Array<double> depth;
  Vectors<D> gradient;
  Index layers;

  KOKKOS_FUNCTION
  void operator()(Index t) const {
    const Index e = surface.target(t);
    Vec<D> x[D + 1];
    mesh.place(e, x);
    const Mat<D> g = edge_matrix<D>(x);
    int nearest = kFarLevel;
    for (int a = 0; a <= D; ++a) {
      const Index n = mesh.nodes(e, a);
      nearest = mesh.level(n) < nearest ? mesh.level(n) : nearest;
      surface.nodes(t, a) = n;
      surface.depth(t, a) = depth(n);
      for (int j = 0; j < D; ++j) {
        double s = 0;
        for (int i = 0; i < D; ++i) s += gradient(n, i) * g(i, j);
        surface.slope(t, a, j) = s;
      }
    }
    for (int c = 0; c < kChords<D>; ++c) surface.bubble(t, c) = bubble(e, c);
    surface.rim(t) = nearest == layers ? 1 : 0;
  }
};

template <int D>
void measure_facets(const ContactSurfaceIn<D>& in, const ContactScratch<D>& scratch,
                    ContactSurface<D>& surface) {
  make_room(surface.area, surface.facets);
  make_room(surface.height, surface.facets);
  make_room(surface.facet_target, surface.facets);
  const ContactSurface<D> s = surface;
  const Array<double> height = scratch.height;
  for_each(
      "breccia::contact::measure", surface.facets, KOKKOS_LAMBDA(Index i) {
        const Index facet = s.facet(i), e = facet / (D + 1);
        const int f = facet % (D + 1);
        Vec<D> x[D];
        for (int k = 0; k < D; ++k)
          x[k] = row<D>(in.reference, in.element_nodes(e, face_node<D>(f, k)));
        s.area(i) = norm(face_normal(x)) * in.thickness;
        s.height(i) = height(facet);
        s.facet_target(i) = find_in(s.target, s.targets, e);
      });
}

}  // namespace

template <int D>
bool update_contact_surface(const ContactSurfaceIn<D>& in, ContactScratch<D>& scratch,
                            ContactSurface<D>& surface) {
  find_facets(in, scratch, surface);
  Index ring_nodes = 0;
  const Index deepest = find_ring(in, scratch, surface, ring_nodes);
  find_targets(in, scratch, surface, ring_nodes);
  const SurfaceMesh<D> mesh{in.element_nodes, in.reference,  in.corners,  in.corner_list,
                            scratch.surface,  scratch.level, scratch.edge};
  find_depth(mesh, in, scratch, ring_nodes);
  for_each(
      "breccia::contact::fill_targets", surface.targets,
      FillTarget<D>{mesh, surface, scratch.bubble, scratch.depth, scratch.gradient, in.layers});
  measure_facets(in, scratch, surface);
  return deepest > 0;
}

template <int D>
void refresh_contact_nodes(const ConstConnectivity<D>& element_nodes,
                           const ContactSurface<D>& surface) {
  for_each(
      "breccia::contact::refresh_nodes", surface.targets, KOKKOS_LAMBDA(Index t) {
        for (int a = 0; a <= D; ++a) surface.nodes(t, a) = element_nodes(surface.target(t), a);
      });
}

template bool update_contact_surface<2>(const ContactSurfaceIn<2>&, ContactScratch<2>&,
                                        ContactSurface<2>&);
template bool update_contact_surface<3>(const ContactSurfaceIn<3>&, ContactScratch<3>&,
                                        ContactSurface<3>&);
template void refresh_contact_nodes<2>(const ConstConnectivity<2>&, const ContactSurface<2>&);
template void refresh_contact_nodes<3>(const ConstConnectivity<3>&, const ContactSurface<3>&);

}  // namespace breccia
