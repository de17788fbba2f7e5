#pragma once
#include "loops/contact_force.hpp"

namespace breccia {

/// Forces of the distributed potential, for comparison (`contact.force = "distributed_potential"`):
/// each part of a face against each element that it overlaps, left in `pairs` for the gather. A
/// part remembers one slip, in its first slot. The pairs must be those within
/// `contact_part_reach` of a skin.
template <int D>
void contact_force_distributed(const ContactForceIn<D>& in, const ContactForceOut<D>& out);

/// How far a part of a face reaches from its point at most, m.
template <int D>
double contact_part_reach(const ContactSurface<D>& surface);

extern template void contact_force_distributed<2>(const ContactForceIn<2>&,
                                                  const ContactForceOut<2>&);
extern template void contact_force_distributed<3>(const ContactForceIn<3>&,
                                                  const ContactForceOut<3>&);
extern template double contact_part_reach<2>(const ContactSurface<2>&);
extern template double contact_part_reach<3>(const ContactSurface<3>&);

}  // namespace breccia
