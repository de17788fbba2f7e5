#pragma once

#include "mesh/mesh.hpp"

#include <string>
#include <vector>

namespace breccia {

/// A flat piece of a fracture, m: two points in the plane (third coordinate zero), the corners of a
/// convex polygon in space.
using FracturePiece = std::vector<Point<3>>;

/// Fractures of one name that the mesh of a body must follow. Their faces become the region
/// "<body>.<name>".
struct FractureNet {
  std::string name;
  std::vector<FracturePiece> pieces;
  double size = 0;     ///< element size along them (m), growing with the distance; 0: the body's
  double growth = 0;   ///< of that size per unit length; 0: 0.3
  bool drawn = false;  ///< by random numbers: pieces that leave the body are no news
};

/// Length of a segment, m, or area of a polygon, m2.
double measure_of(const FracturePiece& piece);

/// Distance of a point from a piece, m.
double distance_to(const FracturePiece& piece, const Point<3>& x);

/// Why two pieces cannot be meshed together with elements of size h, or "" where they can: they
/// coincide, cross at less than 5 degrees, or one ends closer than a tenth of h to the other.
std::string conflict_of(const FracturePiece& a, const FracturePiece& b, double h);

}  // namespace breccia
