#include "mesh/geometry.hpp"
#include "mesh/topology.hpp"
#include "mesh/validate.hpp"
#include "unit/mesh_samples.hpp"

#include <gmock/gmock.h>

#include <limits>

namespace breccia {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

template <int D>
std::string refusal(const Mesh<D>& mesh) {
  return error_text([&] { validate(mesh, "plate.msh"); });
}

TEST(MeshValidate, AcceptsGoodMeshes) {
  EXPECT_NO_THROW(validate(two_triangles(), "x"));
  EXPECT_NO_THROW(validate(one_tetrahedron(), "x"));
}

TEST(MeshValidate, NamesInvertedElements) {
  auto mesh = grid_mesh<3>(2, Pattern::kuhn);
  std::swap(mesh.element[17][0], mesh.element[17][1]);  // S-01: one tetrahedron mirrored
  EXPECT_THAT(refusal(mesh), AllOf(HasSubstr("plate.msh: element 17 "), HasSubstr("inverted"),
                                   HasSubstr("swap two points")));
}

TEST(MeshValidate, ListsTheFirstFewIds) {
  auto mesh = grid_mesh<2>(4, Pattern::right);
  for (Index e = 3; e < 11; ++e) std::swap(mesh.element[e][0], mesh.element[e][1]);
  EXPECT_THAT(refusal(mesh), HasSubstr("elements 3, 4, 5, 6, 7 and 3 more"));
}

TEST(MeshValidate, NamesCoincidentPoints) {  // S-03
  auto mesh = two_triangles();
  mesh.point.push_back({1, 1});  // the second triangle gets its own copy of point 2
  mesh.element[1][1] = 4;
  EXPECT_THAT(refusal(mesh), AllOf(HasSubstr("points 2 and 4 coincide"), HasSubstr("(1, 1) m"),
                                   HasSubstr("Coherence")));
}

TEST(MeshValidate, FindsCoincidentPointsAcrossCellBorders) {
  // Shifts of either sign in every axis put the copy into any of the neighbouring search cells.
  for (int k = 0; k < 3; ++k) {
    for (const double shift : {-5e-7, 5e-7}) {
      auto mesh = grid_mesh<3>(2, Pattern::kuhn);
      for (Index e = 0; e < mesh.elements(); ++e) {
        for (Index& p : mesh.element[e]) {
          if (p != 13 || e % 2 == 0) continue;
          p = mesh.points();
        }
      }
      auto copy = mesh.point[13];
      copy[k] += 0.5 * shift;
      mesh.point.push_back(copy);
      mesh.regions.clear();
      EXPECT_THAT(refusal(mesh), HasSubstr("points 13 and 27 coincide"));
    }
  }
}

TEST(MeshValidate, PointsOfTwoBodiesMayCoincide) {
  auto mesh = two_triangles();
  mesh.point.push_back({0, 0});
  mesh.point.push_back({1, 1});
  mesh.element[1] = {4, 5, 3};
  mesh.body[1] = 1;
  mesh.body_names.push_back("other");
  EXPECT_NO_THROW(validate(mesh, "x"));
}

TEST(MeshValidate, NamesZeroSizeElements) {  // S-03
  auto mesh = two_triangles();
  mesh.point[3] = {0.5, 0.5};
  EXPECT_THAT(refusal(mesh), AllOf(HasSubstr("element 1 "), HasSubstr("zero area")));
  auto solid = one_tetrahedron();
  solid.point[3] = {0.3, 0.3, 0};
  EXPECT_THAT(refusal(solid), AllOf(HasSubstr("element 0 "), HasSubstr("zero volume")));
}

TEST(MeshValidate, AcceptsSlivers) {  // S-02: aspect 1e4 costs time step, it is not an error
  auto mesh = two_triangles();
  mesh.point = {{0, 0}, {1, 0}, {1, 1e-4}, {0, 1e-4}};
  EXPECT_NO_THROW(validate(mesh, "x"));
  auto solid = one_tetrahedron();
  solid.point[2] = {0, 1e-4, 0};
  solid.point[3] = {0, 0, 1e-4};
  EXPECT_NO_THROW(validate(solid, "x"));
}

TEST(MeshValidate, NamesDuplicateElements) {  // S-03
  auto mesh = two_triangles();
  mesh.element.push_back({1, 2, 0});
  mesh.body.push_back(0);
  EXPECT_THAT(refusal(mesh),
              AllOf(HasSubstr("elements 0 and 2 "), HasSubstr("have the same points")));
}

TEST(MeshValidate, NamesOrphanPoints) {  // S-03
  auto mesh = two_triangles();
  mesh.point.push_back({7, 8});
  EXPECT_THAT(refusal(mesh),
              AllOf(HasSubstr("point 4 "), HasSubstr("(7, 8) m"), HasSubstr("used by no element")));
}

TEST(MeshValidate, NamesNonManifoldFaces) {  // S-03
  auto mesh = two_triangles();
  mesh.point.push_back({2, 0.5});
  mesh.element.push_back({0, 4, 2});
  mesh.body.push_back(0);
  EXPECT_THAT(refusal(mesh), AllOf(HasSubstr("elements 0, 1 and 2 "), HasSubstr("share one face")));
}

TEST(MeshValidate, NamesFoldedElements) {
  auto mesh = two_triangles();
  mesh.point[3] = {1.5, 0.2};
  mesh.element[1] = {0, 3, 2};
  EXPECT_THAT(refusal(mesh), AllOf(HasSubstr("elements 0 and 1 "), HasSubstr("same side")));
}

TEST(MeshValidate, NamesRepeatedPoints) {
  auto mesh = two_triangles();
  mesh.element[1] = {0, 2, 2};
  EXPECT_THAT(refusal(mesh), AllOf(HasSubstr("element 1 "), HasSubstr("use a point twice")));
}

TEST(MeshValidate, NamesPointsThatAreNotFinite) {
  auto mesh = two_triangles();
  mesh.point[2][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal(mesh), HasSubstr("point 2 without finite coordinates"));
  mesh.point[2][1] = std::numeric_limits<double>::infinity();
  EXPECT_THAT(refusal(mesh), HasSubstr("point 2 without finite coordinates"));
}

TEST(MeshValidate, NamesNumbersOutOfRange) {
  auto mesh = two_triangles();
  mesh.element[1][2] = 4;
  EXPECT_THAT(refusal(mesh), HasSubstr("element 1 with point numbers outside 0 to 3"));
  mesh.element[1][2] = -1;
  EXPECT_THAT(refusal(mesh), HasSubstr("element 1 with point numbers outside"));
}

TEST(MeshValidate, NamesEmptyMeshesAndBodies) {
  EXPECT_THAT(refusal(Mesh<2>{}), HasSubstr("no elements"));
  auto mesh = two_triangles();
  mesh.body_names.push_back("ghost");
  EXPECT_THAT(refusal(mesh), HasSubstr("body \"ghost\" has no elements"));
  mesh.body[0] = 5;
  EXPECT_THAT(refusal(mesh), HasSubstr("element 0 of a body"));
}

TEST(MeshValidate, NamesDamagedRegions) {
  auto mesh = two_triangles();
  mesh.regions.push_back({"top", {}, {{1, 3}}, {}});
  EXPECT_THAT(refusal(mesh), HasSubstr("region \"top\" names entities"));
}

TEST(MeshValidate, TurnsClockwiseMeshesOver) {
  auto mesh = grid_mesh<2>(3, Pattern::cross);
  const auto top = *find_region(mesh, "body.top");
  for (auto& x : mesh.point) x[0] = -x[0];  // a mirror image: all elements turn clockwise
  EXPECT_THAT(refusal(mesh), HasSubstr("inverted"));
  EXPECT_TRUE(orient_if_all_mirrored(mesh));
  EXPECT_NO_THROW(validate(mesh, "x"));
  for (const ElementFace& f : find_region(mesh, "body.top")->faces) {
    EXPECT_GT(face_normal_area<2>(corners(mesh, f.element), f.face)[1], 0);
  }
  EXPECT_EQ(find_region(mesh, "body.top")->points, top.points);
  EXPECT_FALSE(orient_if_all_mirrored(mesh));
}

TEST(MeshValidate, LeavesMixedOrientationToTheUser) {
  auto mesh = two_triangles();
  std::swap(mesh.element[1][0], mesh.element[1][1]);
  EXPECT_FALSE(orient_if_all_mirrored(mesh));
  EXPECT_THAT(refusal(mesh), HasSubstr("element 1 "));
}

}  // namespace
}  // namespace breccia
