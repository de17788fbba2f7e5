#include "mesh/structured.hpp"

#include "core/random.hpp"
#include "mesh/geometry.hpp"
#include "mesh/refusal.hpp"
#include "mesh/region_builder.hpp"
#include "mesh/sides.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace breccia {
namespace {

// Corners of a grid cell are numbered by bits: bit k set = far along axis k.
constexpr std::array<std::array<int, 4>, 6> kKuhn = {
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};
constexpr std::array<std::array<int, 4>, 5> kFive = {
    {{1, 2, 4, 7}, {1, 2, 0, 4}, {1, 2, 7, 3}, {1, 4, 5, 7}, {2, 4, 7, 6}}};

template <int D>
void check(const Grid<D>& grid) {
  const std::string place = "structured mesh of body \"" + grid.body + "\"";
  double points = grid.pattern == Pattern::cross ? 2 : 1;
  for (int k = 0; k < D; ++k) {
    if (!(grid.upper[k] > grid.lower[k]) || !std::isfinite(grid.upper[k] - grid.lower[k])) {
      refuse(place, "its extent along " + std::string(1, "xyz"[k]) + " is not positive",
             "give lower and upper corners with lower < upper");
    }
    if (grid.cells[k] < 1) {
      refuse(place, "it has " + std::to_string(grid.cells[k]) + " cells along an axis",
             "give at least one cell along each axis");
    }
    points *= grid.cells[k] + 1.0;
  }
  if (!(grid.jitter >= 0 && grid.jitter <= 0.3)) {
    refuse(place, "jitter is " + short_number(grid.jitter),
           "give a jitter from 0 to 0.3 cell sizes; more would invert elements");
  }
  const bool spatial = grid.pattern == Pattern::kuhn || grid.pattern == Pattern::five;
  if (spatial != (D == 3)) {
    refuse(place, "this pattern is not one of a " + std::to_string(D) + "D mesh",
           D == 2 ? "use right, cross or union_jack" : "use kuhn or five");
  }
  if (6 * points * (D + 1) > std::numeric_limits<Index>::max()) {
    refuse(place, short_number(points) + " points are more than 32-bit numbers can count",
           "use a larger element size");
  }
}

/// Grid points with the first axis fastest.
template <int D>
class Lattice {
 public:
  explicit Lattice(const Grid<D>& grid) : grid_(grid) {
    for (int k = 0; k < D; ++k) {
      stride_[k] = k == 0 ? 1 : stride_[k - 1] * (grid.cells[k - 1] + 1);
    }
    points_ = stride_[D - 1] * (grid.cells[D - 1] + 1);
  }

  Index points() const { return points_; }

  Index number(const std::array<Index, D>& i) const {
    Index n = 0;
    for (int k = 0; k < D; ++k) n += i[k] * stride_[k];
    return n;
  }

  /// Corner `bits` of the cell whose first corner is `i`.
  Index corner(std::array<Index, D> i, int bits) const {
    for (int k = 0; k < D; ++k) i[k] += bits >> k & 1;
    return number(i);
  }

  Point<D> position(const std::array<Index, D>& i) const {
    const Random random{grid_.seed, 0};
    bool inside = grid_.jitter > 0;
    for (int k = 0; k < D; ++k) inside = inside && i[k] > 0 && i[k] < grid_.cells[k];
    Point<D> x;
    for (int k = 0; k < D; ++k) {
      const double cells = grid_.cells[k];
      const double shift =
          inside ? grid_.jitter * (2 * random.uniform(number(i), static_cast<std::uint32_t>(k)) - 1)
                 : 0;
      const double s = (i[k] + shift) / cells;
      x[k] = i[k] == grid_.cells[k] ? grid_.upper[k]
                                    : grid_.lower[k] + s * (grid_.upper[k] - grid_.lower[k]);
    }
    return x;
  }

