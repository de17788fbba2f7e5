#pragma once
#include "loops/contact_lists.hpp"

namespace breccia {

/// The faces of the mesh as a look at the released ones needs them.
template <int D>
struct ReleasedFaces {
  Index faces = 0;
  Kokkos::View<const std::uint8_t*, Memory> status, code;
  ConstRanges elements;
  ConstConnectivity<D> element_nodes;
  std::uint8_t released = 2;
  double own_weight = PointWeight<D>::gauss;  ///< of the contact points
};

/// known(face) = 1 where the surface has both sides of a released face.
template <int D>
void mark_known_releases(const ReleasedFaces<D>& in, const ContactSurface<D>& surface,
                         Array<std::uint8_t>& known);

/// Released faces that the surface does not have yet, ascending; returns how many.
template <int D>
Index list_new_releases(const ReleasedFaces<D>& in, const Array<std::uint8_t>& known,
                        Array<Index>& list);

/// Sets ContactSurface::piece from the pieces of the elements, without those of which a face has
/// been inserted or released; `cut` remembers them, by the element that names the piece.
template <int D>
void find_whole_pieces(const ReleasedFaces<D>& in, const Array<Index>& piece,
                       const Array<std::uint8_t>& cut, const ContactSurface<D>& surface);

/// True when the sides of one of the n listed faces touch at a contact point, or may within `time`:
/// their gap is at most the way that they go against each other meanwhile.
template <int D>
bool sides_meet(const ReleasedFaces<D>& in, const Array<Index>& list, Index n,
                const ConstVectors<D>& x, const ConstVectors<D>& v, double time);

extern template void find_whole_pieces<2>(const ReleasedFaces<2>&, const Array<Index>&,
                                          const Array<std::uint8_t>&, const ContactSurface<2>&);
extern template void find_whole_pieces<3>(const ReleasedFaces<3>&, const Array<Index>&,
                                          const Array<std::uint8_t>&, const ContactSurface<3>&);
extern template void mark_known_releases<2>(const ReleasedFaces<2>&, const ContactSurface<2>&,
                                            Array<std::uint8_t>&);
extern template void mark_known_releases<3>(const ReleasedFaces<3>&, const ContactSurface<3>&,
                                            Array<std::uint8_t>&);
extern template Index list_new_releases<2>(const ReleasedFaces<2>&, const Array<std::uint8_t>&,
                                           Array<Index>&);
extern template Index list_new_releases<3>(const ReleasedFaces<3>&, const Array<std::uint8_t>&,
                                           Array<Index>&);
extern template bool sides_meet<2>(const ReleasedFaces<2>&, const Array<Index>&, Index,
                                   const ConstVectors<2>&, const ConstVectors<2>&, double);
extern template bool sides_meet<3>(const ReleasedFaces<3>&, const Array<Index>&, Index,
                                   const ConstVectors<3>&, const ConstVectors<3>&, double);

}  // namespace breccia
