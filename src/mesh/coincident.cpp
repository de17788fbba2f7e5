#include "mesh/coincident.hpp"

#include "core/disjoint_sets.hpp"
#include "mesh/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace breccia {
namespace {

/// One number per point: the smallest body of the bodies hanging together by shared points.
template <int D>
std::vector<Index> point_groups(const Mesh<D>& mesh) {
  DisjointSets bodies(mesh.body_names.size());
  std::vector<Index> group(mesh.point.size(), kNone);
  for (Index e = 0; e < mesh.elements(); ++e) {
    for (Index p : mesh.element[e]) {
      if (group[p] == kNone) group[p] = mesh.body[e];
      bodies.join(group[p], mesh.body[e]);
    }
  }
  for (Index& g : group) {
    if (g != kNone) g = bodies.root(g);
  }
  return group;
}

template <int D>
double shortest_edge(const Mesh<D>& mesh) {
  double shortest = std::numeric_limits<double>::infinity();
  for (Index e = 0; e < mesh.elements(); ++e) {
    const auto x = corners(mesh, e);
    for (int a = 0; a <= D; ++a) {
      for (int b = 0; b < a; ++b) shortest = std::min(shortest, length(minus(x[a], x[b])));
    }
  }
  return shortest;
}

/// Cells much wider than the tolerance and much narrower than an edge: a cell holds one point
/// unless points coincide.
template <int D>
struct Cell {
  Index group;
  std::array<std::int64_t, D> index;
  Index point;
  auto operator<=>(const Cell&) const = default;
};

}  // namespace

template <int D>
std::vector<Index> coincident_points(const Mesh<D>& mesh) {
  const double tolerance = 1e-6 * shortest_edge(mesh);
  const double width = 64 * tolerance;
  const auto group = point_groups(mesh);
  std::vector<Cell<D>> cells(mesh.point.size());
  for (Index p = 0; p < mesh.points(); ++p) {
    cells[p] = {group[p], {}, p};
    for (int k = 0; k < D; ++k) {
      cells[p].index[k] = static_cast<std::int64_t>(std::floor(mesh.point[p][k] / width));
    }
  }
  std::sort(cells.begin(), cells.end());
  std::vector<Index> pairs;
  const auto compare_with = [&](Cell<D> target, Index p) {
    target.point = p + 1;  // each pair once, from its smaller point
    auto other = std::lower_bound(cells.begin(), cells.end(), target);
    for (; other != cells.end() && other->group == target.group && other->index == target.index;
         ++other) {
      if (length(minus(mesh.point[p], mesh.point[other->point])) > tolerance) continue;
      pairs.push_back(p);
      pairs.push_back(other->point);
    }
  };
  for (const Cell<D>& cell : cells) {
    // Neighbouring cells within the tolerance, one bit per axis; most points have none.
    std::array<int, D> step{};
    int near = 0;
    for (int k = 0; k < D; ++k) {
      const double offset = mesh.point[cell.point][k] - width * static_cast<double>(cell.index[k]);
      step[k] = offset <= tolerance ? -1 : (offset >= width - tolerance ? 1 : 0);
      if (step[k] != 0) near |= 1 << k;
    }
    for (int subset = 0; subset < 1 << D; ++subset) {
      if ((subset & near) != subset) continue;
      Cell<D> target = cell;
      for (int k = 0; k < D; ++k) {
        if (subset >> k & 1) target.index[k] += step[k];
      }
      compare_with(target, cell.point);
    }
  }
  return pairs;
}

template std::vector<Index> coincident_points<2>(const Mesh<2>&);
template std::vector<Index> coincident_points<3>(const Mesh<3>&);

}  // namespace breccia
