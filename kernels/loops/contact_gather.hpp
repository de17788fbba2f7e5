#pragma once
#include "loops/contact_force.hpp"

namespace breccia {

/// Sums the points' forces on the corners of each element that is involved, in fixed order: N_a F
/// of its own points,
/// then -L_k F of the pairs that push it, so that linear and angular momentum are kept to round-
/// off.
template <int D>
void gather_contact(const ContactSurface<D>& surface, const ContactPairs<D>& pairs,
                    const CornerForces<D>& force);

/// The same of what contact_force_distributed leaves.
template <int D>
void gather_contact_distributed(const ContactSurface<D>& surface, const ContactPairs<D>& pairs,
                                const CornerForces<D>& force);

/// Sets `bit` of the flags of all nodes of the involved elements.
template <int D>
void flag_contact(const ContactSurface<D>& surface, const ContactPairs<D>& pairs,
                  const ConstConnectivity<D>& element_nodes, const Array<std::uint32_t>& flags,
                  std::uint32_t bit);

/// Clears `bit` of all nodes and the corner forces of the involved elements.
template <int D>
void clear_contact(const ContactSurface<D>& surface, const ContactPairs<D>& pairs, Index nodes,
                   const Array<std::uint32_t>& flags, std::uint32_t bit,
                   const CornerForces<D>& force);

template <int D>
struct ContactStiffnessIn {
  ContactSurface<D> surface;
  ContactPairs<D> pairs;
  ContactPointData<D> point;
  Kokkos::View<const Index*, Memory> element_material;
  ContactTable table;
  Index materials = 0;
  ConstConnectivity<D> element_nodes;
  ConstRanges corners;
  Kokkos::View<const Index*, Memory> corner_list;
  Kokkos::View<const std::uint32_t*, Memory> flags;
  std::uint32_t bit = 0;
  Index nodes = 0;
  CornerNumbers<D> corner;  ///< room for all elements
};

/// Twice the stiffness that contacts have or may soon have, on the corners of the elements: 2 k N_a
/// and 2 k L_k, by Jensen's inequality a bound on k |sum N u - sum L u|^2. L is taken at the
/// nearest point of the candidate; of candidates that share nodes only the nearest counts, since a
/// point is in one element of a piece. It holds until the next search or split.
template <int D>
void find_contact_stiffness(const ContactStiffnessIn<D>& in);

/// Adds it to the nodes.
template <int D>
void add_contact_stiffness(const ContactStiffnessIn<D>& in, const Array<double>& stiffness);

extern template void gather_contact<2>(const ContactSurface<2>&, const ContactPairs<2>&,
                                       const CornerForces<2>&);
extern template void gather_contact<3>(const ContactSurface<3>&, const ContactPairs<3>&,
                                       const CornerForces<3>&);
extern template void gather_contact_distributed<2>(const ContactSurface<2>&, const ContactPairs<2>&,
                                                   const CornerForces<2>&);
extern template void gather_contact_distributed<3>(const ContactSurface<3>&, const ContactPairs<3>&,
                                                   const CornerForces<3>&);
extern template void flag_contact<2>(const ContactSurface<2>&, const ContactPairs<2>&,
                                     const ConstConnectivity<2>&, const Array<std::uint32_t>&,
                                     std::uint32_t);
extern template void flag_contact<3>(const ContactSurface<3>&, const ContactPairs<3>&,
                                     const ConstConnectivity<3>&, const Array<std::uint32_t>&,
                                     std::uint32_t);
extern template void clear_contact<2>(const ContactSurface<2>&, const ContactPairs<2>&, Index,
                                      const Array<std::uint32_t>&, std::uint32_t,
                                      const CornerForces<2>&);
extern template void clear_contact<3>(const ContactSurface<3>&, const ContactPairs<3>&, Index,
                                      const Array<std::uint32_t>&, std::uint32_t,
                                      const CornerForces<3>&);
extern template void find_contact_stiffness<2>(const ContactStiffnessIn<2>&);
extern template void add_contact_stiffness<2>(const ContactStiffnessIn<2>&, const Array<double>&);
extern template void find_contact_stiffness<3>(const ContactStiffnessIn<3>&);
extern template void add_contact_stiffness<3>(const ContactStiffnessIn<3>&, const Array<double>&);

}  // namespace breccia
