#include "mesh/whole_pieces.hpp"
#include "unit/mesh_samples.hpp"

#include <gmock/gmock.h>

namespace breccia {
namespace {

using testing::Each;

template <int D>
Mesh<D> box(const Point<D>& lower, const Point<D>& size, Index cells, const std::string& name) {
  Grid<D> grid;
  grid.lower = lower;
  for (int d = 0; d < D; ++d) grid.upper[d] = lower[d] + size[d];
  grid.cells.fill(cells);
  grid.pattern = D == 2 ? Pattern::cross : Pattern::kuhn;
  grid.body = name;
  return structured_mesh(grid);
}

template <int D>
std::vector<Index> pieces(const Mesh<D>& mesh, std::uint8_t rigid = 0) {
  return whole_pieces(mesh, build_topology(mesh),
                      std::vector<std::uint8_t>(mesh.element.size(), rigid));
}

/// Without the elements whose centroids lie beyond 0.5 in all directions: an L, or a cube with a
/// bite.
template <int D>
Mesh<D> bitten() {
  Point<D> low{}, size;
  size.fill(1);
  Mesh<D> mesh = box<D>(low, size, 4, "l"), left = mesh;
  left.element.clear();
  left.body.clear();
  for (Index e = 0; e < mesh.elements(); ++e) {
    const Point<D> c = centroid<D>(corners(mesh, e));
    bool gone = true;
    for (const double x : c) gone = gone && x > 0.5;
    if (gone) continue;
    left.element.push_back(mesh.element[static_cast<std::size_t>(e)]);
    left.body.push_back(0);
  }
  return left;
}

TEST(WholePieces, AreNamedByTheirFirstElement) {
  Mesh<2> mesh = box<2>({0, 0}, {1, 1}, 3, "a");
  const Index first = mesh.elements();
  append(mesh, box<2>({2, 0}, {1, 1}, 2, "b"));
  const auto piece = pieces(mesh);
  for (Index e = 0; e < mesh.elements(); ++e)
    EXPECT_EQ(piece[static_cast<std::size_t>(e)], e < first ? 0 : first);
}

TEST(WholePieces, AreConvex) {
  EXPECT_THAT(pieces(box<3>({0, 0, 0}, {1, 1, 1}, 3, "a")), Each(0));
  EXPECT_THAT(pieces(bitten<2>()), Each(kNone));
  EXPECT_THAT(pieces(bitten<3>()), Each(kNone));
}

TEST(WholePieces, AreCompact) {
  EXPECT_THAT(pieces(box<2>({0, 0}, {5, 1}, 3, "a")), Each(0));
  EXPECT_THAT(pieces(box<2>({0, 0}, {12, 1}, 3, "a")), Each(kNone));
  EXPECT_THAT(pieces(box<3>({0, 0, 0}, {5, 5, 0.4}, 3, "a")), Each(kNone));
}

TEST(WholePieces, MayHaveAnyShapeIfRigid) {
  EXPECT_THAT(pieces(bitten<2>(), 1), Each(0));
  EXPECT_THAT(pieces(box<2>({0, 0}, {12, 1}, 3, "a"), 1), Each(0));
}

}  // namespace
}  // namespace breccia
