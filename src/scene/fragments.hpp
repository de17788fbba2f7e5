#pragma once
#include "step/model.hpp"

#include <vector>

namespace breccia {

/// Connected pieces: elements joined through faces that are not released.
struct Fragments {
  std::vector<Index> of_element;  ///< number of each element's fragment, by falling mass
  struct Piece {
    Index elements = 0;
    double mass = 0;          ///< kg
    double volume = 0;        ///< m3 (area times thickness in the plane)
    double place[3] = {};     ///< m, centre of mass
    double velocity[3] = {};  ///< m/s
    double spin[3] = {};      ///< rad/s, about the centre of mass; in the plane only the last one
    /// Longest and shortest edge of the brick or rectangle with its moments of mass, m.
    double length = 0, width = 0;
  };
  std::vector<Piece> pieces;
};

template <int D>
Fragments find_fragments(const Model<D>& model);

}  // namespace breccia
