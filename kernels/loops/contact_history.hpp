#pragma once
#include "base/sums.hpp"
#include "loops/contact_lists.hpp"

namespace breccia {

/// Memory of the contact points (point, slot): element that the point was last in, and its state
/// (depth, offset, stored, slip, force, viscous), see point/contact_law.hpp. A negative depth marks
/// a point that is apart: one that an interface has just `handed` over, of which only the slip is
/// known, or one that has `left` and whose law of friction remembers it.
template <int D>
struct ContactHistory {
  static constexpr int kNumbers = 3 + 3 * D;
  static constexpr double handed = -1, left = -2;
  enum { depth = 0, offset = 1, stored = 2, slip = 3, force = 3 + D, viscous = 3 + 2 * D };
  Kokkos::View<Index* [kContactSlots], Rows, Memory> element;
  Kokkos::View<double* [kContactSlots][kNumbers], Rows, Memory> state;
  /// Slip so far, slip rate, theta (see Rubbed); empty where all friction is Coulomb's.
  Kokkos::View<double* [kContactSlots][3], Rows, Memory> rubbed;
  // Which points sums and signals count: those whose element has a 1 in `own`; empty: all.
  Kokkos::View<const Index*, Memory> point;
  Kokkos::View<const std::uint8_t*, Memory> own;

  KOKKOS_FUNCTION
  bool counts(Index a) const {
    return own.extent(0) == 0 || own(point(a) / kFacePoints<D> / (D + 1)) != 0;
  }
};

/// Moves the memories of the points of the old list to their places in the new one; both ascend.
/// New points remember nothing.
template <int D>
void carry_history(const Array<Index>& old_point, Index old_points, const ContactHistory<D>& old,
                   const Array<Index>& point, Index points, const ContactHistory<D>& now);

/// Copies a list of points and their memories.
template <int D>
void copy_history(const Array<Index>& from_point, const ContactHistory<D>& from, Index points,
                  const Array<Index>& to_point, const ContactHistory<D>& to);

/// What interfaces leave to the points on the faces that they release (ALGORITHMS ).
template <int D>
struct ContactHandover {
  Array<Index> old_facet;  ///< facets before the release, ascending
  Index old_facets = 0;
  double own_weight = PointWeight<D>::gauss;  ///< of the contact points
  ConstConnectivity<D> element_faces;
  ConstRanges face_elements;
  Kokkos::View<const std::uint8_t*, Memory> face_code;
  Kokkos::View<const Index*, Memory> face_interface;
  /// Elastic slip of the right side against the left at the left face's corners, m.
  Kokkos::View<const double* [D][D], Rows, Memory> slip;
  /// Slip so far, slip rate and theta there; empty where contact does not ask for them.
  Kokkos::View<const double* [D][3], Rows, Memory> rubbed;
};

/// Starts the memories of points on faces that have just been released.
template <int D>
void take_over(const ContactHandover<D>& in, const ContactPairs<D>& pairs,
               const ContactHistory<D>& history);

/// Energy that the springs of all contacts hold, J; added up in a fixed order.
template <int D>
double stored_energy(const ContactHistory<D>& history, Index points);

/// Points that press.
template <int D>
Index pressing_points(const ContactHistory<D>& history, Index points);

/// The deepest point: its depth over the height of the elements at its face.
struct DeepestPoint {
  double share = 0;
  Index point = kNone;  ///< place in the list of points; none where nothing presses
};
template <int D>
DeepestPoint deepest_point(const ContactHistory<D>& history, const Array<Index>& facet,
                           const Array<double>& height, Index points);

extern template void carry_history<2>(const Array<Index>&, Index, const ContactHistory<2>&,
                                      const Array<Index>&, Index, const ContactHistory<2>&);
extern template void carry_history<3>(const Array<Index>&, Index, const ContactHistory<3>&,
                                      const Array<Index>&, Index, const ContactHistory<3>&);
extern template void copy_history<2>(const Array<Index>&, const ContactHistory<2>&, Index,
                                     const Array<Index>&, const ContactHistory<2>&);
extern template void copy_history<3>(const Array<Index>&, const ContactHistory<3>&, Index,
                                     const Array<Index>&, const ContactHistory<3>&);
extern template void take_over<2>(const ContactHandover<2>&, const ContactPairs<2>&,
                                  const ContactHistory<2>&);
extern template void take_over<3>(const ContactHandover<3>&, const ContactPairs<3>&,
                                  const ContactHistory<3>&);
extern template double stored_energy<2>(const ContactHistory<2>&, Index);
extern template double stored_energy<3>(const ContactHistory<3>&, Index);
extern template Index pressing_points<2>(const ContactHistory<2>&, Index);
extern template Index pressing_points<3>(const ContactHistory<3>&, Index);
extern template DeepestPoint deepest_point<2>(const ContactHistory<2>&, const Array<Index>&,
                                              const Array<double>&, Index);
extern template DeepestPoint deepest_point<3>(const ContactHistory<3>&, const Array<Index>&,
                                              const Array<double>&, Index);

}  // namespace breccia
