#pragma once

#include "mesh/mesh.hpp"

#include <string>
#include <vector>

namespace breccia {

/// Collects the parts of one region; `finish` sorts them and removes repetitions.
template <int D>
class RegionBuilder {
 public:
  /// The element and its points.
  void add_element(const Mesh<D>& mesh, Index element);
  /// The face and its points.
  void add_face(const Mesh<D>& mesh, const ElementFace& face);
  void add_point(Index point) { region_.points.push_back(point); }

  bool empty() const { return region_.points.empty(); }
  Region finish(const std::string& name);

 private:
  Region region_;
};

/// Faces with one element, sorted. Works on meshes that `build_topology` would refuse.
template <int D>
std::vector<ElementFace> free_faces(const Mesh<D>& mesh);

/// Adds the region of each body: its elements, their points and its free faces.
template <int D>
void add_body_regions(Mesh<D>& mesh);

}  // namespace breccia
