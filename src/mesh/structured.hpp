#pragma once

#include "mesh/mesh.hpp"

#include <array>
#include <cstdint>
#include <string>

namespace breccia {

/// How a cell of a structured grid is cut. In the plane: `right` 2 triangles by one diagonal,
/// `cross` 4 triangles about the centre, `union_jack` 2 triangles with alternating diagonal. In
/// space: `kuhn` 6 tetrahedra about one diagonal (translation invariant), `five` 5 tetrahedra
/// mirrored from cell to cell.
enum class Pattern { right, cross, union_jack, kuhn, five };

template <int D>
struct Grid {
  Point<D> lower{};              ///< m
  Point<D> upper{};              ///< m
  std::array<Index, D> cells{};  ///< cells along each axis
  Pattern pattern = D == 2 ? Pattern::cross : Pattern::kuhn;
  double jitter = 0;       ///< largest shift of an inner point, in cell sizes, 0 to 0.3
  std::uint64_t seed = 1;  ///< of the jitter, which is a hash of (seed, point)
  std::string body = "body";
};

/// Numbers of cells whose size is nearest to `size`, at least one along each axis.
template <int D>
std::array<Index, D> cells_of_size(const Point<D>& lower, const Point<D>& upper, double size);

/// Meshes a rectangle or a box without Gmsh. Regions: the body and its sides "<body>.left", "right"
/// (x), "bottom", "top" (y), "front", "back" (z, space only). Throws Error on empty extents, cells
/// < 1, jitter out of range, a pattern of the other dimension, or more points than 32-bit numbers
/// hold.
template <int D>
Mesh<D> structured_mesh(const Grid<D>& grid);

}  // namespace breccia
