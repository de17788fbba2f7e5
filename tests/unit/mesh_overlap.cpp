#include "mesh/overlap.hpp"
#include "unit/mesh_samples.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace breccia {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Two boxes of two bodies, the second with its lower corner at `at`.
template <int D>
Mesh<D> two_boxes(const Point<D>& at, Index cells = 4) {
  Grid<D> grid;
  grid.upper.fill(1);
  grid.cells.fill(cells);
  grid.pattern = D == 2 ? Pattern::cross : Pattern::kuhn;
  grid.body = "a";
  Mesh<D> mesh = structured_mesh(grid);
  grid.body = "b";
  grid.lower = at;
  for (int k = 0; k < D; ++k) grid.upper[k] = at[k] + 1;
  append(mesh, structured_mesh(grid));
  return mesh;
}

TEST(MeshOverlap, TouchingIsAllowed) {
  EXPECT_FALSE(find_overlap(two_boxes<2>({1, 0})));
  EXPECT_FALSE(find_overlap(two_boxes<2>({1, 0.3})));
  EXPECT_FALSE(find_overlap(two_boxes<2>({1, 1})));
  EXPECT_FALSE(find_overlap(two_boxes<3>({0, 0, 1})));
  EXPECT_FALSE(find_overlap(two_boxes<3>({0.37, 1, 0.11})));
}

TEST(MeshOverlap, ShallowOverlapHasItsDepth) {
  const auto plane = find_overlap(two_boxes<2>({0.98, 0}));
  ASSERT_TRUE(plane);
  EXPECT_NEAR(plane->depth, 0.02, 1e-12);
  EXPECT_NEAR(plane->place[0], 0.99, 1e-12);
  EXPECT_EQ(plane->body_a, "a");
  EXPECT_EQ(plane->body_b, "b");
  const auto space = find_overlap(two_boxes<3>({0, 0.99, 0}));
  ASSERT_TRUE(space);
  EXPECT_NEAR(space->depth, 0.01, 1e-12);
  EXPECT_NEAR(space->place[1], 0.995, 1e-12);
}

TEST(MeshOverlap, ToleranceIsAShareOfTheHeight) {
  const auto mesh = two_boxes<2>({1 - 1e-5, 0});  // least height of a cross cell of 1/4: 1/8
  EXPECT_FALSE(find_overlap(mesh));
  EXPECT_TRUE(find_overlap(mesh, 1e-6));
}

TEST(MeshOverlap, ContainmentIsFound) {
  Mesh<2> mesh = grid_mesh<2>(3, Pattern::cross);
  Mesh<2> grain = grid_mesh<2>(2, Pattern::cross);
  for (auto& x : grain.point) x = {0.4 + 0.01 * x[0], 0.4 + 0.01 * x[1]};
  grain.body_names = {"grain"};
  grain.regions.clear();
  append(mesh, grain);
  EXPECT_TRUE(find_overlap(mesh));
}

TEST(MeshOverlap, CrossingEdgesInSpaceAreSeparatedByTheirProduct) {
  // Two thin tetrahedra whose long edges cross at a right angle, a gap of 0.01 apart.
  Mesh<3> mesh = one_tetrahedron();
  mesh.point = {{-1, 0, 0}, {1, 0, 0}, {0, 0.1, -1}, {0, -0.1, -1}};
  if (signed_volume<3>(corners(mesh, 0)) < 0) std::swap(mesh.element[0][2], mesh.element[0][3]);
  Mesh<3> other = mesh;
  other.body_names = {"other"};
  for (double gap : {0.01, -0.01}) {
    for (std::size_t p = 0; p < 4; ++p) {
      const auto& x = mesh.point[p];
      other.point[p] = {x[1], x[0], gap - x[2]};
    }
    auto both = mesh;
    append(both, other);
    EXPECT_EQ(find_overlap(both).has_value(), gap < 0) << gap;
  }
}

TEST(MeshOverlap, BodiesOfOneSolidMayShareFaces) {
  auto mesh = grid_mesh<2>(4, Pattern::cross);
  for (Index e = 30; e < mesh.elements(); ++e) mesh.body[e] = 1;
  mesh.body_names.push_back("rest");
  EXPECT_FALSE(find_overlap(mesh));
}

TEST(MeshOverlap, VeryDifferentSizesAreSearched) {
  Mesh<2> mesh = grid_mesh<2>(1, Pattern::right);
  Mesh<2> fine = grid_mesh<2>(40, Pattern::right);
  for (auto& x : fine.point) x = {0.9 + 0.01 * x[0], 1 - 1e-4 + 0.01 * x[1]};
  fine.body_names = {"fine"};
  fine.regions.clear();
  append(mesh, fine);
  const auto found = find_overlap(mesh);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->depth, 1e-4, 1e-10);
}

TEST(MeshOverlap, RefusalNamesBodiesPlaceAndDepth) {
  const auto mesh = two_boxes<2>({0.98, 0});
  EXPECT_THAT(error_text([&] { refuse_overlap(mesh); }),
              AllOf(HasSubstr("bodies \"a\" and \"b\": they overlap at the start near (0.99, "),
                    HasSubstr("by 0.02 m"), HasSubstr("part_of")));
}

}  // namespace
}  // namespace breccia
