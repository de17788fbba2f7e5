#include "scene/force_chains.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace breccia {

/// All touches of two fragments; the force is that on the first one.
struct ForceChains::Contact {
  double force[3] = {}, place[3] = {};
  double weight = 0;
  std::int32_t points = 0;

  void add(const Touch& touch, double sign) {
    const double w = std::hypot(touch.force[0], touch.force[1], touch.force[2]);
    for (int d = 0; d < 3; ++d) {
      force[d] += sign * touch.force[d];
      place[d] += w * touch.place[d];
    }
    weight += w;
    ++points;
  }
};

ForceChains::ForceChains(int dimension, const std::vector<Touch>& touches,
                         const Fragments& fragments)
    : dimension_(dimension) {
  std::map<std::pair<Index, Index>, Contact> contacts;
  for (const Touch& touch : touches) {
    const Index own = fragments.of_element[static_cast<std::size_t>(touch.element)];
    const Index other = fragments.of_element[static_cast<std::size_t>(touch.target)];
    if (own != other) contacts[std::minmax(own, other)].add(touch, own < other ? 1.0 : -1.0);
  }
  for (const auto& [pair, contact] : contacts) {
    if (!(contact.weight > 0)) continue;
    const auto first = static_cast<std::int32_t>(points_.size()) / dimension_;
    const auto& pieces = fragments.pieces;
    for (int d = 0; d < dimension_; ++d)
      points_.push_back(pieces[static_cast<std::size_t>(pair.first)].place[d]);
    for (int d = 0; d < dimension_; ++d) points_.push_back(contact.place[d] / contact.weight);
    for (int d = 0; d < dimension_; ++d)
      points_.push_back(pieces[static_cast<std::size_t>(pair.second)].place[d]);
    add_leg(first, contact, pair.first, pair.second, 1, fragments);
    add_leg(first + 1, contact, pair.second, pair.first, -1, fragments);
  }
}

void ForceChains::add_leg(std::int32_t first, const Contact& contact, Index own, Index other,
                          double sign, const Fragments& fragments) {
  const auto size = [&](Index fragment) {
    const auto& piece = fragments.pieces[static_cast<std::size_t>(fragment)];
    return std::max(piece.length, piece.width);
  };
  connectivity_.insert(connectivity_.end(), {first, first + 1});
  for (int d = 0; d < dimension_; ++d) force_.push_back(sign * contact.force[d]);
  fragment_.push_back(own);
  partner_.push_back(other);
  size_.push_back(size(own));
  partner_size_.push_back(size(other));
  contacts_.push_back(contact.points);
}

Frame ForceChains::frame(double time, std::int64_t step) const {
  const auto numbers = [](const std::vector<double>& v) { return std::span<const double>(v); };
  const auto indices = [](const std::vector<std::int32_t>& v) {
    return std::span<const std::int32_t>(v);
  };
  Frame frame;
  frame.dimension = dimension_;
  frame.points = points_;
  frame.cell = CellType::line;
  frame.connectivity = connectivity_;
  frame.cell_arrays = {
      {"force", "N", dimension_, numbers(force_)},      {"fragment", "1", 1, indices(fragment_)},
      {"partner", "1", 1, indices(partner_)},           {"size", "m", 1, numbers(size_)},
      {"partner_size", "m", 1, numbers(partner_size_)}, {"contacts", "1", 1, indices(contacts_)}};
  frame.time = time;
  frame.step = step;
  return frame;
}

}  // namespace breccia
