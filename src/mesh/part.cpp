#include "mesh/part.hpp"

#include <algorithm>

namespace breccia {

namespace {

/// Number in the part of everything in the whole, none for what is outside.
std::vector<Index> places_of(const std::vector<Index>& chosen, std::size_t all) {
  std::vector<Index> place(all, kNone);
  for (std::size_t i = 0; i < chosen.size(); ++i)
    place[static_cast<std::size_t>(chosen[i])] = static_cast<Index>(i);
  return place;
}

template <int D>
class PartTaker {
 public:
  PartTaker(const Mesh<D>& mesh, const Topology<D>& topology, const std::vector<Index>& elements)
      : mesh_(mesh), topology_(topology), place_(places_of(elements, mesh.element.size())) {
    part_.element = elements;
  }

  MeshPart<D> take() {
    part_.mesh.partial = true;
    part_.mesh.whole_extent = extent_of(mesh_);
    part_.mesh.body_names = mesh_.body_names;
    part_.mesh.group_size = mesh_.group_size;
    part_.mesh.fields = fields_of(mesh_.fields, part_.element);
    part_.mesh.element.resize(part_.element.size());
    for (const Index e : part_.element) part_.mesh.body.push_back(mesh_.body[e]);
    part_.topology.family_start.push_back(0);
    for (Index n = 0; n < mesh_.points(); ++n) take_point(n);
    take_faces();
    for (const Region& region : mesh_.regions) part_.mesh.regions.push_back(taken(region));
    return std::move(part_);
  }

 private:
  void take_point(Index n) {
    std::vector<Index> corners;
    bool whole = true;
    for (Index k = topology_.family_start[n]; k < topology_.family_start[n + 1]; ++k) {
      const Index corner = topology_.family_corner[k], e = place_[corner / (D + 1)];
      whole = whole && e != kNone;
      if (e != kNone) corners.push_back(e * (D + 1) + corner % (D + 1));
    }
    first_.push_back(static_cast<Index>(part_.family.size()));
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (i == 0 || !whole) {
        if (i > 0) close_family();
        part_.family.push_back(n);
        part_.mesh.point.push_back(mesh_.point[n]);
      }
      part_.topology.family_corner.push_back(corners[i]);
      part_.mesh.element[corners[i] / (D + 1)][corners[i] % (D + 1)] = part_.mesh.points() - 1;
    }
    if (!corners.empty()) close_family();
  }

  void close_family() {
    part_.topology.family_start.push_back(static_cast<Index>(part_.topology.family_corner.size()));
  }

  void take_faces() {
    for (std::size_t f = 0; f < topology_.shared.size(); ++f) {
      SharedFace face = topology_.shared[f];
      face.left = place_[face.left];
      face.right = place_[face.right];
      if (face.left == kNone || face.right == kNone) continue;
      part_.topology.shared.push_back(face);
      part_.face.push_back(static_cast<Index>(f));
    }
    for (const ElementFace& face : topology_.free)
      if (place_[face.element] != kNone)
        part_.topology.free.push_back({place_[face.element], face.face});
  }

  Region taken(const Region& region) const {
    Region here;
    here.name = region.name;
    for (const Index e : region.elements)
      if (place_[e] != kNone) here.elements.push_back(place_[e]);
    for (const ElementFace& face : region.faces)
      if (place_[face.element] != kNone) here.faces.push_back({place_[face.element], face.face});
    for (const Index n : region.points)
      for (std::size_t f = first_[n]; f < part_.family.size() && part_.family[f] == n; ++f)
        here.points.push_back(static_cast<Index>(f));
    return here;
  }

  const Mesh<D>& mesh_;
  const Topology<D>& topology_;
  std::vector<Index> place_;  ///< of the whole mesh's elements
  std::vector<Index> first_;  ///< family of each point of the whole mesh that may be the first
  MeshPart<D> part_;
};

}  // namespace

template <int D>
MeshPart<D> take_part(const Mesh<D>& mesh, const Topology<D>& topology,
                      const std::vector<Index>& elements) {
  return PartTaker<D>(mesh, topology, elements).take();
}

template <int D>
std::vector<Index> with_neighbours(const Mesh<D>& mesh, const Topology<D>& topology,
                                   const std::vector<Index>& elements, int rings) {
  std::vector<std::uint8_t> chosen(mesh.element.size(), 0), reached(mesh.point.size(), 0);
  for (const Index e : elements) chosen[e] = 1;
  std::vector<Index> front = elements;
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<Index> next;
    for (const Index e : front)
      for (const Index n : mesh.element[e]) {
        if (reached[n]) continue;
        reached[n] = 1;
        for (Index k = topology.family_start[n]; k < topology.family_start[n + 1]; ++k) {
          const Index other = topology.family_corner[k] / (D + 1);
          if (!chosen[other]) next.push_back(other);
          chosen[other] = 1;
        }
      }
    front = std::move(next);
  }
  std::vector<Index> all;
  for (std::size_t e = 0; e < chosen.size(); ++e)
    if (chosen[e]) all.push_back(static_cast<Index>(e));
  return all;
}

template MeshPart<2> take_part(const Mesh<2>&, const Topology<2>&, const std::vector<Index>&);
template MeshPart<3> take_part(const Mesh<3>&, const Topology<3>&, const std::vector<Index>&);
template std::vector<Index> with_neighbours(const Mesh<2>&, const Topology<2>&,
                                            const std::vector<Index>&, int);
template std::vector<Index> with_neighbours(const Mesh<3>&, const Topology<3>&,
                                            const std::vector<Index>&, int);

}  // namespace breccia
