#include "step/observation.hpp"

#include <algorithm>

namespace breccia {

void Row::set(const std::string& column, double value, Merge merge) {
  const auto found = std::find(columns_.begin(), columns_.end(), column);
  if (found != columns_.end()) {
    const auto i = static_cast<std::size_t>(found - columns_.begin());
    values_[i] = value;
    if (merge != Merge::same) merges_[i] = merge;
    return;
  }
  columns_.push_back(column);
  values_.push_back(value);
  merges_.push_back(merge);
}

double Row::get(const std::string& column) const {
  const auto found = std::find(columns_.begin(), columns_.end(), column);
  return found == columns_.end() ? 0.0
                                 : values_[static_cast<std::size_t>(found - columns_.begin())];
}

void Row::merge(const World& world) {
  std::vector<double> sums;
  for (std::size_t i = 0; i < values_.size(); ++i) {
    if (merges_[i] == Merge::sum) sums.push_back(values_[i]);
    if (merges_[i] == Merge::largest) values_[i] = world.largest(values_[i]);
  }
  world.add_up(sums);
  auto next = sums.begin();
  for (std::size_t i = 0; i < values_.size(); ++i)
    if (merges_[i] == Merge::sum) values_[i] = *next++;
}

void Row::restart_row() {
  std::fill(values_.begin(), values_.end(), 0.0);
}

}  // namespace breccia
