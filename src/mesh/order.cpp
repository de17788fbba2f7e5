#include "mesh/order.hpp"

#include "mesh/geometry.hpp"
#include "mesh/hilbert.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <tuple>

namespace breccia {
namespace {

template <int D>
struct BoundingBox {
  Point<D> lower;
  double extent = 0;  // of the largest side: a cube keeps the curve isotropic
};

template <int D>
BoundingBox<D> bounding_cube(const Mesh<D>& mesh) {
  Point<D> lower, upper;
  lower.fill(std::numeric_limits<double>::infinity());
  upper.fill(-std::numeric_limits<double>::infinity());
  for (const auto& x : mesh.point) {
    for (int k = 0; k < D; ++k) {
      lower[k] = std::min(lower[k], x[k]);
      upper[k] = std::max(upper[k], x[k]);
    }
  }
  BoundingBox<D> box{lower, 0};
  for (int k = 0; k < D; ++k) box.extent = std::max(box.extent, upper[k] - lower[k]);
  return box;
}

template <int D>
std::uint64_t curve_position(const Point<D>& x, const BoundingBox<D>& box) {
  constexpr int bits = D == 2 ? 31 : 21;
  const double cells = static_cast<double>((1u << bits) - 1);
  std::array<std::uint32_t, D> cell{};
  for (int k = 0; k < D; ++k) {
    const double s = box.extent > 0 ? (x[k] - box.lower[k]) / box.extent : 0;
    cell[k] = static_cast<std::uint32_t>(std::clamp(s, 0.0, 1.0) * cells);
  }
  return hilbert_position<D>(cell, bits);
}

std::vector<Index> inverse(const std::vector<Index>& order) {
  std::vector<Index> place(order.size());
  for (std::size_t n = 0; n < order.size(); ++n) place[order[n]] = static_cast<Index>(n);
  return place;
}

template <class T>
void sort_unique(std::vector<T>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

/// Points in the order in which the elements meet them; points without element last.
template <int D>
std::vector<Index> points_by_first_use(const Mesh<D>& mesh, const std::vector<Index>& elements) {
  std::vector<Index> order;
  order.reserve(mesh.point.size());
  std::vector<char> taken(mesh.point.size(), 0);
  const auto take = [&](Index p) {
    if (!taken[p]) order.push_back(p);
    taken[p] = 1;
  };
  for (Index e : elements) {
    for (Index p : mesh.element[e]) take(p);
  }
  for (Index p = 0; p < mesh.points(); ++p) take(p);
  return order;
}

}  // namespace

template <int D>
Ordering locality_order(const Mesh<D>& mesh, std::span<const Index> block) {
  if (!block.empty() && block.size() != mesh.element.size()) {
    throw std::logic_error("locality_order: the block list has not one entry per element");
  }
  using Entry = std::tuple<Index, std::uint64_t, Index>;
  const auto box = bounding_cube(mesh);
  std::vector<Entry> entry(mesh.element.size());
  for (Index e = 0; e < mesh.elements(); ++e) {
    const auto position = curve_position<D>(centroid<D>(corners(mesh, e)), box);
    entry[e] = {block.empty() ? 0 : block[e], position, e};
  }
  std::sort(entry.begin(), entry.end());
  Ordering ordering;
  ordering.element.reserve(entry.size());
  for (const Entry& e : entry) ordering.element.push_back(std::get<2>(e));
  ordering.point = points_by_first_use(mesh, ordering.element);
  return ordering;
}

template <int D>
Ordering first_use_order(const Mesh<D>& mesh) {
  Ordering ordering;
  ordering.element.resize(mesh.element.size());
  std::iota(ordering.element.begin(), ordering.element.end(), Index{0});
  ordering.point = points_by_first_use(mesh, ordering.element);
  return ordering;
}

template <int D>
Mesh<D> reordered(const Mesh<D>& mesh, const Ordering& ordering) {
  const auto new_point = inverse(ordering.point);
  const auto new_element = inverse(ordering.element);
  Mesh<D> result;
  result.body_names = mesh.body_names;
  result.group_size = mesh.group_size;
  result.fields = fields_of(mesh.fields, ordering.element);
  for (const auto& [edge, middle] : mesh.curved) {
    result.curved[edge_of(new_point[edge[0]], new_point[edge[1]])] = middle;
  }
  for (Index p : ordering.point) result.point.push_back(mesh.point[p]);
  for (Index e : ordering.element) {
    auto nodes = mesh.element[e];
    for (Index& p : nodes) p = new_point[p];
    result.element.push_back(nodes);
    result.body.push_back(mesh.body[e]);
  }
  for (Region region : mesh.regions) {
    for (Index& e : region.elements) e = new_element[e];
    for (ElementFace& f : region.faces) f.element = new_element[f.element];
    for (Index& p : region.points) p = new_point[p];
    sort_unique(region.elements);
    sort_unique(region.faces);
    sort_unique(region.points);
    result.regions.push_back(std::move(region));
  }
  return result;
}

template <int D>
double mean_index_distance(const Mesh<D>& mesh) {
  double sum = 0;
  double pairs = 0;
  for (const auto& nodes : mesh.element) {
    for (int a = 0; a <= D; ++a) {
      for (int b = 0; b < a; ++b, ++pairs) {
        sum += std::abs(static_cast<double>(nodes[a]) - static_cast<double>(nodes[b]));
      }
    }
  }
  return pairs > 0 ? sum / pairs / static_cast<double>(mesh.point.size()) : 0;
}

template Ordering locality_order<2>(const Mesh<2>&, std::span<const Index>);
template Ordering locality_order<3>(const Mesh<3>&, std::span<const Index>);
template Ordering first_use_order<2>(const Mesh<2>&);
template Ordering first_use_order<3>(const Mesh<3>&);
template Mesh<2> reordered<2>(const Mesh<2>&, const Ordering&);
template Mesh<3> reordered<3>(const Mesh<3>&, const Ordering&);
template double mean_index_distance<2>(const Mesh<2>&);
template double mean_index_distance<3>(const Mesh<3>&);

}  // namespace breccia
