#pragma once
#include "base/sums.hpp"
#include "loops/stars.hpp"

namespace breccia {

/// Families that have corners of excavated elements, and what the masses of their nodes are made
/// of.
template <int D>
struct ExcavatedMass {
  ConstArray<Index> family;
  ConstRanges family_corners;
  ConstArray<Index> corner_list;
  ConstConnectivity<D> nodes;
  CornerMass<D> corner_mass;
  Array<double> added_mass;  ///< kg, of mass scaling; empty: none
};

/// Gives the nodes of these families the mass that their corners have now. What leaves takes its
/// velocity along: the rest goes on as it was. A node that keeps no corner has no mass and does not
/// move any more. Returns the kinetic energy that left, J, added up in a fixed order.
template <int D>
double take_mass(const ExcavatedMass<D>& in, const Array<double>& mass, const Vectors<D>& v,
                 const ChunkSums<1>& rows);

extern template double take_mass<2>(const ExcavatedMass<2>&, const Array<double>&,
                                    const Vectors<2>&, const ChunkSums<1>&);
extern template double take_mass<3>(const ExcavatedMass<3>&, const Array<double>&,
                                    const Vectors<3>&, const ChunkSums<1>&);

}  // namespace breccia
