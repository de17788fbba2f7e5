#pragma once

#include "mesh/fracture_net.hpp"

#include <string>
#include <vector>

namespace breccia {

/// Pieces of a file of fractures, its numbers times `scale` (m).
/// - .csv: a point x,y or x,y,z per line; an empty line ends a polyline (plane) or a polygon
///   (space); lines that begin with # or a letter are comments;
/// - .dxf (ASCII): LINE, LWPOLYLINE and POLYLINE in the plane, 3DFACE and closed POLYLINE in
///   space; everything else in it is skipped.
/// Throws Error naming file and line.
std::vector<FracturePiece> read_fractures(const std::string& path, int dimension, double scale);

/// The pieces of a polyline (plane) or of a polygon (space).
void add_pieces(int dimension, const std::vector<Point<3>>& points,
                std::vector<FracturePiece>& pieces);

}  // namespace breccia
