#include "mesh/mesh.hpp"

#include "mesh/refusal.hpp"

#include <algorithm>
#include <limits>
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

ElementFields fields_of(const ElementFields& fields, std::span<const Index> old) {
  ElementFields result;
  for (const auto& [name, field] : fields) {
    ElementField& out = result[name];
    out.components = field.components;
    const auto n = static_cast<std::size_t>(field.components);
    out.values.assign(old.size() * n, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t e = 0; e < old.size(); ++e) {
      if (old[e] == kNone) continue;
      std::copy_n(
          field.values.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(old[e]) * n),
          n, out.values.begin() + static_cast<std::ptrdiff_t>(e * n));
    }
  }
  return result;
}

namespace {

/// Fields of `more` behind those of the `count` elements that are there.
void append(ElementFields& fields, Index count, const ElementFields& more, Index added) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto& [name, field] : more) {
    const auto [place, fresh] = fields.try_emplace(name, ElementField{field.components, {}});
    ElementField& mine = place->second;
    if (mine.components != field.components) {
      refuse("field \"" + name + "\"",
             "it has " + std::to_string(mine.components) + " components in one mesh file and " +
                 std::to_string(field.components) + " in another",
             "rename one of the two");
    }
    if (fresh) mine.values.assign(static_cast<std::size_t>(count) * mine.components, nan);
    mine.values.insert(mine.values.end(), field.values.begin(), field.values.end());
  }
  for (auto& [name, field] : fields)
    field.values.resize(static_cast<std::size_t>(count + added) * field.components, nan);
}

}  // namespace

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
  append(mesh.fields, first_element, more.fields, more.elements());
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

template <int D>
double extent_of(const Mesh<D>& mesh) {
  if (mesh.whole_extent > 0) return mesh.whole_extent;
  double largest = 0;
  for (int d = 0; d < D; ++d) {
    double low = mesh.point.front()[d], high = low;
    for (const Point<D>& p : mesh.point) {
      low = std::min(low, p[d]);
      high = std::max(high, p[d]);
    }
    largest = std::max(largest, high - low);
  }
  return largest;
}

template double extent_of<2>(const Mesh<2>&);
template double extent_of<3>(const Mesh<3>&);
template const Region* find_region<2>(const Mesh<2>&, const std::string&);
template const Region* find_region<3>(const Mesh<3>&, const std::string&);
template Index find_body<2>(const Mesh<2>&, const std::string&);
template Index find_body<3>(const Mesh<3>&, const std::string&);
template void append<2>(Mesh<2>&, const Mesh<2>&);
template void append<3>(Mesh<3>&, const Mesh<3>&);

}  // namespace breccia
