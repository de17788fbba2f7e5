#include "mesh/topology.hpp"

#include "base/simplex.hpp"
#include "mesh/face_table.hpp"
#include "mesh/geometry.hpp"
#include "mesh/refusal.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace breccia {
namespace {

template <int D>
void build_families(const Mesh<D>& mesh, Topology<D>& topology) {
  topology.family_start.assign(mesh.points() + 1, 0);
  auto& start = topology.family_start;
  for (const auto& nodes : mesh.element) {
    for (Index p : nodes) ++start[p + 1];
  }
  for (Index p = 0; p < mesh.points(); ++p) start[p + 1] += start[p];
  topology.family_corner.resize(start.back());
  std::vector<Index> next(start.begin(), start.end() - 1);
  Index corner = 0;
  for (const auto& nodes : mesh.element) {
    for (Index p : nodes) topology.family_corner[next[p]++] = corner++;
  }
}

/// The rotation that maps the left face onto the right one, or -1 when both wind the same way.
template <int D>
int find_rotation(const Mesh<D>& mesh, const ElementFace& left, const ElementFace& right) {
  for (int rotation = D == 2 ? 1 : 0; rotation < D; ++rotation) {
    bool match = true;
    for (int i = 0; i < D; ++i) {
      const int j = opposite_face_node<D>(rotation, i);
      match = match && mesh.element[left.element][face_node<D>(left.face, i)] ==
                           mesh.element[right.element][face_node<D>(right.face, j)];
    }
    if (match) return rotation;
  }
  return -1;
}

template <int D>
void refuse_face(const Mesh<D>& mesh, std::span<const ElementFace> sides,
                 const std::string& trouble) {
  std::vector<Index> ids;
  for (const ElementFace& side : sides) ids.push_back(side.element);
  const auto place = centroid<D>(corners(mesh, ids.front()));
  refuse("mesh near " + place_text(place), "the " + name_ids("element", ids) + trouble,
         "remove the surplus elements; two elements at most may share a face, one on each side");
}

template <int D>
void add_face(const Mesh<D>& mesh, std::span<const ElementFace> sides, Topology<D>& topology) {
  if (sides.size() == 1) {
    topology.free.push_back(sides[0]);
    return;
  }
  if (sides.size() > 2) refuse_face(mesh, sides, " share one face");
  const int rotation = find_rotation(mesh, sides[0], sides[1]);
  if (rotation < 0) refuse_face(mesh, sides, " lie on the same side of their common face");
  topology.shared.push_back(
      {sides[0].element, sides[1].element, static_cast<std::int8_t>(sides[0].face),
       static_cast<std::int8_t>(sides[1].face), static_cast<std::int8_t>(rotation)});
}

}  // namespace

template <int D>
Topology<D> build_topology(const Mesh<D>& mesh) {
  Topology<D> topology;
  build_families(mesh, topology);
  topology.shared.reserve(mesh.element.size() * (D + 1) / 2);
  for_each_face(mesh, [&](std::span<const ElementFace> sides) { add_face(mesh, sides, topology); });
  std::sort(topology.free.begin(), topology.free.end());
  std::sort(topology.shared.begin(), topology.shared.end(),
            [](const SharedFace& a, const SharedFace& b) {
              return std::pair{a.left, a.left_face} < std::pair{b.left, b.left_face};
            });
  return topology;
}

template <int D>
std::vector<Index> face_numbers(const Topology<D>& topology) {
  std::vector<Index> number(topology.free.size() + 2 * topology.shared.size());
  for (std::size_t n = 0; n < topology.free.size(); ++n) {
    const ElementFace& side = topology.free[n];
    number[side.element * (D + 1) + side.face] = -1 - static_cast<Index>(n);
  }
  for (std::size_t n = 0; n < topology.shared.size(); ++n) {
    const SharedFace& face = topology.shared[n];
    number[face.left * (D + 1) + face.left_face] = static_cast<Index>(n);
    number[face.right * (D + 1) + face.right_face] = static_cast<Index>(n);
  }
  return number;
}

template std::vector<Index> face_numbers<2>(const Topology<2>&);
template std::vector<Index> face_numbers<3>(const Topology<3>&);
template Topology<2> build_topology<2>(const Mesh<2>&);
template Topology<3> build_topology<3>(const Mesh<3>&);

}  // namespace breccia
