#pragma once
#include "mesh/mesh.hpp"
#include "step/observation.hpp"

#include <vector>

namespace breccia {

/// The main crack: the largest set of broken faces that hang together through points of the mesh,
/// where it ran in the solid before anything moved.
struct MainCrack {
  double length = 0;      ///< m, extent along its direction
  double area = 0;        ///< m2 of all its faces (length times thickness in the plane)
  double angle = 0;       ///< rad, of its principal axis in x and y against x, in (-pi/2, pi/2]
  double centre[3] = {};  ///< m, centre of area
  double start = 0;       ///< s, when its first face broke
  /// Of its tip, m/s: the most over a fifth of its way, straight from where it began.
  double speed = 0;
};

/// Of the released faces; `point` are the points of the mesh.
template <int D>
MainCrack find_main_crack(const std::vector<CrackFace>& faces, const std::vector<Point<D>>& point);

}  // namespace breccia
