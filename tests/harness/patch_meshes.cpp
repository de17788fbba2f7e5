#include "harness/patch_meshes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace breccia {

namespace {

/// Gmsh 2.2 text of one body "patch".
template <int D>
std::string gmsh_text(const std::vector<Point<D>>& points,
                      const std::vector<std::array<int, D + 1>>& elements) {
  std::string text = fmt::format(
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n{} 1 \"patch\"\n$EndPhysicalNames\n"
      "$Nodes\n{}\n",
      D, points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    text += fmt::format("{} {} {} {}\n", i + 1, points[i][0], points[i][1],
                        D == 3 ? points[i][D - 1] : 0.0);
  text += fmt::format("$EndNodes\n$Elements\n{}\n", elements.size());
  for (std::size_t e = 0; e < elements.size(); ++e) {
    text += fmt::format("{} {} 2 1 1", e + 1, D == 2 ? 2 : 4);
    for (const int n : elements[e]) text += fmt::format(" {}", n + 1);
    text += '\n';
  }
  return text + "$EndElements\n";
}

double determinant(const std::vector<Point<3>>& p, const std::array<int, 4>& t) {
  double g[3][3];
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) g[j][i] = p[t[j + 1]][i] - p[t[0]][i];
  return g[0][0] * (g[1][1] * g[2][2] - g[1][2] * g[2][1]) -
         g[0][1] * (g[1][0] * g[2][2] - g[1][2] * g[2][0]) +
         g[0][2] * (g[1][0] * g[2][1] - g[1][1] * g[2][0]);
}

/// Six tetrahedra from the hexahedron's smallest point to the faces away from it, each face cut
/// through its own smallest point: neighbours agree on the diagonals. Corner i + 2 j + 4 k.
void pull(const std::array<int, 8>& hex, const std::vector<Point<3>>& points,
          std::vector<std::array<int, 4>>& out) {
  static constexpr int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                      {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  const int apex = *std::min_element(hex.begin(), hex.end());
  for (const auto& face : faces) {
    std::array<int, 4> quad;
    for (int i = 0; i < 4; ++i) quad[i] = hex[face[i]];
    if (std::find(quad.begin(), quad.end(), apex) != quad.end()) continue;
    std::rotate(quad.begin(), std::min_element(quad.begin(), quad.end()), quad.end());
    for (int i = 1; i < 3; ++i) {
      std::array<int, 4> tet = {apex, quad[0], quad[i], quad[i + 1]};
      if (determinant(points, tet) < 0) std::swap(tet[2], tet[3]);
      out.push_back(tet);
    }
  }
}

}  // namespace

std::string macneal_harder_plane() {
  const std::vector<Point<2>> points = {{0, 0},       {0.24, 0},    {0.24, 0.12}, {0, 0.12},
                                        {0.04, 0.02}, {0.18, 0.03}, {0.16, 0.08}, {0.08, 0.08}};
  const int quads[5][4] = {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}};
  std::vector<std::array<int, 3>> triangles;
  for (const auto& q : quads) {
    triangles.push_back({q[0], q[1], q[2]});
    triangles.push_back({q[0], q[2], q[3]});
  }
  return gmsh_text<2>(points, triangles);
}

std::string macneal_harder_space() {
  std::vector<Point<3>> points;
  for (int c = 0; c < 8; ++c) points.push_back({double(c & 1), double(c >> 1 & 1), double(c >> 2)});
  const std::vector<Point<3>> inner = {{.249, .342, .192}, {.826, .288, .288}, {.273, .750, .230},
                                       {.850, .649, .263}, {.320, .186, .643}, {.677, .305, .683},
                                       {.165, .745, .702}, {.788, .693, .644}};
  points.insert(points.end(), inner.begin(), inner.end());
  std::vector<std::array<int, 4>> tets;
  pull({8, 9, 10, 11, 12, 13, 14, 15}, points, tets);
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side) {
      std::array<int, 8> hex;  // corner bits; along the axis bit 1 means the inner block
      for (int c = 0; c < 8; ++c) {
        const int bit = 1 << axis;
        const int corner = (c & ~bit) | (side ? bit : 0);
        hex[c] = corner + ((c & bit) ? 8 : 0);
      }
      pull(hex, points, tets);
    }
  return gmsh_text<3>(points, tets);
}

}  // namespace breccia
