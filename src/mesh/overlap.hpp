#pragma once

#include "mesh/mesh.hpp"

#include <optional>
#include <string>

namespace breccia {

/// The deepest overlap found between two elements of different bodies.
template <int D>
struct Overlap {
  std::string body_a, body_b;
  Index element_a = kNone, element_b = kNone;
  Point<D> place{};  ///< middle of the common part of the two elements' boxes, m
  double depth = 0;  ///< shortest shift that separates the two elements, m
};

/// Searches for elements of different bodies that overlap by more than `tolerance` times the lesser
/// height of the two. Touching exactly is allowed, and so are bodies that share points. The default
/// allows for the chords of two curved surfaces that touch (h^2 / 8R for edges h on a radius R).
template <int D>
std::optional<Overlap<D>> find_overlap(const Mesh<D>& mesh, double tolerance = 1e-3);

/// Throws Error naming bodies, place and depth when `find_overlap` finds one.
template <int D>
void refuse_overlap(const Mesh<D>& mesh, double tolerance = 1e-3);

}  // namespace breccia
