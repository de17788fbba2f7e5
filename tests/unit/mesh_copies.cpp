#include "core/error.hpp"
#include "mesh/copies.hpp"
#include "mesh/structured.hpp"
#include "mesh/topology.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace breccia;

Mesh<3> brick(const std::string& name, double at) {
  Grid<3> grid;
  grid.lower = {at, 0, 0};
  grid.upper = {at + 2, 1, 1};
  grid.cells = {2, 1, 1};
  grid.body = name;
  return structured_mesh(grid);
}

double volume(const Mesh<3>& mesh, Index body) {
  double sum = 0;
  for (Index e = 0; e < mesh.elements(); ++e) {
    if (mesh.body[e] != body) continue;
    Mat<3> g;
    for (int j = 0; j < 3; ++j)
      for (int d = 0; d < 3; ++d)
        g(d, j) = mesh.point[mesh.element[e][j + 1]][d] - mesh.point[mesh.element[e][0]][d];
    sum += determinant(g) / 6;
  }
  return sum;
}

Mat<3> about_z(double angle) {
  return {
      {{std::cos(angle), -std::sin(angle), 0}, {std::sin(angle), std::cos(angle), 0}, {0, 0, 1}}};
}

TEST(MeshCopies, CarryVolumeRegionsAndPlaces) {
  Mesh<3> mesh = brick("other", 20);
  append(mesh, brick("brick", 0));
  mesh.fields["grade"] = {1, std::vector<double>(mesh.element.size(), 3.0)};
  const auto free_of = [](const Mesh<3>& m) { return build_topology(m).free.size(); };
  const std::size_t free = free_of(mesh), elements = mesh.element.size(),
                    points = mesh.point.size();
  const Region side = *find_region(mesh, "brick.left");
  copy_body<3>(mesh, 1,
               {{about_z(0.3), {{1, 0.5, 0.5}}},
                {about_z(1.2), {{5, 0.5, 0.5}}},
                {Mat<3>::identity(), {{1, 5, 0.5}}}});
  EXPECT_EQ(mesh.element.size(), elements + elements);
  EXPECT_EQ(mesh.point.size(), 2 * points);
  EXPECT_NEAR(volume(mesh, 1), 6, 1e-12);
  EXPECT_NEAR(volume(mesh, 0), 2, 1e-12);
  EXPECT_EQ(free_of(mesh), 2 * free);
  EXPECT_EQ(find_region(mesh, "brick")->elements.size(), 3 * elements / 2);
  EXPECT_EQ(find_region(mesh, "brick.left")->faces.size(), 3 * side.faces.size());
  EXPECT_EQ(find_region(mesh, "other")->elements.size(), elements / 2);
  EXPECT_EQ(mesh.fields["grade"].values, std::vector<double>(mesh.element.size(), 3.0));
  // The left side of the copy that was turned by 1.2 about (5, 0.5): 1 m from there, along its axis.
  const Index p = find_region(mesh, "brick.left")->points[side.points.size()];
  const double along =
      (mesh.point[p][0] - 5) * std::cos(1.2) + (mesh.point[p][1] - 0.5) * std::sin(1.2);
  EXPECT_NEAR(along, -1, 1e-12);
}

TEST(MeshCopies, RefuseOverlap) {
  Mesh<3> mesh = brick("brick", 0);
  const Mat<3> same = Mat<3>::identity();
  try {
    copy_body<3>(mesh, 0, {{same, {{1, 0.5, 0.5}}}, {same, {{2.9, 0.5, 0.5}}}});
    FAIL() << "not refused";
  } catch (const Error& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("copies 0 and 1 overlap by"), std::string::npos) << text;
    EXPECT_NE(text.find("widen the pitch"), std::string::npos) << text;
  }
  Mesh<3> touching = brick("brick", 0);
  EXPECT_NO_THROW(copy_body<3>(touching, 0, {{same, {{1, 0.5, 0.5}}}, {same, {{3, 0.5, 0.5}}}}));
}

}  // namespace
