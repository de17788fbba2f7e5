#pragma once

#include <gtest/gtest.h>

#include <string>

namespace breccia {

/// Points 1 to 6 row by row: two unit squares side by side, each cut into two triangles.
inline const std::string kTwoSquares22 = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
4
0 3 "corner"
1 7 "loaded"
2 1 "rock"
2 2 "steel"
$EndPhysicalNames
$Nodes
6
1 0 0 0
2 1 0 0
3 2 0 0
4 0 1 0
5 1 1 0
6 2 1 0
$EndNodes
$Elements
7
1 15 2 3 1 1
2 1 2 7 5 4 5
3 1 2 7 5 5 6
4 2 2 1 1 1 2 5
5 2 2 1 1 1 5 4
6 2 2 2 2 2 3 6
7 2 2 2 2 2 6 5
$EndElements
)";

inline const std::string kTwoSquares41 = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
4
0 3 "corner"
1 7 "loaded"
2 1 "rock"
2 2 "steel"
$EndPhysicalNames
$Entities
1 1 2 0
1 0 0 0 1 3
5 0 1 0 2 1 0 1 7 2 1 -1
1 0 0 0 1 1 0 1 1 1 5
2 1 0 0 2 1 0 1 2 1 5
$EndEntities
$Nodes
2 6 1 6
1 5 1 3
4
5
6
0 1 0 0.5
1 1 0 0.6
2 1 0 0.7
2 1 0 3
1
2
3
0 0 0
1 0 0
2 0 0
$EndNodes
$Elements
4 7 1 7
0 1 15 1
1 1
1 5 1 2
2 4 5
3 5 6
2 1 2 2
4 1 2 5
5 1 5 4
2 2 2 2
6 2 3 6
7 2 6 5
$EndElements
)";

/// A triangle of second order; the middle of its slope is 0.1 * sqrt(2) m outside.
inline const std::string kCurvedTriangle22 = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
1 7 "slope"
2 1 "rock"
$EndPhysicalNames
$Nodes
6
1 0 0 0
2 1 0 0
3 0 1 0
4 0.5 0 0
5 0.6 0.6 0
6 0 0.5 0
$EndNodes
$Elements
2
1 8 2 7 5 2 3 5
2 9 2 1 1 1 2 3 4 5 6
$EndElements
)";

/// A tetrahedron of second order whose mid-edge nodes are in the middle, in Gmsh's order.
inline const std::string kTetrahedron22 = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
10
1 0 0 0
2 2 0 0
3 0 2 0
4 0 0 2
5 1 0 0
6 1 1 0
7 0 1 0
8 0 0 1
9 0 1 1
10 1 0 1
$EndNodes
$Elements
1
1 11 2 0 1 1 2 3 4 5 6 7 8 9 10
$EndElements
)";

/// The text with the first occurrence of `what` replaced; fails the test when there is none.
inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << "the sample has no \"" << what << "\"";
  return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

}  // namespace breccia
