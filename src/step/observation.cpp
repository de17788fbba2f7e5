#include "step/observation.hpp"

#include <algorithm>

namespace breccia {

void Row::set(const std::string& column, double value) {
  const auto found = std::find(columns_.begin(), columns_.end(), column);
  if (found != columns_.end()) {
    values_[static_cast<std::size_t>(found - columns_.begin())] = value;
    return;
  }
  columns_.push_back(column);
  values_.push_back(value);
}

double Row::get(const std::string& column) const {
  const auto found = std::find(columns_.begin(), columns_.end(), column);
  return found == columns_.end() ? 0.0
                                 : values_[static_cast<std::size_t>(found - columns_.begin())];
}

void Row::restart_row() {
  std::fill(values_.begin(), values_.end(), 0.0);
}

}  // namespace breccia
