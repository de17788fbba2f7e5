#include "mesh/copies.hpp"

#include "mesh/overlap.hpp"
#include "mesh/refusal.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <string>

namespace breccia {

namespace {

/// One body cut out of a mesh: its own numbers of points and elements, and theirs in the mesh.
template <int D>
struct Cutting {
  std::vector<Index> element, point;
  std::vector<Index> place;  ///< of a point of the mesh among `point`, or kNone

  Cutting(const Mesh<D>& mesh, Index body) : place(mesh.point.size(), kNone) {
    for (Index e = 0; e < mesh.elements(); ++e) {
      if (mesh.body[e] != body) continue;
      element.push_back(e);
      for (const Index p : mesh.element[e]) place[p] = 0;
    }
    for (Index p = 0; p < mesh.points(); ++p) {
      if (place[p] == kNone) continue;
      place[p] = static_cast<Index>(point.size());
      point.push_back(p);
    }
  }
};

template <int D>
Vec<D> as_vector(const Point<D>& p) {
  Vec<D> v;
  std::copy_n(p.begin(), D, v.v);
  return v;
}

template <int D>
Point<D> moved(const Point<D>& p, const Vec<D>& middle, const Placement<D>& to) {
  const Vec<D> at = to.centre + to.turn * (as_vector<D>(p) - middle);
  Point<D> q{};
  for (int d = 0; d < D; ++d) q[d] = at[d];
  return q;
}

/// Adds to a region what the copies have of it; their elements and points follow one another.
template <int D>
void extend(Region& region, const Cutting<D>& cut, std::size_t copies, Index first_element,
            Index first_point) {
  std::vector<Index> order(cut.element.empty() ? 0 : cut.element.back() + 1, kNone);
  for (std::size_t i = 0; i < cut.element.size(); ++i)
    order[cut.element[i]] = static_cast<Index>(i);
  const auto own = [&](Index e) { return e < static_cast<Index>(order.size()) ? order[e] : kNone; };
  const Region original = region;
  for (std::size_t c = 0; c < copies; ++c) {
    const Index elements = first_element + static_cast<Index>(c * cut.element.size());
    const Index points = first_point + static_cast<Index>(c * cut.point.size());
    for (const Index e : original.elements)
      if (own(e) != kNone) region.elements.push_back(elements + own(e));
    for (const ElementFace& f : original.faces)
      if (own(f.element) != kNone) region.faces.push_back({elements + own(f.element), f.face});
    for (const Index p : original.points)
      if (cut.place[p] != kNone) region.points.push_back(points + cut.place[p]);
  }
}

/// Each copy a body of its own, for the search for overlaps.
template <int D>
void refuse_copies_that_overlap(const Mesh<D>& mesh, const std::string& name,
                                const std::vector<Index>& original, Index first_element,
                                std::size_t per_copy) {
  Mesh<D> apart;
  apart.point = mesh.point;
  const auto add = [&](Index e, Index copy) {
    apart.element.push_back(mesh.element[e]);
    apart.body.push_back(copy);
  };
  for (const Index e : original) add(e, 0);
  for (Index e = first_element; e < mesh.elements(); ++e)
    add(e, 1 + static_cast<Index>(static_cast<std::size_t>(e - first_element) / per_copy));
  for (Index c = 0; c <= apart.body.back(); ++c) apart.body_names.push_back(std::to_string(c));
  const auto overlap = find_overlap(apart);
  if (!overlap) return;
  char text[160];
  std::snprintf(text, sizeof text, "copies %s and %s overlap by %.4g m at (%.4g, %.4g%s)",
                overlap->body_a.c_str(), overlap->body_b.c_str(), overlap->depth, overlap->place[0],
                overlap->place[1],
                D == 3 ? (", " + std::to_string(overlap->place[D - 1])).c_str() : "");
  refuse("body \"" + name + "\"", text, "widen the pitch, or lessen the shift of the copies");
}

}  // namespace

template <int D>
Vec<D> middle_of_body(const Mesh<D>& mesh, Index body) {
  Vec<D> low, high;
  for (int d = 0; d < D; ++d) {
    low[d] = std::numeric_limits<double>::infinity();
    high[d] = -low[d];
  }
  for (Index e = 0; e < mesh.elements(); ++e)
    if (mesh.body[e] == body)
      for (const Index p : mesh.element[e])
        for (int d = 0; d < D; ++d) {
          low[d] = std::min(low[d], mesh.point[p][d]);
          high[d] = std::max(high[d], mesh.point[p][d]);
        }
  return (low + high) * 0.5;
}

template <int D>
void copy_body(Mesh<D>& mesh, Index body, const std::vector<Placement<D>>& placements) {
  const Vec<D> middle = middle_of_body(mesh, body);
  const Cutting<D> cut(mesh, body);
  const Index first_point = mesh.points(), first_element = mesh.elements();
  const auto curved = mesh.curved;
  const std::size_t copies = placements.size() - 1;
  for (std::size_t c = 1; c <= copies; ++c) {
    const Index shift = mesh.points();
    const auto there = [&](Index p) { return shift + cut.place[p]; };
    for (const Index p : cut.point)
      mesh.point.push_back(moved<D>(mesh.point[p], middle, placements[c]));
    for (const Index e : cut.element) {
      auto nodes = mesh.element[e];
      for (Index& p : nodes) p = there(p);
      mesh.element.push_back(nodes);
      mesh.body.push_back(body);
    }
    for (const auto& [edge, at] : curved)
      if (cut.place[edge[0]] != kNone && cut.place[edge[1]] != kNone)
        mesh.curved[edge_of(there(edge[0]), there(edge[1]))] = moved<D>(at, middle, placements[c]);
  }
  for (const Index p : cut.point) mesh.point[p] = moved<D>(mesh.point[p], middle, placements[0]);
  for (auto& [edge, at] : mesh.curved)
    if (edge[1] < first_point && cut.place[edge[0]] != kNone && cut.place[edge[1]] != kNone)
      at = moved<D>(at, middle, placements[0]);
  std::vector<Index> old(static_cast<std::size_t>(first_element));
  for (Index e = 0; e < first_element; ++e) old[e] = e;
  for (std::size_t c = 0; c < copies; ++c)
    old.insert(old.end(), cut.element.begin(), cut.element.end());
  mesh.fields = fields_of(mesh.fields, old);
  for (Region& region : mesh.regions) extend(region, cut, copies, first_element, first_point);
  if (copies > 0)
    refuse_copies_that_overlap(mesh, mesh.body_names[body], cut.element, first_element,
                               cut.element.size());
}

template Vec<2> middle_of_body(const Mesh<2>&, Index);
template Vec<3> middle_of_body(const Mesh<3>&, Index);
template void copy_body(Mesh<2>&, Index, const std::vector<Placement<2>>&);
template void copy_body(Mesh<3>&, Index, const std::vector<Placement<3>>&);

}  // namespace breccia
