#pragma once

#include "base/mat.hpp"
#include "mesh/mesh.hpp"

#include <vector>

namespace breccia {

/// Where a copy of a body is: turned about the middle of the body's box, then put at `centre`.
template <int D>
struct Placement {
  Mat<D> turn;    ///< rotation
  Vec<D> centre;  ///< of its box before it was turned, m
};

/// Middle of the box around a body, m.
template <int D>
Vec<D> middle_of_body(const Mesh<D>& mesh, Index body);

/// Puts a body where the first placement says and copies of it, with its regions, where the others
/// do; all of them carry the body's name. Throws Error naming places and depth where two of them
/// overlap by more than 1e-3 of the lesser height of two elements.
template <int D>
void copy_body(Mesh<D>& mesh, Index body, const std::vector<Placement<D>>& placements);

}  // namespace breccia
