#pragma once

#include <Kokkos_Macros.hpp>

namespace breccia {

/// Nodes of the faces of a positively oriented simplex. Local face f lies opposite local node f.
/// The order of the nodes gives the outward normal: in 2D it is to the right of the direction node
/// 0 -> node 1, in 3D it follows the right-hand rule. A simplex is positively oriented when det(x1
/// - x0, ..., xD - x0) > 0.
template <int D>
KOKKOS_INLINE_FUNCTION
constexpr int face_node(int face, int i) {
  static_assert(D == 2 || D == 3);
  if constexpr (D == 2) {
    return (face + 1 + i) % 3;
  } else {
    constexpr int table[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
    return table[face][i];
  }
}

/// Two elements see their common face with opposite orientation: node i of the left element's face
/// is node `opposite_face_node<D>(rotation, i)` of the right element's face. The rotation is stored
/// with the face (always 1 in 2D, 0 to 2 in 3D). The map is its own inverse.
template <int D>
KOKKOS_INLINE_FUNCTION
constexpr int opposite_face_node(int rotation, int i) {
  static_assert(D == 2 || D == 3);
  return (rotation + D - i) % D;
}

}  // namespace breccia
