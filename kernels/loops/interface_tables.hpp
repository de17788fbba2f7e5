#pragma once
#include "loops/interface_views.hpp"

namespace breccia {

/// Nodes of the left and right corners of the interfaces: (interface, side, corner).
template <int D>
using PairNodes = Kokkos::View<Index* [2][D], Rows, Memory>;
template <int D>
using ConstPairNodes = Kokkos::View<const Index* [2][D], Rows, Memory>;

/// Where the forces of an element's corners come from: (element, local node, face). An entry is 0
/// for none, else plus or minus (interface * D + corner + 1), minus on the right side.
template <int D>
using PairSources = Kokkos::View<Index * [D + 1][D], Rows, Memory>;
template <int D>
using ConstPairSources = Kokkos::View<const Index * [D + 1][D], Rows, Memory>;

/// Short cuts for the loops of every step.
template <int D>
struct InterfaceTables {
  InterfaceMap<D> map;
  ConstConnectivity<D> element_nodes;
  PairNodes<D> nodes;
  PairSources<D> sources;

  /// Interfaces [0, interfaces) and elements [0, elements).
  void fill(Index interfaces, Index elements) const;

  /// What a split or an insertion changes: the corners of the listed families, whose nodes may be
  /// new and whose faces may be. Their corner forces are added up anew.
  void renew(const ConstArray<Index>& families, Index count, const ConstRanges& family_corners,
             const ConstArray<Index>& corner_list, const ConstPairForces<D>& pair,
             const CornerForces<D>& force) const;
};

/// Pair forces on the corners of the listed elements, face by face in a fixed order. Every element
/// writes its own corners only.
template <int D>
void book_pair_forces(const ConstArray<Index>& elements, Index count,
                      const ConstPairSources<D>& sources, const ConstPairForces<D>& pair,
                      const CornerForces<D>& force);

/// Zero on the corners of the listed elements.
template <int D>
void clear_corner_forces(const ConstArray<Index>& elements, Index count,
                         const CornerForces<D>& force);

extern template struct InterfaceTables<2>;
extern template struct InterfaceTables<3>;
extern template void book_pair_forces<2>(const ConstArray<Index>&, Index,
                                         const ConstPairSources<2>&, const ConstPairForces<2>&,
                                         const CornerForces<2>&);
extern template void book_pair_forces<3>(const ConstArray<Index>&, Index,
                                         const ConstPairSources<3>&, const ConstPairForces<3>&,
                                         const CornerForces<3>&);
extern template void clear_corner_forces<2>(const ConstArray<Index>&, Index,
                                            const CornerForces<2>&);
extern template void clear_corner_forces<3>(const ConstArray<Index>&, Index,
                                            const CornerForces<3>&);

}  // namespace breccia
