#pragma once
#include "step/observation.hpp"

#include <vector>

namespace breccia {

/// The main crack: the largest set of broken faces that hang together (through common points).
/// In the plane it is a line; its direction is that of the straight line through its ends of
/// largest spread (area-weighted principal axis).
struct MainCrack {
  double length = 0;      ///< m, extent along its direction
  double area = 0;        ///< m2 of all its faces (length times thickness in the plane)
  double angle = 0;       ///< rad, direction against the x axis, in (-pi/2, pi/2]
  double centre[3] = {};  ///< m, centre of area
};

/// Only released faces count. In space the direction is that of the largest spread in x and y.
MainCrack find_main_crack(const std::vector<CrackFace>& faces, int dimension);

}  // namespace breccia
