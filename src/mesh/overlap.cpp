#include "mesh/overlap.hpp"

#include "mesh/geometry.hpp"
#include "mesh/refusal.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace breccia {
namespace {

template <int D>
struct AlignedBox {
  Point<D> lower, upper;
  AlignedBox() {
    lower.fill(std::numeric_limits<double>::infinity());
    upper.fill(-std::numeric_limits<double>::infinity());
  }
  void include(const Point<D>& x) {
    for (int k = 0; k < D; ++k) {
      lower[k] = std::min(lower[k], x[k]);
      upper[k] = std::max(upper[k], x[k]);
    }
  }
  bool meets(const AlignedBox& other) const {
    bool all = true;
    for (int k = 0; k < D; ++k) {
      all = all && lower[k] < other.upper[k] && other.lower[k] < upper[k];
    }
    return all;
  }
};

template <int D>
AlignedBox<D> box_of(const Simplex<D>& x) {
  AlignedBox<D> box;
  for (const auto& corner : x) box.include(corner);
  return box;
}

/// Width of the common part of two simplices along an axis (any length); negative when the axis
/// separates them.
template <int D>
double common_width(const Simplex<D>& x, const Simplex<D>& y, const Point<D>& axis) {
  const double size = length(axis);
  if (!(size > 0)) return std::numeric_limits<double>::infinity();
  const auto range = [&](const Simplex<D>& s) {
    std::pair<double, double> r = {std::numeric_limits<double>::infinity(),
                                   -std::numeric_limits<double>::infinity()};
    for (const auto& corner : s) {
      const double along_axis = dot(minus(corner, x[0]), axis) / size;
      r = {std::min(r.first, along_axis), std::max(r.second, along_axis)};
    }
    return r;
  };
  const auto [x_low, x_high] = range(x);
  const auto [y_low, y_high] = range(y);
  return std::min(x_high - y_low, y_high - x_low);
}

/// Least common width over the axes of the separating axis theorem: face normals and, in space, the
/// products of the edges. Zero or negative: the simplices do not overlap.
template <int D>
double overlap_depth(const Simplex<D>& x, const Simplex<D>& y) {
  double depth = std::numeric_limits<double>::infinity();
  const auto test = [&](const Point<D>& axis) {
    depth = std::min(depth, common_width<D>(x, y, axis));
    return depth > 0;
  };
  for (int f = 0; f <= D; ++f) {
    if (!test(face_normal_area<D>(x, f)) || !test(face_normal_area<D>(y, f))) return depth;
  }
  if constexpr (D == 3) {
    constexpr int edges[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
    for (const auto& a : edges) {
      for (const auto& b : edges) {
        const auto u = minus(x[a[1]], x[a[0]]);
        const auto v = minus(y[b[1]], y[b[0]]);
        const auto axis = cross(u, v);
        // Nearly parallel edges give an axis of noise; the face normals then separate.
        if (length(axis) <= 1e-8 * length(u) * length(v)) continue;
        if (!test(axis)) return depth;
      }
    }
  }
  return depth;
}

/// Elements whose box meets the box of another body.
template <int D>
std::vector<Index> candidates(const Mesh<D>& mesh) {
  const std::size_t bodies = mesh.body_names.size();
  std::vector<AlignedBox<D>> body_box(bodies);
  for (Index e = 0; e < mesh.elements(); ++e) {
    for (Index p : mesh.element[e]) body_box[mesh.body[e]].include(mesh.point[p]);
  }
  std::vector<std::vector<Index>> near(bodies);
  for (std::size_t a = 0; a < bodies; ++a) {
    for (std::size_t b = 0; b < bodies; ++b) {
      if (a != b && body_box[a].meets(body_box[b])) near[a].push_back(static_cast<Index>(b));
    }
  }
  std::vector<Index> chosen;
  for (Index e = 0; e < mesh.elements(); ++e) {
    const auto& others = near[mesh.body[e]];
    if (others.empty()) continue;
    const auto box = box_of<D>(corners(mesh, e));
    if (std::any_of(others.begin(), others.end(),
                    [&](Index b) { return box.meets(body_box[b]); })) {
      chosen.push_back(e);
    }
  }
  return chosen;
}

/// A grid cell touched by an element's box.
template <int D>
struct CellEntry {
  std::array<std::int64_t, D> cell;
  Index element;
  auto operator<=>(const CellEntry&) const = default;
};

template <int D>
struct CellGrid {
  double width;

  std::array<std::int64_t, D> cell_of(const Point<D>& x) const {
    std::array<std::int64_t, D> cell;
    for (int k = 0; k < D; ++k) cell[k] = static_cast<std::int64_t>(std::floor(x[k] / width));
    return cell;
  }
};

template <int D>
std::vector<CellEntry<D>> sorted_cells(const Mesh<D>& mesh, const std::vector<Index>& elements,
                                       const CellGrid<D>& grid) {
  std::vector<CellEntry<D>> entries;
  for (Index e : elements) {
    const auto box = box_of<D>(corners(mesh, e));
    const auto first = grid.cell_of(box.lower);
    const auto last = grid.cell_of(box.upper);
    auto cell = first;
    for (bool more = true; more;) {
      entries.push_back({cell, e});
      more = false;
      for (int k = 0; k < D && !more; ++k) {
        more = ++cell[k] <= last[k];
        if (!more) cell[k] = first[k];
      }
    }
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

/// The mean box, but not so small that the largest box would cover thousands of cells.
template <int D>
double cell_width(const Mesh<D>& mesh, const std::vector<Index>& elements) {
  double sum = 0;
  double largest = 0;
  for (Index e : elements) {
    const auto box = box_of<D>(corners(mesh, e));
    double side = 0;
    for (int k = 0; k < D; ++k) side = std::max(side, box.upper[k] - box.lower[k]);
    sum += side;
    largest = std::max(largest, side);
  }
  return std::max(sum / static_cast<double>(elements.size()), largest / 8);
}

template <int D>
void test_pair(const Mesh<D>& mesh, Index a, Index b, double tolerance,
               std::optional<Overlap<D>>& deepest) {
  const auto x = corners(mesh, a);
  const auto y = corners(mesh, b);
  const double depth = overlap_depth<D>(x, y);
  const auto hx = heights<D>(x);
  const auto hy = heights<D>(y);
  const double least =
      std::min(*std::min_element(hx.begin(), hx.end()), *std::min_element(hy.begin(), hy.end()));
  if (depth <= tolerance * least || (deepest && depth <= deepest->depth)) return;
  const auto box_x = box_of<D>(x);
  const auto box_y = box_of<D>(y);
  Overlap<D> found{mesh.body_names[mesh.body[a]], mesh.body_names[mesh.body[b]], a, b, {}, depth};
  for (int k = 0; k < D; ++k) {
    found.place[k] =
        0.5 * (std::max(box_x.lower[k], box_y.lower[k]) + std::min(box_x.upper[k], box_y.upper[k]));
  }
  deepest = found;
}

}  // namespace

template <int D>
std::optional<Overlap<D>> find_overlap(const Mesh<D>& mesh, double tolerance) {
  std::optional<Overlap<D>> deepest;
  const auto elements = candidates(mesh);
  if (elements.empty()) return deepest;
  const CellGrid<D> grid{cell_width(mesh, elements)};
  const auto entries = sorted_cells(mesh, elements, grid);
  for (std::size_t begin = 0, end = 0; begin < entries.size(); begin = end) {
    while (end < entries.size() && entries[end].cell == entries[begin].cell) ++end;
    for (std::size_t i = begin; i < end; ++i) {
      const auto box_i = box_of<D>(corners(mesh, entries[i].element));
      for (std::size_t j = i + 1; j < end; ++j) {
        const Index a = entries[i].element;
        const Index b = entries[j].element;
        if (mesh.body[a] == mesh.body[b]) continue;
        const auto box_j = box_of<D>(corners(mesh, b));
        if (!box_i.meets(box_j)) continue;
        Point<D> first;  // the pair is tested only in the cell of this corner of its common box
        for (int k = 0; k < D; ++k) first[k] = std::max(box_i.lower[k], box_j.lower[k]);
        if (grid.cell_of(first) == entries[i].cell) test_pair(mesh, a, b, tolerance, deepest);
      }
    }
  }
  return deepest;
}

template <int D>
void refuse_overlap(const Mesh<D>& mesh, double tolerance) {
  const auto found = find_overlap(mesh, tolerance);
  if (!found) return;
  refuse("bodies \"" + found->body_a + "\" and \"" + found->body_b + "\"",
         "they overlap at the start near " + place_text(found->place) + " by " +
             short_number(found->depth) + " m (elements " + std::to_string(found->element_a) +
             " and " + std::to_string(found->element_b) + ")",
         "move them apart, or give both the same part_of so that they are meshed as one solid");
}

template std::optional<Overlap<2>> find_overlap<2>(const Mesh<2>&, double);
template std::optional<Overlap<3>> find_overlap<3>(const Mesh<3>&, double);
template void refuse_overlap<2>(const Mesh<2>&, double);
template void refuse_overlap<3>(const Mesh<3>&, double);

}  // namespace breccia
