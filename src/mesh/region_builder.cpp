#include "mesh/region_builder.hpp"

#include "base/simplex.hpp"
#include "mesh/face_table.hpp"

#include <algorithm>

namespace breccia {
namespace {

template <class T>
void sort_unique(std::vector<T>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

}  // namespace

template <int D>
void RegionBuilder<D>::add_element(const Mesh<D>& mesh, Index element) {
  region_.elements.push_back(element);
  for (Index p : mesh.element[element]) region_.points.push_back(p);
}

template <int D>
void RegionBuilder<D>::add_face(const Mesh<D>& mesh, const ElementFace& face) {
  region_.faces.push_back(face);
  for (int i = 0; i < D; ++i) {
    region_.points.push_back(mesh.element[face.element][face_node<D>(face.face, i)]);
  }
}

template <int D>
Region RegionBuilder<D>::finish(const std::string& name) {
  Region region = std::move(region_);
  region_ = {};
  region.name = name;
  sort_unique(region.elements);
  sort_unique(region.faces);
  sort_unique(region.points);
  return region;
}

template <int D>
std::vector<ElementFace> free_faces(const Mesh<D>& mesh) {
  std::vector<ElementFace> faces;
  for_each_face(mesh, [&](std::span<const ElementFace> sides) {
    if (sides.size() == 1) faces.push_back(sides[0]);
  });
  std::sort(faces.begin(), faces.end());
  return faces;
}

template <int D>
void add_body_regions(Mesh<D>& mesh) {
  std::vector<Region> region(mesh.body_names.size());
  std::vector<Index> last_body(mesh.point.size(), kNone);  // spares most repetitions of a point
  for (Index e = 0; e < mesh.elements(); ++e) {
    const Index b = mesh.body[e];
    region[b].elements.push_back(e);
    for (Index p : mesh.element[e]) {
      if (last_body[p] != b) region[b].points.push_back(p);
      last_body[p] = b;
    }
  }
  for (const ElementFace& face : free_faces(mesh)) {
    region[mesh.body[face.element]].faces.push_back(face);
  }
  for (std::size_t b = 0; b < region.size(); ++b) {
    region[b].name = mesh.body_names[b];
    sort_unique(region[b].points);
    mesh.regions.push_back(std::move(region[b]));
  }
}

template class RegionBuilder<2>;
template class RegionBuilder<3>;
template std::vector<ElementFace> free_faces<2>(const Mesh<2>&);
template std::vector<ElementFace> free_faces<3>(const Mesh<3>&);
template void add_body_regions<2>(Mesh<2>&);
template void add_body_regions<3>(Mesh<3>&);

}  // namespace breccia
