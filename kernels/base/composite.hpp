#pragma once

#include <Kokkos_Macros.hpp>

namespace breccia {

/// A composite element is `Group` simplices that share one volumetric response (ALGORITHMS A-2):
/// 4 triangles in the plane, 8 or 12 tetrahedra in space. Its sub-elements are contiguous in the
/// mesh, in the order of these tables.
///
/// Local nodes of the composite: first the D + 1 vertices, positively oriented, then the mid-edge
/// nodes, then, of a group of 12, the node inside.
/// - plane: 3 = m01, 4 = m12, 5 = m20
/// - space: 4 = m01, 5 = m12, 6 = m02, 7 = m03, 8 = m13, 9 = m23, 10 = inside (group of 12)
///
/// Sub-element a < D + 1 has vertex a; as its local node a in the plane, as its local node 0 in
/// space. Then come the middle triangle, or the pieces of the octahedron: four around the diagonal
/// m01-m23 (the mesh numbers the vertices so that this is the shortest), or eight around node 10.
template <int D, int Group>
inline constexpr int composite_nodes = D == 2 ? 6 : (Group == 12 ? 11 : 10);

/// Local node of the composite that is corner `corner` of its sub-element `sub`.
template <int D, int Group>
KOKKOS_INLINE_FUNCTION
constexpr int composite_node(int sub, int corner) {
  static_assert((D == 2 && Group == 4) || (D == 3 && (Group == 8 || Group == 12)));
  if constexpr (D == 2) {
    constexpr int table[4][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};
    return table[sub][corner];
  } else if constexpr (Group == 8) {
    constexpr int table[8][4] = {{0, 4, 6, 7}, {1, 4, 8, 5}, {2, 9, 6, 5}, {3, 9, 8, 7},
                                 {4, 9, 5, 6}, {4, 9, 6, 7}, {4, 9, 7, 8}, {4, 9, 8, 5}};
    return table[sub][corner];
  } else {
    constexpr int table[12][4] = {{0, 4, 6, 7},  {1, 4, 8, 5},  {2, 9, 6, 5},  {3, 9, 8, 7},
                                  {10, 4, 7, 6}, {10, 4, 5, 8}, {10, 9, 5, 6}, {10, 9, 7, 8},
                                  {10, 5, 9, 8}, {10, 7, 9, 6}, {10, 4, 8, 7}, {10, 6, 5, 4}};
    return table[sub][corner];
  }
}

/// One (sub-element, corner) that holds a local node of the composite.
struct CompositePlace {
  int sub, corner;
};

template <int D, int Group>
KOKKOS_INLINE_FUNCTION
constexpr CompositePlace composite_place(int node) {
  if constexpr (D == 2) {
    constexpr CompositePlace table[6] = {{0, 0}, {1, 1}, {2, 2}, {3, 0}, {3, 1}, {3, 2}};
    return table[node];
  } else {
    constexpr CompositePlace table[11] = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {0, 1}, {1, 3},
                                          {0, 2}, {0, 3}, {1, 2}, {2, 1}, {4, 0}};
    return table[node];
  }
}

/// The vertex at end 0 or 1 of the edge whose mid-edge node this is (D + 1 <= node < 6 or 10).
template <int D>
KOKKOS_INLINE_FUNCTION
constexpr int composite_edge(int node, int end) {
  if constexpr (D == 2) {
    constexpr int table[3][2] = {{0, 1}, {1, 2}, {2, 0}};
    return table[node - 3][end];
  } else {
    constexpr int table[6][2] = {{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}};
    return table[node - 4][end];
  }
}

}  // namespace breccia
