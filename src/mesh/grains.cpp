#include "mesh/grains.hpp"

#include "core/random.hpp"
#include "mesh/fracture_faces.hpp"
#include "mesh/fracture_sets.hpp"
#include "mesh/geometry.hpp"
#include "mesh/refusal.hpp"
#include "mesh/size_field.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace breccia {
namespace {

constexpr double kMerge = 1.0 / 3;             // of the element size
constexpr std::uint32_t kStream = 0x47524149;  // of grains

struct Corner {
  Point<2> x;
  int beyond;  ///< number of the neighbour across the edge that begins here
};

/// The part of a cell on the side of seed a, away from seed b.
std::vector<Corner> clipped(const std::vector<Corner>& cell, const Point<2>& a, const Point<2>& b,
                            int number) {
  const auto n = minus(b, a);
  const double level = 0.5 * (dot(b, b) - dot(a, a));
  std::vector<Corner> kept;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    const Corner &p = cell[i], &q = cell[(i + 1) % cell.size()];
    const double dp = dot(p.x, n) - level, dq = dot(q.x, n) - level;
    if (dp <= 0) kept.push_back(p);
    if ((dp <= 0) == (dq <= 0)) continue;
    const Point<2> cut = along(p.x, dp / (dp - dq), minus(q.x, p.x));
    kept.push_back({cut, dp <= 0 ? number : p.beyond});
  }
  return kept;
}

/// Seeds on a jittered triangular lattice over a box.
std::vector<Point<2>> lattice(const Point<3>& lower, const Point<3>& upper, double grain,
                              double jitter, std::uint64_t seed) {
  const Random random{seed, kStream};
  const double height = grain * std::sqrt(0.75);
  const int rows = static_cast<int>(std::ceil((upper[1] - lower[1]) / height)) + 4;
  const int columns = static_cast<int>(std::ceil((upper[0] - lower[0]) / grain)) + 4;
  std::vector<Point<2>> seeds;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const auto id = static_cast<std::uint64_t>(j) * static_cast<std::uint64_t>(columns) +
                      static_cast<std::uint64_t>(i);
      const double turn = 6.283185307179586 * random.uniform(id, 0);
      const double shift = jitter * grain * std::sqrt(random.uniform(id, 1));
      seeds.push_back({lower[0] + (i - 1.75 + 0.5 * (j % 2)) * grain + shift * std::cos(turn),
                       lower[1] + (j - 1.75) * height + shift * std::sin(turn)});
    }
  return seeds;
}

/// The edges between the cells of the seeds, each once.
std::vector<std::array<Point<2>, 2>> edges_between(const std::vector<Point<2>>& seeds,
                                                   double grain) {
  std::map<std::array<int, 2>, std::vector<int>> bins;
  const auto bin = [&](const Point<2>& x) {
    return std::array{static_cast<int>(std::floor(x[0] / (2 * grain))),
                      static_cast<int>(std::floor(x[1] / (2 * grain)))};
  };
  for (std::size_t s = 0; s < seeds.size(); ++s) bins[bin(seeds[s])].push_back(static_cast<int>(s));
  std::vector<std::array<Point<2>, 2>> edges;
  for (std::size_t s = 0; s < seeds.size(); ++s) {
    const Point<2>& a = seeds[s];
    const double far = 2 * grain;
    std::vector<Corner> cell = {{{a[0] - far, a[1] - far}, -1},
                                {{a[0] + far, a[1] - far}, -1},
                                {{a[0] + far, a[1] + far}, -1},
                                {{a[0] - far, a[1] + far}, -1}};
    const auto at = bin(a);
    for (int i = at[0] - 1; i <= at[0] + 1; ++i)
      for (int j = at[1] - 1; j <= at[1] + 1; ++j)
        for (const int other : bins[{i, j}])
          if (other != static_cast<int>(s))
            cell = clipped(cell, a, seeds[static_cast<std::size_t>(other)], other);
    for (std::size_t i = 0; i < cell.size(); ++i)
      if (cell[i].beyond > static_cast<int>(s))
        edges.push_back({cell[i].x, cell[(i + 1) % cell.size()].x});
  }
  return edges;
}

/// Corners by place: those closer than `reach` to an earlier one become that one.
class Corners {
 public:
  explicit Corners(double reach) : reach_(reach) {}

  std::size_t number(const Point<2>& x) {
    const auto at = bin(x);
    for (int i = at[0] - 1; i <= at[0] + 1; ++i)
      for (int j = at[1] - 1; j <= at[1] + 1; ++j) {
        const auto found = bins_.find({i, j});
        if (found == bins_.end()) continue;
        for (const std::size_t n : found->second)
          if (length(minus(x, point[n])) <= reach_) return n;
      }
    bins_[at].push_back(point.size());
    point.push_back(x);
    return point.size() - 1;
  }

  std::vector<Point<2>> point;

 private:
  std::array<int, 2> bin(const Point<2>& x) const {
    return {static_cast<int>(std::floor(x[0] / reach_)),
            static_cast<int>(std::floor(x[1] / reach_))};
  }
  double reach_;
  std::map<std::array<int, 2>, std::vector<std::size_t>> bins_;
};

}  // namespace

std::vector<FracturePiece> grain_edges(const BodyShape& body, double grain, double jitter,
                                       std::uint64_t seed) {
  const auto [lower, upper] = box_of(body);
  const double reach = kMerge * body.size;
  if (grain < 2 * body.size)
    refuse("body \"" + body.name + "\"",
           "grains of " + short_number(grain) + " m cannot be made of elements of " +
               short_number(body.size) + " m",
           "take elements of at most half the size of a grain");
  Corners corners(reach);
  std::set<std::array<std::size_t, 2>> edges;
  const bool brick = std::holds_alternative<Rectangle>(body.shape);
  for (auto edge : edges_between(lattice(lower, upper, grain, jitter, seed), grain)) {
    for (auto& x : edge)
      for (int d = 0; brick && d < 2; ++d)
        for (const double side : {lower[d], upper[d]})
          if (std::abs(x[d] - side) <= reach) x[d] = side;
    const std::size_t a = corners.number(edge[0]), b = corners.number(edge[1]);
    if (a != b) edges.insert({std::min(a, b), std::max(a, b)});
  }
  std::vector<FracturePiece> pieces;
  for (const auto& [a, b] : edges) {
    const Point<2>&p = corners.point[a], &q = corners.point[b];
    const FracturePiece piece = {{p[0], p[1], 0}, {q[0], q[1], 0}};
    if (touches_inside(body, piece) && conflict_with_surface(body, piece).empty())
      pieces.push_back(piece);
  }
  return pieces;
}

}  // namespace breccia
