#include "mesh/whole_pieces.hpp"

#include "core/disjoint_sets.hpp"
#include "mesh/geometry.hpp"

#include <algorithm>
#include <cmath>

namespace breccia {

namespace {

/// Share of a piece's extent by which a node may stand out over the plane of a face: a dent so
/// shallow does not close.
constexpr double kDent = 0.05;

/// Least share of the cube around a piece that it fills: a rod three times as long as thick has a
/// tenth. Slimmer ones may curl.
constexpr double kCompact = 0.1;

/// Faces times nodes of a piece that are worth the test. The insides of larger ones are seldom near
/// their surfaces.
constexpr double kMostTests = 2e6;

template <int D>
struct Piece {
  std::vector<ElementFace> faces;
  std::vector<Index> nodes;
  double volume = 0;
};

template <int D>
bool is_convex(const Mesh<D>& mesh, const Piece<D>& piece) {
  Point<D> low = mesh.point[piece.nodes.front()], high = low;
  for (const Index n : piece.nodes)
    for (int d = 0; d < D; ++d) {
      low[d] = std::min(low[d], mesh.point[n][d]);
      high[d] = std::max(high[d], mesh.point[n][d]);
    }
  const Point<D> size = minus(high, low);
  const double extent = *std::max_element(size.begin(), size.end());
  if (piece.volume < kCompact * std::pow(extent, D)) return false;
  for (const ElementFace& f : piece.faces) {
    const Simplex<D> x = corners(mesh, f.element);
    const Point<D> normal = face_normal_area<D>(x, f.face);
    const double most = kDent * extent * length(normal);
    const Point<D>& origin = x[face_node<D>(f.face, 0)];
    for (const Index n : piece.nodes)
      if (dot(minus(mesh.point[n], origin), normal) > most) return false;
  }
  return true;
}

}  // namespace

template <int D>
std::vector<Index> whole_pieces(const Mesh<D>& mesh, const Topology<D>& topology,
                                const std::vector<std::uint8_t>& rigid) {
  const auto elements = static_cast<std::size_t>(mesh.elements());
  DisjointSets sets(elements);
  for (const SharedFace& f : topology.shared) sets.join(f.left, f.right);
  std::vector<Piece<D>> pieces(elements);
  std::vector<Index> root(elements);
  for (std::size_t e = 0; e < elements; ++e) {
    root[e] = sets.root(static_cast<Index>(e));
    Piece<D>& piece = pieces[static_cast<std::size_t>(root[e])];
    piece.nodes.insert(piece.nodes.end(), mesh.element[e].begin(), mesh.element[e].end());
    piece.volume += signed_volume<D>(corners(mesh, static_cast<Index>(e)));
  }
  for (const ElementFace& f : topology.free)
    pieces[static_cast<std::size_t>(root[static_cast<std::size_t>(f.element)])].faces.push_back(f);
  std::vector<std::uint8_t> apart(elements, 0);  // by the element that names the piece
  for (std::size_t e = 0; e < elements; ++e) {
    if (root[e] != static_cast<Index>(e)) continue;
    auto& nodes = pieces[e].nodes;
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    const double tests =
        static_cast<double>(nodes.size()) * static_cast<double>(pieces[e].faces.size());
    apart[e] = rigid[e] != 0 || (tests <= kMostTests && is_convex(mesh, pieces[e])) ? 1 : 0;
  }
  for (Index& r : root)
    if (apart[static_cast<std::size_t>(r)] == 0) r = kNone;
  return root;
}

template std::vector<Index> whole_pieces<2>(const Mesh<2>&, const Topology<2>&,
                                            const std::vector<std::uint8_t>&);
template std::vector<Index> whole_pieces<3>(const Mesh<3>&, const Topology<3>&,
                                            const std::vector<std::uint8_t>&);

}  // namespace breccia
