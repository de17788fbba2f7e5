#include "harness/mapped_grid.hpp"

#include <fmt/format.h>

#include <vector>

namespace breccia {

namespace {

/// Nodes are those of a grid of half the width; first order uses every second.
struct HalfGrid {
  int nx, ny;
  bool second_order;

  int tag(int i, int j) const { return 1 + i + j * (2 * nx + 1); }
  bool used(int i, int j) const { return second_order || (i % 2 == 0 && j % 2 == 0); }
};

using Place = std::array<int, 2>;

/// An element of corners on the half grid, and of the middles between them.
std::string element(const HalfGrid& grid, int number, int group, const std::vector<Place>& corner) {
  const std::size_t n = corner.size();
  const int first = n == 2 ? 1 : 2, second = n == 2 ? 8 : 9;
  std::string text =
      fmt::format("{} {} 2 {} {}", number, grid.second_order ? second : first, group, group);
  for (const Place& p : corner) text += fmt::format(" {}", grid.tag(p[0], p[1]));
  for (std::size_t a = 0; grid.second_order && a < (n == 2 ? 1 : n); ++a) {
    const Place &p = corner[a], &q = corner[(a + 1) % n];
    text += fmt::format(" {}", grid.tag((p[0] + q[0]) / 2, (p[1] + q[1]) / 2));
  }
  return text + "\n";
}

/// Groups: 1 all triangles, 2 to 5 the sides, or from 6 on the layers of triangles.
std::vector<std::string> elements(const HalfGrid& grid, int layers) {
  std::vector<std::string> all;
  const auto add = [&](int group, const std::vector<Place>& corner) {
    all.push_back(element(grid, static_cast<int>(all.size()) + 1, group, corner));
  };
  const int nx = 2 * grid.nx, ny = 2 * grid.ny;
  for (int j = 0; j < ny; j += 2) {
    add(2, {{0, j}, {0, j + 2}});
    add(3, {{nx, j}, {nx, j + 2}});
  }
  for (int i = 0; i < nx; i += 2) {
    add(4, {{i, 0}, {i + 2, 0}});
    add(5, {{i, ny}, {i + 2, ny}});
  }
  for (int j = 0; j < ny; j += 2) {
    for (int i = 0; i < nx; i += 2) {
      const int group = layers == 1 ? 1 : 6 + j * layers / ny;
      add(group, {{i, j}, {i + 2, j}, {i + 2, j + 2}});
      add(group, {{i, j}, {i + 2, j + 2}, {i, j + 2}});
    }
  }
  return all;
}

}  // namespace

std::string mapped_grid(int nx, int ny, const Mapping& map, bool second_order, int layers) {
  const HalfGrid grid{nx, ny, second_order};
  std::string nodes;
  int count = 0;
  for (int j = 0; j <= 2 * ny; ++j) {
    for (int i = 0; i <= 2 * nx; ++i) {
      if (!grid.used(i, j)) continue;
      const auto x = map(0.5 * i / nx, 0.5 * j / ny);
      nodes += fmt::format("{} {:.17g} {:.17g} 0\n", grid.tag(i, j), x[0], x[1]);
      ++count;
    }
  }
  const auto list = elements(grid, layers);
  std::string names = "2 1 \"rock\"\n";
  if (layers > 1) names.clear();
  for (int l = 0; layers > 1 && l < layers; ++l)
    names += fmt::format("2 {} \"rock {}\"\n", 6 + l, l);
  std::string text = fmt::format(
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n{}\n{}1 2 \"left\"\n"
      "1 3 \"right\"\n1 4 \"bottom\"\n1 5 \"top\"\n$EndPhysicalNames\n",
      4 + layers, names);
  text += fmt::format("$Nodes\n{}\n{}$EndNodes\n$Elements\n{}\n", count, nodes, list.size());
  for (const std::string& line : list) text += line;
  return text + "$EndElements\n";
}

}  // namespace breccia
