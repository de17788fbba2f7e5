#pragma once

#include "mesh/shapes.hpp"

namespace breccia {

/// Element size (m) that a body asks for at a place: its own, less near its refinements.
double element_size(const BodyShape& body, const Point<3>& x);

/// Largest distance between two points of a shape's box (m); 0 for a file.
double extent_of(const Shape& shape);

}  // namespace breccia