  /// Calls `visit(i)` for every index below `end`, the first axis fastest.
  template <class Visit>
  static void each(const std::array<Index, D>& end, Visit&& visit) {
    std::array<Index, D> i{};
    while (i[D - 1] < end[D - 1]) {
      visit(i);
      for (int k = 0; k < D; ++k) {
        if (++i[k] < end[k] || k == D - 1) break;
        i[k] = 0;
      }
    }
  }

 private:
  Grid<D> grid_;
  std::array<Index, D> stride_{};
  Index points_ = 0;
};

void add_cell(const Grid<2>& grid, const Lattice<2>& lattice, const std::array<Index, 2>& i,
              Mesh<2>& mesh) {
  const std::array<Index, 4> c = {lattice.corner(i, 0), lattice.corner(i, 1), lattice.corner(i, 3),
                                  lattice.corner(i, 2)};
  if (grid.pattern == Pattern::cross) {
    const Index centre = mesh.points();
    Point<2> x{};
    for (Index p : c) x = along(x, 0.25, mesh.point[p]);
    mesh.point.push_back(x);
    for (int s = 0; s < 4; ++s) mesh.element.push_back({c[s], c[(s + 1) % 4], centre});
    return;
  }
  const bool turned = grid.pattern == Pattern::union_jack && (i[0] + i[1]) % 2 == 1;
  const int s = turned ? 1 : 0;  // the diagonal starts at this corner
  mesh.element.push_back({c[s], c[s + 1], c[s + 2]});
  mesh.element.push_back({c[s], c[s + 2], c[(s + 3) % 4]});
}

void add_cell(const Grid<3>& grid, const Lattice<3>& lattice, const std::array<Index, 3>& i,
              Mesh<3>& mesh) {
  const bool mirrored = grid.pattern == Pattern::five && (i[0] + i[1] + i[2]) % 2 == 1;
  const auto add = [&](const std::array<int, 4>& t) {
    std::array<Index, 4> nodes;
    for (int a = 0; a < 4; ++a) nodes[a] = lattice.corner(i, mirrored ? t[a] ^ 1 : t[a]);
    if (mirrored) std::swap(nodes[2], nodes[3]);
    mesh.element.push_back(nodes);
  };
  if (grid.pattern == Pattern::five) {
    for (const auto& t : kFive) add(t);
  } else {
    for (const auto& t : kKuhn) add(t);
  }
}

}  // namespace

template <int D>
std::array<Index, D> cells_of_size(const Point<D>& lower, const Point<D>& upper, double size) {
  std::array<Index, D> cells;
  for (int k = 0; k < D; ++k) {
    const double count = std::round((upper[k] - lower[k]) / size);
    cells[k] = static_cast<Index>(std::clamp(count, 1.0, 1e9));
  }
  return cells;
}

template <int D>
Mesh<D> structured_mesh(const Grid<D>& grid) {
  check(grid);
  Mesh<D> mesh;
  mesh.body_names = {grid.body};
  const Lattice<D> lattice(grid);
  std::array<Index, D> points = grid.cells;
  for (Index& n : points) ++n;
  mesh.point.reserve(lattice.points());
  Lattice<D>::each(points, [&](const auto& i) { mesh.point.push_back(lattice.position(i)); });
  Lattice<D>::each(grid.cells, [&](const auto& i) { add_cell(grid, lattice, i, mesh); });
  mesh.body.assign(mesh.element.size(), 0);
  add_body_regions(mesh);
  if constexpr (D == 2) {
    add_side_regions(mesh, 0, Rectangle{grid.lower, grid.upper});
  } else {
    add_side_regions(mesh, 0, Box{grid.lower, grid.upper});
  }
  return mesh;
}

template std::array<Index, 2> cells_of_size<2>(const Point<2>&, const Point<2>&, double);
template std::array<Index, 3> cells_of_size<3>(const Point<3>&, const Point<3>&, double);
template Mesh<2> structured_mesh<2>(const Grid<2>&);
template Mesh<3> structured_mesh<3>(const Grid<3>&);

}  // namespace breccia
