#pragma once
#include "base/sums.hpp"
#include "loops/contact_history.hpp"
#include "loops/contact_lists.hpp"
#include "point/friction_law.hpp"

namespace breccia {

/// What a contact point needs to know of itself.
template <int D>
struct ContactPointData {
  Kokkos::View<double* [2], Rows, Memory> constants;  ///< k [N/m], c [N s/m] against its like
  Array<Index> material;
};

/// Numbers of two materials in contact: (contactor * materials + target, 4).
///   0: friction coefficient at rest
///   1: stiffness of the pair over that of the contactor's material against itself
///   2: tangential over normal stiffness
///   3: dashpot of the pair over that of the contactor's material against itself
using ContactTable = Kokkos::View<double* [4], Rows, Memory>;

/// Things that the host looks at now and then.
struct ContactSignals {
  static constexpr Index rim = 0, lost = 1, crowded = 2, count = 3;
  /// rim: 1 when a point is so deep that deeper targets are needed; the others count.
  Array<Index> value;
};

template <int D>
struct ContactForceIn {
  ContactSurface<D> surface;
  ContactPairs<D> pairs;
  ContactPointData<D> point;
  ConstVectors<D> x, v;
  ConstConnectivity<D> element_nodes;
  Kokkos::View<const Index*, Memory> element_material;
  Kokkos::View<const Index*, Memory> family;  ///< of nodes; empty where nothing can break
  ContactTable table;
  Kokkos::View<const FrictionLaw*, Memory> laws;  ///< as the table; empty where all are Coulomb's
  Index materials = 0;
  double dt_before = 0;  ///< s, of the step that led here
  double keep = 0;       ///< share of a jump of the potential that survives a step
  bool jumped = false;   ///< the potential was computed anew after the last step
  bool smooth = true;    ///< direction of the force: smooth, or the exact gradient
};

template <int D>
struct ContactForceOut {
  ContactHistory<D> history;
  ContactSignals signals;
  ChunkSums<3> lost;  ///< J: friction, viscous, numeric
};

/// Forces of all contact points, left in `pairs` for the gather; commits the history.
template <int D>
void contact_force(const ContactForceIn<D>& in, const ContactForceOut<D>& out);

/// Constants of the points from the stiffness rule of ALGORITHMS, both passes counted half.
template <int D>
struct ContactStiffness {
  double factor = 5;      ///< kappa: k = kappa M / h per area
  double fixed = 0;       ///< Pa/m; above zero it replaces the rule
  double damping = 0.01;  ///< xi
  Kokkos::View<const double* [2], Rows, Memory> material;  ///< M [Pa], density [kg/m3]
};
template <int D>
void set_contact_points(const ContactSurface<D>& surface, const ContactPairs<D>& pairs,
                        const Kokkos::View<const Index*, Memory>& element_material,
                        const ContactStiffness<D>& rule, ContactPointData<D>& point);

/// Nodes of the points' faces, after a search and after nodes split.
template <int D>
void refresh_point_nodes(const ContactSurface<D>& surface, const ContactPairs<D>& pairs);

extern template void contact_force<2>(const ContactForceIn<2>&, const ContactForceOut<2>&);
extern template void contact_force<3>(const ContactForceIn<3>&, const ContactForceOut<3>&);
extern template void set_contact_points<2>(const ContactSurface<2>&, const ContactPairs<2>&,
                                           const Kokkos::View<const Index*, Memory>&,
                                           const ContactStiffness<2>&, ContactPointData<2>&);
extern template void set_contact_points<3>(const ContactSurface<3>&, const ContactPairs<3>&,
                                           const Kokkos::View<const Index*, Memory>&,
                                           const ContactStiffness<3>&, ContactPointData<3>&);
extern template void refresh_point_nodes<2>(const ContactSurface<2>&, const ContactPairs<2>&);
extern template void refresh_point_nodes<3>(const ContactSurface<3>&, const ContactPairs<3>&);

}  // namespace breccia
