#include "scene/fragments.hpp"

#include "base/mat.hpp"
#include "core/disjoint_sets.hpp"

#include <algorithm>

namespace breccia {

namespace {

/// The smallest element of each connected piece, for every element.
template <int D>
std::vector<Index> roots(const Model<D>& model) {
  DisjointSets pieces(model.mesh.element.size());
  std::vector<std::uint8_t> broken(model.topology.shared.size(), 0);
  if (model.store.template has<FaceStatus>()) {
    const auto status =
        to_host(model.store.template get<FaceStatus>(), model.store.count(Entity::face));
    const auto ends = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{},
                                                          model.store.template get<FaceElements>());
    // Faces of the store may be fewer than those of the mesh: the others can never break.
    std::vector<std::pair<std::pair<Index, Index>, std::uint8_t>> released;
    for (std::size_t f = 0; f < status.size(); ++f)
      if (status[f] == face_status::released)
        released.push_back({{ends(f, 0), ends(f, 1)}, status[f]});
    std::sort(released.begin(), released.end());
    for (std::size_t f = 0; f < broken.size(); ++f) {
      const SharedFace& face = model.topology.shared[f];
      const auto key = std::make_pair(std::make_pair(face.left, face.right), std::uint8_t{0});
      const auto found = std::lower_bound(released.begin(), released.end(), key);
      broken[f] = found != released.end() && found->first == key.first;
    }
  }
  for (std::size_t f = 0; f < broken.size(); ++f)
    if (!broken[f]) pieces.join(model.topology.shared[f].left, model.topology.shared[f].right);
  std::vector<Index> root(model.mesh.element.size());
  for (std::size_t e = 0; e < root.size(); ++e) root[e] = pieces.root(static_cast<Index>(e));
  return root;
}

}  // namespace

template <int D>
Fragments find_fragments(const Model<D>& model) {
  const std::vector<Index> root = roots(model);
  const auto x = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{},
                                                     model.store.template get<NodePosition<D>>());
  const auto v = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{},
                                                     model.store.template get<NodeVelocity<D>>());
  const auto nodes = Kokkos::create_mirror_view_and_copy(
      Kokkos::HostSpace{}, model.store.template get<ElementNodes<D>>());
  const auto reference = Kokkos::create_mirror_view_and_copy(
      Kokkos::HostSpace{}, model.store.template get<ElementReference<D>>());

  std::vector<Fragments::Piece> pieces(root.size());
  for (Index e = 0; e < model.elements(); ++e) {
    Mat<D> inverse_edges;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) inverse_edges(i, j) = reference(e, i, j);
    const double volume = model.thickness / (determinant(inverse_edges) * (D == 2 ? 2 : 6));
    const double mass = volume * model.material_of_body(model.mesh.body[e]).density;
    Fragments::Piece& piece = pieces[root[e]];
    ++piece.elements;
    piece.mass += mass;
    piece.volume += volume;
    for (int a = 0; a <= D; ++a)
      for (int d = 0; d < D; ++d) {
        piece.place[d] += mass * x(nodes(e, a), d) / (D + 1);
        piece.velocity[d] += mass * v(nodes(e, a), d) / (D + 1);
      }
  }
  std::vector<Index> order;
  for (std::size_t r = 0; r < pieces.size(); ++r)
    if (pieces[r].elements > 0) order.push_back(static_cast<Index>(r));
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return pieces[a].mass > pieces[b].mass; });

  Fragments out;
  std::vector<Index> number(pieces.size(), kNone);
  for (const Index r : order) {
    number[r] = static_cast<Index>(out.pieces.size());
    Fragments::Piece piece = pieces[r];
    for (int d = 0; d < D; ++d) {
      piece.place[d] /= piece.mass;
      piece.velocity[d] /= piece.mass;
    }
    out.pieces.push_back(piece);
  }
  out.of_element.resize(root.size());
  for (std::size_t e = 0; e < root.size(); ++e) out.of_element[e] = number[root[e]];
  return out;
}

template Fragments find_fragments(const Model<2>&);
template Fragments find_fragments(const Model<3>&);

}  // namespace breccia
