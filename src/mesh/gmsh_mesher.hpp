#pragma once

#include "mesh/raw_mesh.hpp"
#include "mesh/shapes.hpp"

namespace breccia {

/// Meshes bodies that are parts of one another (or one body) with the geometry kernel of Gmsh. One
/// group of dimension `dimension` per body, of its name; with the mid-edge nodes where the first
/// body wants curved edges. Throws Error that names the body, also in a build without Gmsh.
RawMesh gmsh_mesh(int dimension, std::span<const BodyShape* const> bodies);

/// Opens a file with Gmsh (.geo, .msh of any version) and, when it brings no elements of
/// `dimension`, meshes it; `size` > 0 limits the element size then, and `curved` asks for mid-edge
/// nodes.
RawMesh gmsh_open(const std::string& path, int dimension, double size, bool curved);

}  // namespace breccia
