#pragma once
#include "loops/interface_views.hpp"

namespace breccia {

/// Nodes of the left and right corners of the acting interfaces: (place in the list, side, corner).
template <int D>
using PairNodes = Kokkos::View<Index* [2][D], Rows, Memory>;

/// Where the forces of an element's corners come from: (place in the list, local node, face). An
/// entry is 0 for none, else plus or minus (interface * D + corner + 1), minus on the right side.
template <int D>
using PairSources = Kokkos::View<Index * [D + 1][D], Rows, Memory>;

/// Short cuts for the loops of every step, renewed when nodes split or interfaces come and go.
template <int D>
struct InterfaceTables {
  InterfaceMap<D> map;

  void fill_nodes(const ConstArray<Index>& list, Index count, const ConstConnectivity<D>& nodes,
                  const PairNodes<D>& to) const;
  void fill_sources(const ConstArray<Index>& elements, Index count, const PairSources<D>& to) const;
};

/// Pair forces on the corners of the listed elements, face by face in a fixed order. Every element
/// writes its own corners only.
template <int D>
void book_pair_forces(const ConstArray<Index>& elements, Index count,
                      const Kokkos::View<const Index * [D + 1][D], Rows, Memory>& sources,
                      const ConstPairForces<D>& pair, const CornerForces<D>& force);

/// Zero on the corners of the listed elements.
template <int D>
void clear_corner_forces(const ConstArray<Index>& elements, Index count,
                         const CornerForces<D>& force);

extern template struct InterfaceTables<2>;
extern template struct InterfaceTables<3>;
extern template void book_pair_forces<2>(const ConstArray<Index>&, Index,
                                         const Kokkos::View<const Index* [3][2], Rows, Memory>&,
                                         const ConstPairForces<2>&, const CornerForces<2>&);
extern template void book_pair_forces<3>(const ConstArray<Index>&, Index,
                                         const Kokkos::View<const Index* [4][3], Rows, Memory>&,
                                         const ConstPairForces<3>&, const CornerForces<3>&);
extern template void clear_corner_forces<2>(const ConstArray<Index>&, Index,
                                            const CornerForces<2>&);
extern template void clear_corner_forces<3>(const ConstArray<Index>&, Index,
                                            const CornerForces<3>&);

}  // namespace breccia
