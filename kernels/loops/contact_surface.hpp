#pragma once
#include "loops/contact_lists.hpp"

namespace breccia {

/// What the surface of all bodies is made from.
template <int D>
struct ContactSurfaceIn {
  Index nodes = 0, elements = 0, faces = 0;
  ConstConnectivity<D> element_nodes;
  ConstVectors<D> reference;
  ConstRanges corners;
  Kokkos::View<const Index*, Memory> corner_list;
  Array<Index> free_facet;                                ///< element * (D + 1) + local face
  Kokkos::View<const std::uint8_t*, Memory> face_status;  ///< empty where nothing can break
  Kokkos::View<const std::uint8_t*, Memory> face_code;
  ConstRanges face_elements;
  std::uint8_t released = 2, inserted = 1;    ///< status of a broken face, and of one that may yet
  Kokkos::View<const double*, Memory> share;  ///< below 1: being excavated, no target; empty: all
  Kokkos::View<const double*, Memory> mass;  ///< of nodes; only those with mass tell whether deeper
                                             ///< elements exist; empty: all
  double thickness = 1;
  Index layers = 2;  ///< elements behind the surface that are targets, besides the first
};

/// Marks of an element's face: on the surface; nodes at which an inserted face has come apart. An
/// inserted face presses nobody (its own law does), but what lies at it is as exposed as at the
/// surface, so phi is zero there.
namespace surface_mark {
inline constexpr std::uint8_t facet = 1, first_node = 2;
}

/// Memory of the update, kept from one to the next.
template <int D>
struct ContactScratch {
  Array<std::uint8_t> surface;  ///< per element face: SurfaceMark
  Array<double> height;         ///< per element face, where it is on the surface
  Array<std::uint8_t> level;    ///< per node: number of edges to the surface
  Array<std::uint8_t> edge;     ///< per node: 1 where phi is zero
  Array<std::uint8_t> chosen;   ///< per element
  Array<Index> ring, nearest, nearer;
  ChordNumbers<D> bubble;  ///< per element, near the surface
  Array<double> depth;     ///< per node
  Vectors<D> gradient;     ///< per node
};

/// Facets, targets and their potential (ALGORITHMS ), from the reference configuration:
/// depth of a node = its distance to the nearest facet of its own piece, exact where the chain of
/// nearest facets leads
/// there. Only nodes within `layers` + 1 edges of the surface are worked on. Returns true where
/// deeper elements exist.
template <int D>
bool update_contact_surface(const ContactSurfaceIn<D>& in, ContactScratch<D>& scratch,
                            ContactSurface<D>& surface);

/// Current nodes of the targets; to be called after nodes have split.
template <int D>
void refresh_contact_nodes(const ConstConnectivity<D>& element_nodes,
                           const ContactSurface<D>& surface);

extern template bool update_contact_surface<2>(const ContactSurfaceIn<2>&, ContactScratch<2>&,
                                               ContactSurface<2>&);
extern template bool update_contact_surface<3>(const ContactSurfaceIn<3>&, ContactScratch<3>&,
                                               ContactSurface<3>&);
extern template void refresh_contact_nodes<2>(const ConstConnectivity<2>&,
                                              const ContactSurface<2>&);
extern template void refresh_contact_nodes<3>(const ConstConnectivity<3>&,
                                              const ContactSurface<3>&);

}  // namespace breccia
