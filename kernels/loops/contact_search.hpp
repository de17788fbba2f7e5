#pragma once
#include "loops/contact_lists.hpp"

namespace breccia {

/// Targets rendered to the cells of a few grids, each coarser than the one before; a target lies in
/// the grid that fits its size. Cells are kept in a hash table.
template <int D>
struct ContactBins {
  Index entries = 0, buckets = 0;
  std::uint32_t levels = 0;  ///< bit l: grid l holds targets
  double cell = 0;           ///< m, of the finest grid
  Array<Index> begin;        ///< per bucket + 1
  Array<Index> fill;
  Array<std::uint64_t> tag;  ///< per entry: the cell, exactly
  Array<Index> target;       ///< per entry
  Array<Index> piece;        ///< per entry: of its target
  Kokkos::View<double * [2 * D], Rows, Memory>
      box;  ///< of the targets with their skin: low, high; m
};

/// Targets of a point that are remembered between the two looks of the search.
inline constexpr Index kFirstBoxes = 4;

/// Memory of the search, kept from one to the next.
template <int D>
struct ContactSearchScratch {
  ContactBins<D> bins;
  Array<Index> count;
  Kokkos::View<Index* [kFirstBoxes], Rows, Memory> first;  ///< per point: in whose boxes it is
  Array<Index> active, kept;        ///< points in a box; those of them with candidates
  Array<Index> found_begin, found;  ///< candidates of the active points
};

/// Remembers where the targets' nodes are now.
template <int D>
void take_contact_places(const ConstVectors<D>& x, const ContactSurface<D>& surface);

/// Lists the nodes of the targets and where they were at the last search; to be made anew after
/// nodes split. `nodes`: of the whole model.
template <int D>
void list_contact_nodes(const ContactSurface<D>& surface, Index nodes, ContactNodes<D>& list);

/// Largest way of a target's node since the last search, m, largest speed, m/s, and whether `rim`
/// is set: all that the host wants to know, in one go.
struct ContactWay {
  double way = 0, speed = 0;
  Index rim = 0;
};
template <int D>
ContactWay contact_way(const ConstVectors<D>& x, const ConstVectors<D>& v,
                       const ContactNodes<D>& list, const Kokkos::View<const Index, Memory>& rim);

/// What the harmonic mean of the sizes of the elements behind the surface is made of: many small
/// ones count, a few do not. Counted are facets whose element has a 1 in `own`; empty: all.
struct ContactSizes {
  double finest = 0;        ///< 1/m, largest inverse height
  std::int64_t facets = 0;  ///< how many count
};
template <int D>
ContactSizes contact_sizes(const ContactSurface<D>& surface,
                           const Kokkos::View<const std::uint8_t*, Memory>& own);
/// Sum of the inverse heights in units of `grain`, 1/m: of integers, so that it does not depend on
/// who adds up what.
template <int D>
std::int64_t sum_of_inverse_sizes(const ContactSurface<D>& surface,
                                  const Kokkos::View<const std::uint8_t*, Memory>& own,
                                  double grain);

/// All pairs (contact point, target) whose distance at `surface.place` is at most `skin`, without
/// targets that share a node with the point's face or belong to its piece, if that cannot touch
/// itself (ContactSurface::piece). As long as no node has moved more than skin / 2, no contact is
/// missed. Lists are ascending, so they do not depend on the number of threads.
template <int D>
void search_contacts(const ContactSurface<D>& surface, double skin,
                     ContactSearchScratch<D>& scratch, ContactPairs<D>& pairs);

/// The lists per element, from those per point; part of a search, and all of it after a restart.
template <int D>
void finish_contact_pairs(const ContactSurface<D>& surface, ContactSearchScratch<D>& scratch,
                          ContactPairs<D>& pairs);

extern template void take_contact_places<2>(const ConstVectors<2>&, const ContactSurface<2>&);
extern template void take_contact_places<3>(const ConstVectors<3>&, const ContactSurface<3>&);
extern template void list_contact_nodes<2>(const ContactSurface<2>&, Index, ContactNodes<2>&);
extern template void list_contact_nodes<3>(const ContactSurface<3>&, Index, ContactNodes<3>&);
extern template ContactWay contact_way<2>(const ConstVectors<2>&, const ConstVectors<2>&,
                                          const ContactNodes<2>&,
                                          const Kokkos::View<const Index, Memory>&);
extern template ContactWay contact_way<3>(const ConstVectors<3>&, const ConstVectors<3>&,
                                          const ContactNodes<3>&,
                                          const Kokkos::View<const Index, Memory>&);
extern template ContactSizes contact_sizes<2>(const ContactSurface<2>&,
                                              const Kokkos::View<const std::uint8_t*, Memory>&);
extern template ContactSizes contact_sizes<3>(const ContactSurface<3>&,
                                              const Kokkos::View<const std::uint8_t*, Memory>&);
extern template std::int64_t sum_of_inverse_sizes<2>(
    const ContactSurface<2>&, const Kokkos::View<const std::uint8_t*, Memory>&, double);
extern template std::int64_t sum_of_inverse_sizes<3>(
    const ContactSurface<3>&, const Kokkos::View<const std::uint8_t*, Memory>&, double);
extern template void search_contacts<2>(const ContactSurface<2>&, double, ContactSearchScratch<2>&,
                                        ContactPairs<2>&);
extern template void search_contacts<3>(const ContactSurface<3>&, double, ContactSearchScratch<3>&,
                                        ContactPairs<3>&);

extern template void finish_contact_pairs<2>(const ContactSurface<2>&, ContactSearchScratch<2>&,
                                             ContactPairs<2>&);
extern template void finish_contact_pairs<3>(const ContactSurface<3>&, ContactSearchScratch<3>&,
                                             ContactPairs<3>&);

}  // namespace breccia
