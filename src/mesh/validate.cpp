#include "mesh/validate.hpp"

#include "mesh/coincident.hpp"
#include "mesh/face_table.hpp"
#include "mesh/geometry.hpp"
#include "mesh/refusal.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace breccia {
namespace {

/// Volume below which an element counts as flat, in cubes (squares) of its longest edge. A sliver
/// of aspect 1e4 has 1e-4 to 1e-9 and is allowed (it costs time step); round-off of the determinant
/// is near 1e-16.
constexpr double kFlat = 1e-12;

template <int D>
void refuse_elements(const Mesh<D>& mesh, const std::string& source, const std::vector<Index>& ids,
                     const std::string& trouble, const std::string& remedy) {
  if (ids.empty()) return;
  std::string where;
  const auto x = centroid<D>(corners(mesh, ids.front()));
  if (std::isfinite(dot(x, x))) where = " (the first near " + place_text(x) + ")";
  refuse(source, name_ids("element", ids) + where + " " + trouble, remedy);
}

template <int D>
void check_arrays(const Mesh<D>& mesh, const std::string& source) {
  if (mesh.element.empty()) {
    refuse(source, "the mesh has no elements",
           "give a mesh with " + std::string(D == 2 ? "triangles" : "tetrahedra"));
  }
  if (mesh.body.size() != mesh.element.size()) {
    refuse(source,
           "it names the body of " + std::to_string(mesh.body.size()) + " elements but has " +
               std::to_string(mesh.element.size()),
           "write the mesh anew; the file is damaged");
  }
  std::vector<Index> points, bad_point, bad_body;
  for (Index p = 0; p < mesh.points(); ++p) {
    for (double c : mesh.point[p]) {
      if (!std::isfinite(c)) points.push_back(p);
    }
  }
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (!points.empty()) {
    refuse(source, name_ids("point", points) + " without finite coordinates",
           "write the mesh anew; its coordinates are damaged");
  }
  const auto bodies = static_cast<Index>(mesh.body_names.size());
  for (Index e = 0; e < mesh.elements(); ++e) {
    const auto& nodes = mesh.element[e];
    if (std::any_of(nodes.begin(), nodes.end(),
                    [&](Index p) { return p < 0 || p >= mesh.points(); })) {
      bad_point.push_back(e);
    }
    if (mesh.body[e] < 0 || mesh.body[e] >= bodies) bad_body.push_back(e);
  }
  if (!bad_point.empty()) {
    refuse(source,
           name_ids("element", bad_point) + " with point numbers outside 0 to " +
               std::to_string(mesh.points() - 1),
           "write the mesh anew; its elements are damaged");
  }
  if (!bad_body.empty()) {
    refuse(source, name_ids("element", bad_body) + " of a body that the mesh does not list",
           "write the mesh anew; its bodies are damaged");
  }
}

/// The elements with their points sorted, sorted: equal neighbours are duplicates.
template <int D>
std::vector<Index> duplicate_elements(const Mesh<D>& mesh) {
  std::vector<std::pair<std::array<Index, D + 1>, Index>> sorted(mesh.element.size());
  for (Index e = 0; e < mesh.elements(); ++e) {
    sorted[e] = {mesh.element[e], e};
    std::sort(sorted[e].first.begin(), sorted[e].first.end());
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<Index> ids;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i].first != sorted[i - 1].first) continue;
    if (ids.empty() || ids.back() != sorted[i - 1].second) ids.push_back(sorted[i - 1].second);
    ids.push_back(sorted[i].second);
  }
  return ids;
}

template <int D>
void check_elements(const Mesh<D>& mesh, const std::string& source) {
  std::vector<Index> repeated, flat, inverted;
  for (Index e = 0; e < mesh.elements(); ++e) {
    auto nodes = mesh.element[e];
    std::sort(nodes.begin(), nodes.end());
    if (std::adjacent_find(nodes.begin(), nodes.end()) != nodes.end()) {
      repeated.push_back(e);
      continue;
    }
    const auto x = corners(mesh, e);
    double longest = 0;
    for (int a = 0; a <= D; ++a) {
      for (int b = 0; b < a; ++b) longest = std::max(longest, length(minus(x[a], x[b])));
    }
    const double volume = signed_volume<D>(x);
    if (!(std::abs(volume) > kFlat * std::pow(longest, D))) {
      flat.push_back(e);
    } else if (volume < 0) {
      inverted.push_back(e);
    }
  }
  refuse_elements(mesh, source, repeated, "use a point twice", "remove these elements");
  refuse_elements(mesh, source, duplicate_elements(mesh), "have the same points",
                  "keep one of each; the mesh lists them twice");
  refuse_elements(mesh, source, flat, D == 2 ? "with zero area" : "with zero volume",
                  "remove these elements or move their points apart");
  refuse_elements(mesh, source, inverted, "inverted (negative volume)",
                  "swap two points of each of these elements; the others are oriented positively");
}

