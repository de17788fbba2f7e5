#pragma once
#include "mesh/topology.hpp"

#include <vector>

namespace breccia {

/// Elements dealt out to parts, and what that costs.
struct Partition {
  std::vector<Index> part;  ///< of each element
  int parts = 1;
  double imbalance = 1;  ///< elements of the largest part over the mean
  Index cut_faces = 0;   ///< faces between two parts
  /// Elements that a part does not own but that touch a node of it (one layer of whole stars,
  /// computed redundantly), over the elements of the mesh.
  double ghost_share = 0;
};

/// Cuts the dual graph (elements joined by faces) into `parts` of nearly equal size with few cut
/// faces, by METIS k-way. Elements of one cluster stay together: `cluster` numbers those of each
/// element from 0 on without gaps; empty: each is by itself. The same mesh gives the same
/// partition. Throws Error when the build has no METIS, when there are more parts than elements,
/// or when a part would be empty.
template <int D>
Partition partition(const Mesh<D>& mesh, const Topology<D>& topology, int parts,
                    const std::vector<Index>& cluster = {});

/// Whether this build can partition.
bool can_partition();

}  // namespace breccia
