#pragma once

#include "mesh/mesh.hpp"

#include <vector>

namespace breccia {

/// Points of one body, or of bodies that share points, that lie within 1e-6 of the mesh's shortest
/// edge: both points of each pair, one pair after the other. Bodies that share no point may touch
/// with coincident points.
template <int D>
std::vector<Index> coincident_points(const Mesh<D>& mesh);

}  // namespace breccia
