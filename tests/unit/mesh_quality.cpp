#include "mesh/geometry.hpp"
#include "mesh/quality.hpp"
#include "unit/mesh_samples.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

namespace breccia {
namespace {

using testing::HasSubstr;

TEST(MeshQuality, RegularSimplicesAreOfQualityOne) {
  auto triangle = two_triangles();
  triangle.point = {{0, 0}, {1, 0}, {0.5, std::sqrt(0.75)}, {-0.5, std::sqrt(0.75)}};
  const auto plane = assess_quality(triangle);
  EXPECT_NEAR(plane.worst_shape.value, 1, 1e-14);
  EXPECT_NEAR(plane.min_angle.value, std::numbers::pi / 3, 1e-14);
  EXPECT_NEAR(plane.min_height.value, std::sqrt(0.75), 1e-14);
  auto tet = one_tetrahedron();
  tet.point = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  const auto space = assess_quality(tet);
  EXPECT_NEAR(space.worst_shape.value, 1, 1e-14);
  EXPECT_NEAR(space.min_angle.value, std::acos(1.0 / 3), 1e-14);  // dihedral angle, 70.5 degrees
  EXPECT_EQ(space.shape_histogram[9], 1);
}

TEST(MeshQuality, RightTriangleHasItsClosedForms) {
  // Legs 3 and 4: inradius 1, circumradius 2.5, heights 4, 3 and 2.4.
  Mesh<2> mesh{{{0, 0}, {3, 0}, {0, 4}}, {{0, 1, 2}}, {0}, {"t"}, {}};
  const std::vector<double> speed = {10};
  const auto report = assess_quality<2>(mesh, speed);
  EXPECT_NEAR(report.worst_shape.value, 2 * 1 / 2.5, 1e-14);
  EXPECT_NEAR(report.min_height.value, 2.4, 1e-14);
  EXPECT_NEAR(report.min_angle.value, std::atan2(3, 4), 1e-14);
  EXPECT_NEAR(report.mean_size, 4, 1e-14);
  const double sum = 1 / 16.0 + 1 / 9.0 + 1 / 5.76;
  EXPECT_NEAR(report.time_step.value, 2 / (10 * std::sqrt(3 * sum)), 1e-15);
}

TEST(MeshQuality, NamesTheElementThatSetsTheStep) {
  auto mesh = grid_mesh<2>(4, Pattern::right);
  for (Index e = 20; e < mesh.elements(); ++e) mesh.body[e] = 1;
  mesh.body_names.push_back("steel");
  const std::vector<double> speed = {1000, 5000};  // equal shapes, so the faster body sets it
  const auto report = assess_quality<2>(mesh, speed);
  EXPECT_EQ(report.time_step.element, 20);
  EXPECT_EQ(report.time_step_body, "steel");
  EXPECT_NEAR(report.time_step.value, stable_step<2>(corners(mesh, 20), 5000), 1e-18);
  EXPECT_THAT(to_text(report), HasSubstr("of body \"steel\""));
}

TEST(MeshQuality, FindsTheWorstElementAndItsPlace) {
  auto mesh = grid_mesh<2>(4, Pattern::right);
  mesh.point[12] = {0.5, 0.26};  // pushes point (0.5, 0.5) close to the one below
  const auto report = assess_quality(mesh);
  EXPECT_LT(report.worst_shape.value, 0.2);
  const auto& nodes = mesh.element[report.worst_shape.element];
  EXPECT_TRUE(std::find(nodes.begin(), nodes.end(), 12) != nodes.end());
  EXPECT_EQ(report.worst_shape.centroid, centroid<2>(corners(mesh, report.worst_shape.element)));
}

TEST(MeshQuality, TextHoldsCountsAndLeavesTheStepOutWithoutSpeeds) {
  const std::string text = to_text(assess_quality(grid_mesh<2>(2, Pattern::cross)));
  EXPECT_THAT(text, HasSubstr("mesh: 16 elements, 13 points, 1 m2"));
  EXPECT_THAT(text, HasSubstr("least angle      45 deg"));
  EXPECT_THAT(text, testing::Not(HasSubstr("stable step")));
}

}  // namespace
}  // namespace breccia
