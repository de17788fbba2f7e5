#pragma once

#include "mesh/shapes.hpp"

namespace breccia {

/// Refuses descriptions that cannot be meshed, before Gmsh sees them: shapes of the other
/// dimension, sizes and extents that are not positive, outlines that cross themselves or holes that
/// leave them, lines and patterns where there can be none, parts that mix files with shapes.
void check_part(int dimension, std::span<const BodyShape* const> part);

}  // namespace breccia
