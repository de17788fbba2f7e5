#include "scene/emissions.hpp"

#include "base/index.hpp"
#include "core/disjoint_sets.hpp"

#include <array>
#include <cmath>
#include <deque>
#include <map>

namespace breccia {

namespace {

using Cell = std::array<std::int64_t, 3>;

/// Breaks of the last `pause`, by cells as wide as the reach.
class Recent {
 public:
  Recent(const std::vector<CrackEvent>& events, const EmissionRule& rule)
      : events_(events), rule_(rule) {}

  /// Calls `with` for every earlier break that is near in space and time, then keeps this one.
  template <class With>
  void meet(Index i, const With& with) {
    const CrackEvent& event = events_[static_cast<std::size_t>(i)];
    const Cell at = cell(event);
    for (std::int64_t dx = -1; dx <= 1; ++dx)
      for (std::int64_t dy = -1; dy <= 1; ++dy)
        for (std::int64_t dz = -1; dz <= 1; ++dz) {
          const auto found = cells_.find({at[0] + dx, at[1] + dy, at[2] + dz});
          if (found == cells_.end()) continue;
          std::deque<Index>& list = found->second;
          while (!list.empty() && event.time - time(list.front()) > rule_.pause) list.pop_front();
          for (const Index j : list)
            if (near(event, events_[static_cast<std::size_t>(j)])) with(j);
        }
    cells_[at].push_back(i);
  }

 private:
  double time(Index i) const { return events_[static_cast<std::size_t>(i)].time; }

  Cell cell(const CrackEvent& event) const {
    Cell at{};
    for (std::size_t d = 0; d < 3; ++d)
      at[d] = static_cast<std::int64_t>(std::floor(event.place[d] / rule_.reach));
    return at;
  }

  bool near(const CrackEvent& a, const CrackEvent& b) const {
    double sum = 0;
    for (std::size_t d = 0; d < 3; ++d)
      sum += (a.place[d] - b.place[d]) * (a.place[d] - b.place[d]);
    return sum <= rule_.reach * rule_.reach;
  }

  const std::vector<CrackEvent>& events_;
  const EmissionRule& rule_;
  std::map<Cell, std::deque<Index>> cells_;
};

void add(EmissionRow& sum, const CrackEvent& event) {
  const double energy = event.energy_tension + event.energy_shear;
  sum.duration = event.time - sum.time;
  for (std::size_t d = 0; d < 3; ++d) sum.place[d] += energy * event.place[d];
  ++sum.breaks;
  sum.area += event.area;
  sum.mode += event.energy_shear;
  sum.energy += energy;
  sum.moment += event.moment;
}

void finish(EmissionRow& row, const CrackEvent& first) {
  for (std::size_t d = 0; d < 3; ++d)
    row.place[d] = row.energy > 0 ? row.place[d] / row.energy : first.place[d];
  row.mode = row.energy > 0 ? 1 + row.mode / row.energy : first.mode;
  row.magnitude = 2.0 / 3 * std::log10(row.moment) - 6.03;
}

}  // namespace

std::vector<EmissionRow> find_emissions(const std::vector<CrackEvent>& events,
                                        const EmissionRule& rule) {
  const auto count = static_cast<Index>(events.size());
  DisjointSets sets(events.size());
  Recent recent(events, rule);
  for (Index i = 0; i < count; ++i) recent.meet(i, [&](Index j) { sets.join(i, j); });
  std::vector<EmissionRow> rows;
  std::vector<Index> first;
  std::map<Index, std::size_t> number;  // of each set, in the order of first breaks
  for (Index i = 0; i < count; ++i) {
    const CrackEvent& event = events[static_cast<std::size_t>(i)];
    const auto [found, fresh] = number.try_emplace(sets.root(i), rows.size());
    if (fresh) {
      EmissionRow row;
      row.time = event.time;
      row.mode = 0;  // gathers the energy of shear until `finish`
      rows.push_back(row);
      first.push_back(i);
    }
    add(rows[found->second], event);
  }
  for (std::size_t r = 0; r < rows.size(); ++r)
    finish(rows[r], events[static_cast<std::size_t>(first[r])]);
  return rows;
}

}  // namespace breccia