template <int D>
void check_faces(const Mesh<D>& mesh, const std::string& source) {
  std::vector<Index> crowded, folded;
  for_each_face(mesh, [&](std::span<const ElementFace> sides) {
    if (sides.size() > 2 && crowded.empty()) {
      for (const ElementFace& side : sides) crowded.push_back(side.element);
    }
    if (sides.size() != 2) return;
    const auto n = face_normal_area<D>(corners(mesh, sides[0].element), sides[0].face);
    const auto m = face_normal_area<D>(corners(mesh, sides[1].element), sides[1].face);
    if (dot(n, m) > 0 && folded.empty()) folded = {sides[0].element, sides[1].element};
  });
  refuse_elements(mesh, source, crowded, "share one face",
                  "remove the surplus elements; at most two may share a face");
  refuse_elements(mesh, source, folded, "lie on the same side of their common face",
                  "remove one of the two; they overlap");
}

template <int D>
void check_points(const Mesh<D>& mesh, const std::string& source) {
  std::vector<char> used(mesh.point.size(), 0);
  for (const auto& nodes : mesh.element) {
    for (Index p : nodes) used[p] = 1;
  }
  std::vector<Index> orphans;
  for (Index p = 0; p < mesh.points(); ++p) {
    if (!used[p]) orphans.push_back(p);
  }
  if (!orphans.empty()) {
    refuse(source,
           name_ids("point", orphans) + " (the first at " +
               place_text(mesh.point[orphans.front()]) + ") used by no element",
           "remove unused points from the mesh");
  }
  const auto pairs = coincident_points(mesh);
  if (pairs.empty()) return;
  refuse(source,
         "points " + list_ids(pairs) + " coincide within one body (the first at " +
             place_text(mesh.point[pairs.front()]) + ")",
         "merge them (in Gmsh: Coherence Mesh), or give the two sides different body names");
}

template <int D>
void check_names(const Mesh<D>& mesh, const std::string& source) {
  std::vector<char> filled(mesh.body_names.size(), 0);
  for (Index b : mesh.body) filled[b] = 1;
  for (std::size_t b = 0; b < filled.size(); ++b) {
    if (filled[b]) continue;
    refuse(source, "body \"" + mesh.body_names[b] + "\" has no elements",
           "remove the body or mesh it");
  }
  const auto inside = [](Index n, Index end) { return n >= 0 && n < end; };
  for (const Region& region : mesh.regions) {
    bool good = true;
    for (Index e : region.elements) good = good && inside(e, mesh.elements());
    for (Index p : region.points) good = good && inside(p, mesh.points());
    for (const ElementFace& side : region.faces) {
      good = good && inside(side.element, mesh.elements()) && side.face >= 0 && side.face <= D;
    }
    if (good) continue;
    refuse(source, "region \"" + region.name + "\" names entities that the mesh does not have",
           "write the mesh anew; its regions are damaged");
  }
}

}  // namespace

template <int D>
void validate(const Mesh<D>& mesh, const std::string& source) {
  check_arrays(mesh, source);
  check_elements(mesh, source);
  check_faces(mesh, source);
  check_points(mesh, source);
  check_names(mesh, source);
}

template <int D>
bool orient_if_all_mirrored(Mesh<D>& mesh) {
  if (mesh.element.empty()) return false;
  for (Index e = 0; e < mesh.elements(); ++e) {
    if (!(signed_volume<D>(corners(mesh, e)) < 0)) return false;
  }
  // Swapping the last two local nodes swaps the faces opposite them, which regions name.
  for (auto& nodes : mesh.element) std::swap(nodes[D - 1], nodes[D]);
  for (Region& region : mesh.regions) {
    for (ElementFace& side : region.faces) {
      if (side.face >= D - 1) side.face = 2 * D - 1 - side.face;
    }
    std::sort(region.faces.begin(), region.faces.end());
  }
  return true;
}

template void validate<2>(const Mesh<2>&, const std::string&);
template void validate<3>(const Mesh<3>&, const std::string&);
template bool orient_if_all_mirrored<2>(Mesh<2>&);
template bool orient_if_all_mirrored<3>(Mesh<3>&);

}  // namespace breccia
