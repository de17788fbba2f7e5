#include "mesh/geometry.hpp"
#include "mesh/structured.hpp"
#include "mesh/topology.hpp"
#include "mesh/validate.hpp"
#include "unit/mesh_samples.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace breccia {
namespace {

using testing::HasSubstr;

// Volumes are sums of 100 to 10000 rounded terms, so exact to about 1e-14.
constexpr double kSum = 1e-13;

TEST(MeshStructured, PlanePatternsHaveTheirCountsAndFillTheRectangle) {
  Grid<2> grid{{1, 2}, {3, 5}, {4, 6}, Pattern::right, 0, 1, "plate"};
  const auto right = structured_mesh(grid);
  EXPECT_EQ(right.elements(), 2 * 4 * 6);
  EXPECT_EQ(right.points(), 5 * 7);
  grid.pattern = Pattern::cross;
  const auto cross = structured_mesh(grid);
  EXPECT_EQ(cross.elements(), 4 * 4 * 6);
  EXPECT_EQ(cross.points(), 5 * 7 + 4 * 6);
  grid.pattern = Pattern::union_jack;
  const auto jack = structured_mesh(grid);
  EXPECT_EQ(jack.elements(), 2 * 4 * 6);
  for (const auto& mesh : {right, cross, jack}) {
    EXPECT_NEAR(total_volume(mesh), 6.0, kSum);
    EXPECT_NO_THROW(validate(mesh, "grid"));
  }
}

TEST(MeshStructured, UnionJackDiagonalsMeetInFoursAndEights) {
  const auto mesh = grid_mesh<2>(4, Pattern::union_jack);
  const auto topology = build_topology(mesh);
  for (Index p = 0; p < mesh.points(); ++p) {
    const auto& x = mesh.point[p];
    if (x[0] == 0 || x[0] == 1 || x[1] == 0 || x[1] == 1) continue;
    const Index corners = topology.family_start[p + 1] - topology.family_start[p];
    EXPECT_TRUE(corners == 4 || corners == 8) << corners;
  }
}

TEST(MeshStructured, SpacePatternsHaveTheirCountsAndFillTheBox) {
  Grid<3> grid{{0, 0, 0}, {2, 1, 3}, {4, 3, 5}, Pattern::kuhn, 0, 1, "block"};
  const auto kuhn = structured_mesh(grid);
  EXPECT_EQ(kuhn.elements(), 6 * 60);
  EXPECT_EQ(kuhn.points(), 5 * 4 * 6);
  grid.pattern = Pattern::five;
  const auto five = structured_mesh(grid);
  EXPECT_EQ(five.elements(), 5 * 60);
  for (const auto& mesh : {kuhn, five}) {
    EXPECT_NEAR(total_volume(mesh), 6.0, kSum);
    EXPECT_NO_THROW(validate(mesh, "grid"));  // positive, face to face
    const auto topology = build_topology(mesh);
    EXPECT_EQ(topology.free.size(), 2U * 2 * (4 * 3 + 3 * 5 + 4 * 5));
  }
}

TEST(MeshStructured, SidesHaveTheirAreasAndPlanes) {
  const Grid<3> grid{{0, 0, 0}, {2, 1, 3}, {4, 3, 5}, Pattern::kuhn, 0.2, 7, "block"};
  const auto mesh = structured_mesh(grid);
  const std::array<const char*, 6> names = {"left", "right", "bottom", "top", "front", "back"};
  const std::array<double, 3> area = {3, 6, 2};
  for (int s = 0; s < 6; ++s) {
    const Region* side = find_region(mesh, "block." + std::string(names[s]));
    ASSERT_TRUE(side);
    Point<3> sum{};
    for (const ElementFace& f : side->faces) {
      sum = along(sum, 1, face_normal_area<3>(corners(mesh, f.element), f.face));
    }
    for (int k = 0; k < 3; ++k) {
      const double expected = k == s / 2 ? (s % 2 == 0 ? -1 : 1) * area[k] : 0;
      EXPECT_NEAR(sum[k], expected, kSum) << names[s];
    }
    for (Index p : side->points) {
      EXPECT_EQ(mesh.point[p][s / 2], s % 2 == 0 ? grid.lower[s / 2] : grid.upper[s / 2]);
    }
  }
}

TEST(MeshStructured, BodyRegionHoldsEverything) {
  const auto mesh = grid_mesh<2>(3, Pattern::right);
  const Region* body = find_region(mesh, "body");
  ASSERT_TRUE(body);
  EXPECT_EQ(static_cast<Index>(body->elements.size()), mesh.elements());
  EXPECT_EQ(static_cast<Index>(body->points.size()), mesh.points());
  EXPECT_EQ(body->faces, build_topology(mesh).free);
}

TEST(MeshStructured, JitterMovesInnerPointsOnlyAndIsRepeatable) {
  const auto straight = grid_mesh<2>(8, Pattern::right);
  const auto mesh = grid_mesh<2>(8, Pattern::right, 0.3);
  EXPECT_NO_THROW(validate(mesh, "jittered grid"));
  EXPECT_EQ(mesh.point, (grid_mesh<2>(8, Pattern::right, 0.3).point));
  int moved = 0;
  for (Index p = 0; p < mesh.points(); ++p) {
    const auto shift = minus(mesh.point[p], straight.point[p]);
    const auto& x = straight.point[p];
    const bool outer = x[0] == 0 || x[0] == 1 || x[1] == 0 || x[1] == 1;
    EXPECT_TRUE(!outer || length(shift) == 0);
    EXPECT_LE(std::abs(shift[0]), 0.3 / 8 + 1e-15);
    moved += length(shift) > 0 ? 1 : 0;
  }
  EXPECT_EQ(moved, 7 * 7);
}

TEST(MeshStructured, CellsOfSizeRoundsAndKeepsOne) {
  EXPECT_EQ((cells_of_size<2>({0, 0}, {1, 0.24}, 0.1)), (std::array<Index, 2>{10, 2}));
  EXPECT_EQ((cells_of_size<2>({0, 0}, {1, 0.01}, 0.1)), (std::array<Index, 2>{10, 1}));
}

TEST(MeshStructured, RefusesWhatCannotBeAGrid) {
  Grid<2> grid{{0, 0}, {1, 1}, {2, 2}, Pattern::right, 0, 1, "plate"};
  const auto text = [&] { return error_text([&] { structured_mesh(grid); }); };
  grid.jitter = 0.5;
  EXPECT_THAT(text(), HasSubstr("jitter is 0.5"));
  grid.jitter = 0;
  grid.cells = {2, 0};
  EXPECT_THAT(text(), HasSubstr("0 cells along an axis"));
  grid.cells = {2, 2};
  grid.pattern = Pattern::kuhn;
  EXPECT_THAT(text(), HasSubstr("not one of a 2D mesh"));
  grid.pattern = Pattern::right;
  grid.upper = {1, 0};
  EXPECT_THAT(text(), HasSubstr("body \"plate\": its extent along y is not positive"));
  grid.upper = {1, 1};
  grid.cells = {40000, 40000};
  EXPECT_THAT(text(), HasSubstr("more than 32-bit numbers can count"));
}

}  // namespace
}  // namespace breccia
