#pragma once
#include "base/views.hpp"
#include "core/world.hpp"

#include <cstdint>
#include <vector>

namespace breccia {

/// What of the scene a rank holds: the elements that it owns and those around them. An element is
/// owned by one rank, a family by the rank of its first element (or of its rigid body). Nodes that
/// belong to others have no mass here: nothing moves them, they weigh nothing in any sum, and their
/// positions and velocities come from their owners.
struct Part {
  const World* world = nullptr;  ///< none: this rank holds everything
  // Numbers in the whole scene.
  std::vector<Index> element, family, face;
  std::vector<int> family_owner;   ///< rank, per family
  std::vector<std::uint8_t> owns;  ///< per element: 1 where this rank owns it
  Array<std::uint8_t> own;         ///< the same on the device; empty: all
  /// Per face: 1 where one of its elements is owned, so that everything about it is known here.
  Array<std::uint8_t> sure_face;
  /// Per element the number of its piece of the whole scene, if that cannot touch itself
  /// (mesh/whole_pieces.hpp), else none; and how many such pieces there are.
  std::vector<Index> piece;
  Index pieces = 0;
  double skin = 0;  ///< m, the farthest that contact may look for something

  [[nodiscard]] bool whole() const { return world == nullptr; }
  [[nodiscard]] bool leads() const { return whole() || world->speaks(); }
  [[nodiscard]] Index face_number(Index f) const { return whole() ? f : face[std::size_t(f)]; }
  [[nodiscard]] Index element_number(Index e) const {
    return whole() ? e : element[std::size_t(e)];
  }
  [[nodiscard]] bool owns_element(Index e) const { return whole() || owns[std::size_t(e)] != 0; }
  [[nodiscard]] bool owns_family(Index f) const {
    return whole() || family_owner[std::size_t(f)] == world->rank();
  }

  // Of numbers that each rank knows a part of.
  [[nodiscard]] double largest(double value) const {
    return whole() ? value : world->largest(value);
  }
  [[nodiscard]] double least(double value) const { return whole() ? value : world->least(value); }
  [[nodiscard]] bool any(bool value) const { return whole() ? value : world->any(value); }
  [[nodiscard]] double sum(double value) const {
    if (whole()) return value;
    std::vector<double> sums{value};
    world->add_up(sums);
    return sums.front();
  }
  /// The first of the ranks with the largest value.
  [[nodiscard]] int rank_of_largest(double value) const {
    if (whole()) return 0;
    const bool mine = value == world->largest(value);
    return static_cast<int>(world->least(mine ? world->rank() : world->size()));
  }
};

}  // namespace breccia
