#pragma once
#include "base/sums.hpp"
#include "loops/contact_force.hpp"
#include "loops/contact_gather.hpp"
#include "loops/contact_search.hpp"
#include "loops/contact_surface.hpp"
#include "mesh/mesh.hpp"
#include "mesh/topology.hpp"

#include <memory>
#include <vector>

namespace breccia {

/// The contact loops around a mesh, without a scene or a step: for unit tests.
/// Positions and velocities live on the host and are copied before each call.
template <int D>
class ContactWorld {
 public:
  explicit ContactWorld(Mesh<D> mesh);

  Mesh<D> mesh;
  Topology<D> topology;
  std::vector<Vec<D>> x, v;     ///< current
  double stiffness = 1e9;       ///< k per area, Pa/m
  double xi = 0, friction = 0;  ///< damping, friction coefficient
  FrictionLaw law;              ///< used where it is not Coulomb's
  double skin = 0.02;           ///< m
  double dt_before = 0, keep = 0;
  bool smooth = true, jumped = false, distributed = false;
  Index layers = 2;
  std::vector<char> released;  ///< per shared face of the topology

  void update_surface();  ///< facets, targets, potential
  void tell_pieces();     ///< which targets cannot touch their own piece (mesh/whole_pieces.hpp)
  void search();
  void force();  ///< and the gather

  /// Energies as the module books them.
  double stored() const;
  Sums<3> lost() const { return total_of(lost_); }
  Index signal(int which) const;

  std::vector<Vec<D>> node_force() const;
  std::vector<Vec<D>> corner_force() const;  ///< element * (D + 1) + corner
  /// Sum of the contactor forces of the points on the faces of one body.
  Vec<D> point_force(Index body) const;
  Index touching() const;  ///< pairs in contact
  /// (point id, element) of all candidates, sorted.
  std::vector<std::pair<Index, Index>> candidates() const;
  ContactWay way() const;
  std::vector<double> node_stiffness() const;

  ContactSurface<D> surface;
  ContactPairs<D> pairs;
  ContactHistory<D> history;

 private:
  void upload() const;
  ContactForceIn<D> input() const;

  Connectivity<D> nodes_;
  Vectors<D> x_, v_, reference_;
  Ranges corners_;
  Array<Index> corner_list_, free_, material_;
  Array<std::uint8_t> status_, code_;
  Ranges face_elements_;
  Array<std::uint32_t> flags_;
  CornerForces<D> force_;
  ContactScratch<D> scratch_;
  ContactSearchScratch<D> search_scratch_;
  ContactPointData<D> point_;
  ContactTable table_;
  Kokkos::View<FrictionLaw*, Memory> laws_;
  ContactSignals signals_;
  ChunkSums<3> lost_;
};

extern template class ContactWorld<2>;
extern template class ContactWorld<3>;

}  // namespace breccia
