// Pressures that come from a source, and that follow cracks (ALGORITHMS ).
#include "modules/boundary/boundary.hpp"
#include "step/selection.hpp"

#include <algorithm>
#include <cmath>

namespace breccia {

namespace {

/// Linear between the rows [distance, share], constant beyond its ends.
double share_at(const Points& table, double distance) {
  if (distance <= table.front()[0]) return table.front()[1];
  for (std::size_t i = 1; i < table.size(); ++i) {
    if (distance >= table[i][0]) continue;
    const double s = (distance - table[i - 1][0]) / (table[i][0] - table[i - 1][0]);
    return table[i - 1][1] + s * (table[i][1] - table[i - 1][1]);
  }
  return table.back()[1];
}

template <int D>
Index point_of(const Model<D>& model, const ElementFace& face, int j) {
  return model.mesh.element[face.element][face_node<D>(face.face, j)];
}

}  // namespace

template <int D>
typename Boundary<D>::FaceLoad Boundary<D>::pressure_on(const Model<D>& model, Index law,
                                                        const ElementFace& face) const {
  FaceLoad load{law, Vec<D>::zero(), 1, 0};
  const Settings& section = model.scene->list("boundary")[static_cast<std::size_t>(law)];
  if (!section.has("source")) return load;
  const Settings& source = section.at("source");
  Vec<D> way = Vec<D>::zero();
  for (int d = 0; d < D; ++d) {
    for (int j = 0; j < D; ++j) way[d] += model.mesh.point[point_of(model, face, j)][d] / D;
    way[d] -= source.vector("point")[static_cast<std::size_t>(d)];
  }
  const double distance = norm(way);
  if (source.has("decay")) load.share = share_at(source.points("decay"), distance);
  if (source.has("speed")) load.delay = distance / source.number("speed");
  return load;
}

template <int D>
void Boundary<D>::start_spreading(const Model<D>& model, Index law, const Region& region,
                                  const Settings& section) {
  if (!model.scene->has("fracture") && model.scene->list("interface").empty())
    throw section.error("on_new_faces", "nothing can break in this scene",
                        "leave it out, or add [fracture.NAME]");
  Spreading spreading{law, std::vector<char>(model.mesh.point.size(), 0)};
  for (const ElementFace& face : region.faces)
    if (std::binary_search(model.topology.free.begin(), model.topology.free.end(), face))
      for (int j = 0; j < D; ++j) spreading.wet[point_of(model, face, j)] = 1;
  spreading_.push_back(std::move(spreading));
}

template <int D>
bool Boundary<D>::spread(const Model<D>& model) {
  if (spreading_.empty() || model.releases == releases_seen_) return false;
  releases_seen_ = model.releases;
  bool any = false;
  for (Spreading& spreading : spreading_) any = spread(model, spreading) || any;
  return any;
}

template <int D>
bool Boundary<D>::spread(const Model<D>& model, Spreading& spreading) {
  const auto status = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{},
                                                          model.store.template get<FaceStatus>());
  const auto taken = [&](const ElementFace& face) {
    const auto found = face_loads_.find(face);
    return found != face_loads_.end() &&
           std::any_of(found->second.begin(), found->second.end(),
                       [&](const FaceLoad& load) { return load.law == spreading.law; });
  };
  bool any = false, more = true;
  while (more) {
    more = false;
    for (std::size_t f = 0; f < model.topology.shared.size(); ++f) {
      if (status(f) != face_status::released) continue;
      const SharedFace& shared = model.topology.shared[f];
      const ElementFace left{shared.left, shared.left_face}, right{shared.right, shared.right_face};
      bool touches = false;
      for (int j = 0; j < D; ++j) touches = touches || spreading.wet[point_of(model, left, j)] != 0;
      if (!touches || taken(left)) continue;
      for (const ElementFace& face : {left, right})
        face_loads_[face].push_back(pressure_on(model, spreading.law, face));
      for (int j = 0; j < D; ++j) spreading.wet[point_of(model, left, j)] = 1;
      any = more = true;
    }
  }
  return any;
}

template <int D>
void Boundary<D>::mark_loaded(Model<D>& model) const {
  const auto nodes = Kokkos::create_mirror_view_and_copy(
      Kokkos::HostSpace{}, model.store.template get<ElementNodes<D>>());
  const auto flags = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{},
                                                         model.store.template get<NodeFlags>());
  for (const auto& [face, loads] : face_loads_)
    for (int j = 0; j < D; ++j)
      flags(nodes(face.element, face_node<D>(face.face, j))) |= node_flag::load;
  Kokkos::deep_copy(model.store.template get<NodeFlags>(), flags);
}

template class Boundary<2>;
template class Boundary<3>;

}  // namespace breccia
