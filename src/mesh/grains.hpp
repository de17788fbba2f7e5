#pragma once

#include "mesh/shapes.hpp"

#include <cstdint>

namespace breccia {

/// Edges of Voronoi grains that fill a plane body, about `grain` across (m): cells about the points
/// of a triangular lattice that were shifted at random by up to `jitter` of their distance. Corners
/// that lie closer than a third of an element to one another, or to the sides of a rectangle, are
/// made one. What leaves the body is cut off by the mesher. Throws Error for shapes from files.
std::vector<FracturePiece> grain_edges(const BodyShape& body, double grain, double jitter,
                                       std::uint64_t seed);

}  // namespace breccia
