#include "mesh/raw_mesh.hpp"

#include "mesh/face_table.hpp"
#include "mesh/geometry.hpp"
#include "mesh/refusal.hpp"
#include "mesh/region_builder.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace breccia {
namespace {

/// New numbers of what is kept; kNone for the rest.
struct Kept {
  std::vector<Index> point;
  std::vector<Index> element;
};

/// Whether the element occurs again in a group that does not list it: the second copy only carries
/// the second group. A copy inside the same group is a defect that `validate` reports.
std::vector<Index> first_copies(const RawMesh& raw, int dimension) {
  std::vector<std::vector<Index>> groups_of(raw.element.size());
  for (std::size_t g = 0; g < raw.groups.size(); ++g) {
    for (Index e : raw.groups[g].elements) groups_of[e].push_back(static_cast<Index>(g));
  }
  std::vector<Index> first(raw.element.size());
  std::map<std::array<Index, 4>, Index> seen;
  for (Index e = 0; e < static_cast<Index>(raw.element.size()); ++e) {
    first[e] = e;
    if (raw.element[e].dimension != dimension || groups_of[e].empty()) continue;
    const auto [place, fresh] = seen.emplace(raw.element[e].point, e);
    if (!fresh && groups_of[place->second] != groups_of[e]) first[e] = place->second;
  }
  return first;
}

template <int D>
void keep_points(const RawMesh& raw, const std::string& source, Kept& kept, Mesh<D>& mesh) {
  std::vector<char> used(raw.point.size(), 0);  // 1: by lower elements only, 2: by dimension D
  for (const RawElement& element : raw.element) {
    for (int a = 0; a <= element.dimension; ++a) {
      char& u = used[element.point[a]];
      u = std::max<char>(u, element.dimension == D ? 2 : 1);
    }
  }
  for (const auto& [edge, middle] : raw.middle) used[middle] = std::max<char>(used[middle], 1);
  std::vector<Index> orphans;
  kept.point.assign(raw.point.size(), kNone);
  for (std::size_t p = 0; p < raw.point.size(); ++p) {
    if (used[p] == 0) orphans.push_back(static_cast<Index>(p));
    if (used[p] < 2) continue;
    kept.point[p] = mesh.points();
    Point<D> x;
    std::copy_n(raw.point[p].begin(), D, x.begin());
    mesh.point.push_back(x);
  }
  if (!orphans.empty()) {
    refuse(source,
           name_ids("point", orphans) + " (counted from 0, the first at " +
               place_text(raw.point[orphans.front()]) + ") used by no element",
           "remove unused points from the mesh");
  }
}

template <int D>
void check_plane(const RawMesh& raw, const std::string& source) {
  if constexpr (D == 2) {
    double extent = 0;
    for (const auto& x : raw.point) extent = std::max({extent, std::abs(x[0]), std::abs(x[1])});
    for (const auto& x : raw.point) {
      if (std::abs(x[2]) <= 1e-9 * extent || !std::isfinite(x[2])) continue;
      refuse(source, "the point at " + place_text(x) + " is off the plane z = 0",
             "give a plane mesh in x and y, or a scene of dimension 3");
    }
  }
}

/// Mid-edge nodes nearer to the middle than this share of the edge are there but for rounding.
constexpr double kStraight = 1e-9;

template <int D>
void keep_middles(const RawMesh& raw, const std::string& source, const Kept& kept, Mesh<D>& mesh) {
  for (const auto& [edge, middle] : raw.middle) {
    const Index a = kept.point[edge[0]], b = kept.point[edge[1]];
    if (a == kNone || b == kNone) continue;
    if (kept.point[middle] != kNone) {
      refuse(source,
             "the mid-edge node at " + place_text(raw.point[middle]) +
                 " is a corner of another element",
             "give a mesh whose elements meet edge to edge");
    }
    Point<D> x;
    std::copy_n(raw.point[middle].begin(), D, x.begin());
    if (!std::isfinite(dot(x, x))) {
      refuse(source, name_ids("point", std::vector<Index>{middle}) + " without finite coordinates",
             "write the mesh anew; its coordinates are damaged");
    }
    const auto along_edge = minus(mesh.point[b], mesh.point[a]);
    const auto off = minus(x, along(mesh.point[a], 0.5, along_edge));
    if (length(off) > kStraight * length(along_edge)) mesh.curved[edge_of(a, b)] = x;
  }
}

/// Sorted points of each face a group of dimension D - 1 names -> the groups.
template <int D>
using FaceGroups = std::map<std::array<Index, D>, std::vector<std::size_t>>;

template <int D>
FaceGroups<D> face_groups(const RawMesh& raw, const Kept& kept) {
  FaceGroups<D> groups;
  for (std::size_t g = 0; g < raw.groups.size(); ++g) {
    if (raw.groups[g].dimension != D - 1) continue;
    for (Index e : raw.groups[g].elements) {
      std::array<Index, D> points;
      for (int i = 0; i < D; ++i) points[i] = kept.point[raw.element[e].point[i]];
      std::sort(points.begin(), points.end());
      if (points[0] != kNone) groups[points].push_back(g);
    }
  }
  return groups;
}

template <int D>
void add_face_groups(const RawMesh& raw, const Kept& kept, const Mesh<D>& mesh,
                     std::vector<RegionBuilder<D>>& builder) {
  const auto groups = face_groups<D>(raw, kept);
  if (groups.empty()) return;
  for_each_face(mesh, [&](std::span<const ElementFace> sides) {
    std::array<Index, D> points;
    for (int i = 0; i < D; ++i) {
      points[i] = mesh.element[sides[0].element][face_node<D>(sides[0].face, i)];
    }
    std::sort(points.begin(), points.end());
    const auto found = groups.find(points);
    if (found == groups.end()) return;
    for (std::size_t g : found->second) builder[g].add_face(mesh, sides[0]);
  });
}

template <int D>
void add_groups(const RawMesh& raw, const Kept& kept, const std::string& source, Mesh<D>& mesh) {
  std::vector<RegionBuilder<D>> builder(raw.groups.size());
  add_face_groups(raw, kept, mesh, builder);
  std::set<std::string> names;
  for (std::size_t g = 0; g < raw.groups.size(); ++g) {
    const RawGroup& group = raw.groups[g];
    for (Index e : group.elements) {
      if (group.dimension == D) builder[g].add_element(mesh, kept.element[e]);
      if (group.dimension >= D - 1) continue;
      for (int a = 0; a <= group.dimension; ++a) {
        const Index p = kept.point[raw.element[e].point[a]];
        if (p != kNone) builder[g].add_point(p);
      }
    }
    if (builder[g].empty()) continue;
    if (!names.insert(group.name).second) {
      refuse(source, "two physical groups are named \"" + group.name + "\"", "rename one of them");
    }
    mesh.regions.push_back(builder[g].finish(group.name));
  }
}

}  // namespace

