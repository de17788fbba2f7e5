#pragma once

#include "base/simplex.hpp"
#include "mesh/mesh.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace breccia {

/// Calls `visit(std::span<const ElementFace>)` once per face of the mesh with all elements that
/// have it, sorted by element. Faces come in a fixed order (by their smallest point, then the
/// others). Time and memory are proportional to the mesh: faces are bucketed by their smallest
/// point, a bucket holds one star.
template <int D, class Visit>
void for_each_face(const Mesh<D>& mesh, Visit&& visit) {
  struct Entry {
    std::array<Index, D - 1> others;  // sorted points but the smallest
    ElementFace side;
    auto operator<=>(const Entry&) const = default;
  };
  const auto face_points = [&](Index e, int f) {
    std::array<Index, D> points;
    for (int i = 0; i < D; ++i) points[i] = mesh.element[e][face_node<D>(f, i)];
    std::sort(points.begin(), points.end());
    return points;
  };
  std::vector<std::size_t> start(mesh.point.size() + 1, 0);
  for (Index e = 0; e < mesh.elements(); ++e) {
    for (int f = 0; f <= D; ++f) ++start[face_points(e, f)[0] + 1];
  }
  for (std::size_t p = 0; p < mesh.point.size(); ++p) start[p + 1] += start[p];
  std::vector<Entry> entry(start.back());
  std::vector<std::size_t> next(start.begin(), start.end() - 1);
  for (Index e = 0; e < mesh.elements(); ++e) {
    for (int f = 0; f <= D; ++f) {
      const auto points = face_points(e, f);
      Entry& slot = entry[next[points[0]]++];
      std::copy(points.begin() + 1, points.end(), slot.others.begin());
      slot.side = {e, f};
    }
  }
  std::vector<ElementFace> sides;
  for (std::size_t p = 0; p < mesh.point.size(); ++p) {
    std::sort(entry.begin() + start[p], entry.begin() + start[p + 1]);
    for (std::size_t i = start[p]; i < start[p + 1];) {
      sides.clear();
      const auto& others = entry[i].others;
      for (; i < start[p + 1] && entry[i].others == others; ++i) sides.push_back(entry[i].side);
      visit(std::span<const ElementFace>(sides));
    }
  }
}

}  // namespace breccia
