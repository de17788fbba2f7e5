#pragma once

#include "mesh/mesh.hpp"

#include <cstdint>
#include <vector>

namespace breccia {

/// A face shared by two elements, left < right. Node i of the left face is node
/// `opposite_face_node<D>(rotation, i)` of the right face. The outward normal of the left element
/// points to the right.
struct SharedFace {
  Index left = 0;
  Index right = 0;
  std::int8_t left_face = 0;
  std::int8_t right_face = 0;
  std::int8_t rotation = 0;
};

/// How the elements of a mesh hang together. A family is an original mesh point; a corner is
/// (element, local node) with the number element * (D + 1) + local node.
template <int D>
struct Topology {
  std::vector<SharedFace> shared;    ///< sorted by (left, left_face)
  std::vector<ElementFace> free;     ///< faces with one element, sorted
  std::vector<Index> family_start;   ///< points + 1 entries
  std::vector<Index> family_corner;  ///< corners of each family, sorted by corner number
};

/// Pairs the faces in time proportional to the mesh. Throws Error that names the elements of a face
/// with more than two elements, of a face whose two elements lie on the same side, and of duplicate
/// elements.
template <int D>
Topology<D> build_topology(const Mesh<D>& mesh);

/// Per element face, element * (D + 1) + local face: n >= 0 means shared[n], n < 0 means free[-1 -
/// n].
template <int D>
std::vector<Index> face_numbers(const Topology<D>& topology);

}  // namespace breccia
