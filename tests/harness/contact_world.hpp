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
class ContactWorld {
 public:
  explicit ContactWorld(Mesh<2> mesh);

  Mesh<2> mesh;
  Topology<2> topology;
  std::vector<Vec<2>> x, v;     ///< current
  double stiffness = 1e9;       ///< k per area, Pa/m
  double xi = 0, friction = 0;  ///< damping, friction coefficient
  double skin = 0.02;           ///< m
  double dt_before = 0, keep = 0;
  bool smooth = true, jumped = false;
  Index layers = 2;
  std::vector<char> released;  ///< per shared face of the topology

  void update_surface();  ///< facets, targets, potential
  void search();
  void force();  ///< and the gather

  /// Energies as the module books them.
  double stored() const;
  Sums<3> lost() const { return total_of(lost_); }
  Index signal(int which) const;

  std::vector<Vec<2>> node_force() const;
  std::vector<Vec<2>> corner_force() const;  ///< element * 3 + corner
  /// Sum of the contactor forces of the points on the faces of one body.
  Vec<2> point_force(Index body) const;
  Index touching() const;  ///< pairs in contact
  /// (point id, element) of all candidates, sorted.
  std::vector<std::pair<Index, Index>> candidates() const;
  ContactWay way() const;
  std::vector<double> node_stiffness() const;

  ContactSurface<2> surface;
  ContactPairs<2> pairs;
  ContactHistory<2> history;

 private:
  void upload() const;
  ContactForceIn<2> input() const;

  Connectivity<2> nodes_;
  Vectors<2> x_, v_, reference_;
  Ranges corners_;
  Array<Index> corner_list_, free_, material_;
  Array<std::uint8_t> status_, code_;
  Ranges face_elements_;
  Array<std::uint32_t> flags_;
  CornerForces<2> force_;
  ContactScratch<2> scratch_;
  ContactSearchScratch<2> search_scratch_;
  ContactPointData<2> point_;
  ContactTable table_;
  ContactSignals signals_;
  ChunkSums<3> lost_;
};

}  // namespace breccia
