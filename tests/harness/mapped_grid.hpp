#pragma once
#include "mesh/mesh.hpp"

#include <functional>
#include <string>

namespace breccia {

/// From the unit square to the body.
using Mapping = std::function<Point<2>(double, double)>;

/// Gmsh text of `nx` times `ny` quadrilaterals, each cut into two triangles; groups "rock", "left",
/// "right", "bottom" and "top"; with several layers of equal numbers of rows "rock 0", "rock 1", ...
/// instead of "rock". Second order: mid-edge nodes are mapped like the others, so that
/// composites follow curved sides.
std::string mapped_grid(int nx, int ny, const Mapping& map, bool second_order = false,
                        int layers = 1);

}  // namespace breccia
