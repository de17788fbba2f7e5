#pragma once
#include "mesh/mesh.hpp"
#include "mesh/topology.hpp"

#include <cstdint>
#include <vector>

namespace breccia {

/// A part of the mesh that hangs together and is held by nothing.
struct FloatingPiece {
  Index elements = 0;
  double volume = 0;                  ///< m2 in the plane, m3
  double place[3] = {0.0, 0.0, 0.0};  ///< m, of its centroid
};

/// Pieces that elements with a mark (not 0) leave behind when they are gone and that have none of
/// the points that are `held`, though they hung together with one before. In the order of their
/// first elements. A face joins its elements, a common point does not.
template <int D>
std::vector<FloatingPiece> floating_pieces(const Mesh<D>& mesh, const Topology<D>& topology,
                                           const std::vector<Index>& mark,
                                           const std::vector<std::uint8_t>& held);

}  // namespace breccia
