#pragma once

#include "mesh/shapes.hpp"

#include <cstdint>

namespace breccia {

/// How long the fractures of a set are, m: between `shortest` and `longest` with a density that
/// falls with `exponent` (0: uniform).
struct LengthLaw {
  double shortest = 0, longest = 0, exponent = 0;
};

/// Fractures at random places of a body: as many as `number`, or until their length per area (in
/// the plane, 1/m) or area per volume (in space) inside the body reaches `intensity`.
struct FractureSet {
  int number = 0;
  double intensity = 0;
  LengthLaw length;
  /// Mean direction: of the trace in the plane, of the normal in space.
  Point<3> direction{1, 0, 0};
  double concentration = 0;  ///< von Mises (plane), Fisher (space); 0: uniform
  bool parallel = false;     ///< all along the mean
  std::uint64_t seed = 1;
  std::uint32_t stream = 0;  ///< one per set, so that sets are independent
};

/// Draws the set. A fracture that meets an earlier one, one of `others`, or the surface so that
/// slivers would be left is drawn anew. Discs in space become polygons of the same area. Throws
/// Error when there is no room for more.
std::vector<FracturePiece> draw_fractures(int dimension, const FractureSet& set,
                                          const BodyShape& body,
                                          const std::vector<FracturePiece>& others);

/// Corners of the box about a body whose shape is in the scene. Throws Error for a file.
std::array<Point<3>, 2> box_of(const BodyShape& body);

/// Whether some of a piece lies inside the body.
bool touches_inside(const BodyShape& body, const FracturePiece& piece);

/// A disc as a regular polygon of the same area, its edges about `size` long.
FracturePiece disc_piece(const Point<3>& centre, const Point<3>& normal, double radius,
                         double size);

/// Parallel planes through a body, `spacing` apart (m), one of them through `through`; in the plane
/// lines along `direction`, in space planes across it. Those that would run just below the surface
/// are left out.
std::vector<FracturePiece> parallel_planes(int dimension, const BodyShape& body, double spacing,
                                           const Point<3>& direction, const Point<3>& through);

}  // namespace breccia
