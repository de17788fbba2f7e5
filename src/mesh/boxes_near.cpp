#include "mesh/part.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace breccia {

namespace {

template <int D>
using Cell = std::array<std::int64_t, D>;

template <int D>
struct CellHash {
  std::size_t operator()(const Cell<D>& cell) const {
    std::size_t h = 0;
    for (const std::int64_t c : cell) h = (h ^ static_cast<std::size_t>(c)) * 0x9E3779B97F4A7C15u;
    return h ^ (h >> 32);
  }
};

/// Mean of the boxes' longest sides.
template <int D>
double mean_side(const std::vector<AxisBox<D>>& boxes) {
  double sum = 0;
  for (const AxisBox<D>& box : boxes) {
    double side = 0;
    for (std::size_t d = 0; d < D; ++d) side = std::max(side, box.high[d] - box.low[d]);
    sum += side;
  }
  return sum / static_cast<double>(boxes.size());
}

/// Calls f(cell) for each cell of this size that a box touches.
template <int D, class F>
void cover(const AxisBox<D>& box, double size, const F& f) {
  Cell<D> first, last, at;
  for (std::size_t d = 0; d < D; ++d) {
    at[d] = first[d] = static_cast<std::int64_t>(std::floor(box.low[d] / size));
    last[d] = static_cast<std::int64_t>(std::floor(box.high[d] / size));
  }
  while (at[0] <= last[0]) {
    f(at);
    std::size_t d = D - 1;
    for (; d > 0 && at[d] == last[d]; --d) at[d] = first[d];
    ++at[d];
  }
}

template <int D>
bool touch(const AxisBox<D>& a, const AxisBox<D>& b) {
  for (std::size_t d = 0; d < D; ++d)
    if (a.low[d] > b.high[d] || b.low[d] > a.high[d]) return false;
  return true;
}

}  // namespace

template <int D>
std::vector<Index> boxes_near(const std::vector<AxisBox<D>>& boxes,
                              const std::vector<Index>& chosen, double reach) {
  const double size = 2 * (mean_side(boxes) + reach);
  std::unordered_map<Cell<D>, std::vector<Index>, CellHash<D>> cells;
  std::vector<std::uint8_t> taken(boxes.size(), 0);
  std::vector<AxisBox<D>> wide(boxes);
  for (const Index i : chosen) {
    AxisBox<D>& box = wide[static_cast<std::size_t>(i)];
    for (std::size_t d = 0; d < D; ++d) {
      box.low[d] -= reach;
      box.high[d] += reach;
    }
    taken[static_cast<std::size_t>(i)] = 1;
    cover<D>(box, size, [&](const Cell<D>& cell) { cells[cell].push_back(i); });
  }
  std::vector<Index> near;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    bool is = taken[i] != 0;
    if (!is)
      cover<D>(boxes[i], size, [&](const Cell<D>& cell) {
        const auto found = is ? cells.end() : cells.find(cell);
        if (found == cells.end()) return;
        is = std::any_of(found->second.begin(), found->second.end(), [&](Index j) {
          return touch(boxes[i], wide[static_cast<std::size_t>(j)]);
        });
      });
    if (is) near.push_back(static_cast<Index>(i));
  }
  return near;
}

template std::vector<Index> boxes_near<2>(const std::vector<AxisBox<2>>&, const std::vector<Index>&,
                                          double);
template std::vector<Index> boxes_near<3>(const std::vector<AxisBox<3>>&, const std::vector<Index>&,
                                          double);

}  // namespace breccia
