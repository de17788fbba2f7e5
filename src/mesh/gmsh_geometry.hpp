#pragma once

#include "mesh/shapes.hpp"

#include <map>
#include <span>
#include <utility>
#include <vector>

namespace breccia {

/// Dimension and number of a geometric entity of Gmsh.
using GmshTag = std::pair<int, int>;

/// The bodies of one part, cut along their common faces and embedded lines.
struct GmshAssembly {
  /// Which bodies meet an entity: the owner of a piece, every neighbour of a face, edge or vertex.
  std::map<GmshTag, std::vector<std::size_t>> owners;
  std::vector<std::vector<GmshTag>> pieces;  ///< entities of the full dimension, per body
};

/// Factor from our lengths to those of the geometry: it is built in lengths near 100 because the
/// kernel's tolerance of 1e-7 is absolute. A power of two, so that coordinates come back unrounded.
double gmsh_scale(std::span<const BodyShape* const> bodies);

/// Builds the bodies in the current Gmsh model. Where two overlap, the later takes the common part.
GmshAssembly gmsh_assemble(int dimension, std::span<const BodyShape* const> bodies, double scale);

}  // namespace breccia
