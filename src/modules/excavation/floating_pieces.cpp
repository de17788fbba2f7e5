#include "modules/excavation/floating_pieces.hpp"

#include "core/disjoint_sets.hpp"
#include "mesh/geometry.hpp"

namespace breccia {

namespace {

/// Per element: the smallest of the elements that it hangs together with through faces that `joins`
/// lets pass.
template <int D, class Joins>
std::vector<Index> roots(const Mesh<D>& mesh, const Topology<D>& topology, const Joins& joins) {
  DisjointSets sets(mesh.element.size());
  for (const SharedFace& face : topology.shared)
    if (joins(face.left, face.right)) sets.join(face.left, face.right);
  std::vector<Index> root(mesh.element.size());
  for (std::size_t e = 0; e < root.size(); ++e) root[e] = sets.root(static_cast<Index>(e));
  return root;
}

}  // namespace

template <int D>
std::vector<FloatingPiece> floating_pieces(const Mesh<D>& mesh, const Topology<D>& topology,
                                           const std::vector<Index>& mark,
                                           const std::vector<std::uint8_t>& held) {
  const auto stays = [&](Index e) { return mark[static_cast<std::size_t>(e)] == 0; };
  const auto before = roots(mesh, topology, [](Index, Index) { return true; });
  const auto after = roots(mesh, topology, [&](Index a, Index b) { return stays(a) && stays(b); });
  std::vector<std::uint8_t> was_held(before.size(), 0), is_held(after.size(), 0);
  for (std::size_t e = 0; e < before.size(); ++e)
    for (const Index n : mesh.element[e])
      if (held[static_cast<std::size_t>(n)])
        was_held[static_cast<std::size_t>(before[e])] =
            is_held[static_cast<std::size_t>(after[e])] = 1;

  std::vector<FloatingPiece> pieces;
  std::vector<Index> number(after.size(), kNone);
  for (std::size_t e = 0; e < after.size(); ++e) {
    const auto root = static_cast<std::size_t>(after[e]);
    if (!stays(static_cast<Index>(e)) || is_held[root]) continue;
    if (!was_held[static_cast<std::size_t>(before[e])]) continue;
    if (number[root] == kNone) {
      number[root] = static_cast<Index>(pieces.size());
      pieces.emplace_back();
    }
    FloatingPiece& piece = pieces[static_cast<std::size_t>(number[root])];
    const auto x = corners(mesh, static_cast<Index>(e));
    const double volume = signed_volume<D>(x);
    const Point<D> middle = centroid<D>(x);
    ++piece.elements;
    piece.volume += volume;
    for (std::size_t d = 0; d < D; ++d) piece.place[d] += volume * middle[d];
  }
  for (FloatingPiece& piece : pieces)
    for (double& x : piece.place) x /= piece.volume;
  return pieces;
}

template std::vector<FloatingPiece> floating_pieces(const Mesh<2>&, const Topology<2>&,
                                                    const std::vector<Index>&,
                                                    const std::vector<std::uint8_t>&);
template std::vector<FloatingPiece> floating_pieces(const Mesh<3>&, const Topology<3>&,
                                                    const std::vector<Index>&,
                                                    const std::vector<std::uint8_t>&);

}  // namespace breccia