void add_middle(RawMesh& raw, Index a, Index b, Index middle, const std::string& source) {
  const auto [place, fresh] = raw.middle.emplace(edge_of(a, b), middle);
  if (fresh || place->second == middle) return;
  refuse(source,
         "the edge from " + place_text(raw.point[a]) + " to " + place_text(raw.point[b]) +
             " has two mid-edge nodes",
         "give a mesh whose elements share the nodes of their common edges");
}

GmshType gmsh_type(long long type) {
  switch (type) {
    case 15:
      return {0, 0, {}};
    case 1:
      return {1, 0, {}};
    case 2:
      return {2, 0, {}};
    case 4:
      return {3, 0, {}};
    case 8:
      return {1, 1, {{{0, 1}}}};
    case 9:
      return {2, 3, {{{0, 1}, {1, 2}, {2, 0}}}};
    case 11:
      return {3, 6, {{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {2, 3}, {1, 3}}}};
    default:
      return {};
  }
}

template <int D>
Mesh<D> to_mesh(const RawMesh& raw, const std::string& source) {
  check_plane<D>(raw, source);
  Mesh<D> mesh;
  Kept kept;
  keep_points(raw, source, kept, mesh);
  const auto first = first_copies(raw, D);
  std::vector<Index> from;
  kept.element.assign(raw.element.size(), kNone);
  for (std::size_t e = 0; e < raw.element.size(); ++e) {
    if (raw.element[e].dimension != D) continue;
    kept.element[e] = mesh.elements();
    if (first[e] != static_cast<Index>(e)) {
      kept.element[e] = kept.element[first[e]];
      continue;
    }
    std::array<Index, D + 1> nodes;
    for (int a = 0; a <= D; ++a) nodes[a] = kept.point[raw.element[e].point[a]];
    mesh.element.push_back(nodes);
    from.push_back(static_cast<Index>(e));
  }
  mesh.fields = fields_of(raw.fields, from);
  if (mesh.element.empty()) {
    refuse(source, D == 2 ? "it has no triangles" : "it has no tetrahedra",
           "mesh the geometry with simplices of dimension " + std::to_string(D));
  }
  keep_middles(raw, source, kept, mesh);
  mesh.body.assign(mesh.element.size(), 0);
  mesh.body_names = {"file"};
  add_groups(raw, kept, source, mesh);
  return mesh;
}

template Mesh<2> to_mesh<2>(const RawMesh&, const std::string&);
template Mesh<3> to_mesh<3>(const RawMesh&, const std::string&);

}  // namespace breccia
