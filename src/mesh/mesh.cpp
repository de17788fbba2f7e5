#include "mesh/mesh.hpp"

#include "mesh/refusal.hpp"

#include <algorithm>
#include <stdexcept>

namespace breccia {

template <int D>
const Region* find_region(const Mesh<D>& mesh, const std::string& name) {
  for (const Region& region : mesh.regions) {
    if (region.name == name) return &region;
  }
  return nullptr;
}

template <int D>
Index find_body(const Mesh<D>& mesh, const std::string& name) {
  const auto found = std::find(mesh.body_names.begin(), mesh.body_names.end(), name);
  if (found == mesh.body_names.end()) return kNone;
  return static_cast<Index>(found - mesh.body_names.begin());
}

template <int D>
void append(Mesh<D>& mesh, const Mesh<D>& more) {
  for (const std::string& name : more.body_names) {
    if (find_body(mesh, name) == kNone) continue;
    refuse("body \"" + name + "\"", "two bodies have this name",
           "give every body a name of its own");
  }
  for (const Region& region : more.regions) {
    if (!find_region(mesh, region.name)) continue;
    refuse("region \"" + region.name + "\"", "two regions have this name",
           "rename one of the bodies or physical groups");
  }
  const Index first_point = mesh.points();
  const Index first_element = mesh.elements();
  const auto first_body = static_cast<Index>(mesh.body_names.size());
  mesh.point.insert(mesh.point.end(), more.point.begin(), more.point.end());
  for (auto nodes : more.element) {
    for (Index& p : nodes) p += first_point;
    mesh.element.push_back(nodes);
  }
  for (Index b : more.body) mesh.body.push_back(b + first_body);
  for (const auto& [edge, middle] : more.curved) {
    mesh.curved[{edge[0] + first_point, edge[1] + first_point}] = middle;
  }
  if (!mesh.group_size.empty() || !more.group_size.empty()) {
    throw std::logic_error("append: meshes are joined before they are refined to composites");
  }
  mesh.body_names.insert(mesh.body_names.end(), more.body_names.begin(), more.body_names.end());
  for (Region region : more.regions) {
    for (Index& e : region.elements) e += first_element;
    for (ElementFace& f : region.faces) f.element += first_element;
    for (Index& p : region.points) p += first_point;
    mesh.regions.push_back(std::move(region));
  }
}

template const Region* find_region<2>(const Mesh<2>&, const std::string&);
template const Region* find_region<3>(const Mesh<3>&, const std::string&);
template Index find_body<2>(const Mesh<2>&, const std::string&);
template Index find_body<3>(const Mesh<3>&, const std::string&);
template void append<2>(Mesh<2>&, const Mesh<2>&);
template void append<3>(Mesh<3>&, const Mesh<3>&);

}  // namespace breccia
