#pragma once

#include "mesh/shapes.hpp"

#include <span>

namespace breccia {

/// Adds the named sides of one body, found by place among the faces that only one of its elements
/// has: a face counts when all its points lie on the side within 1e-7 of the shape's extent. Names:
/// see mesh_bodies.
template <int D>
void add_side_regions(Mesh<D>& mesh, Index body, const Shape& shape);

/// Adds "<body>.<line>" for each embedded line: the faces of the body whose points lie on one of
/// its segments.
void add_line_regions(Mesh<2>& mesh, Index body, std::span<const EmbeddedLine> lines);

}  // namespace breccia
