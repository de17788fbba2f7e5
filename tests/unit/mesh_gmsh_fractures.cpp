#include "mesh/fracture_faces.hpp"
#include "mesh/fracture_sets.hpp"
#include "mesh/quality.hpp"
#include "mesh/topology.hpp"
#include "mesh/validate.hpp"
#include "unit/mesh_samples.hpp"

#include <cmath>
#include <numbers>

namespace breccia {
namespace {

TEST(MeshGmshFractures, FacesFollowCrossingLines) {
  BodyShape body = body_of("block", Rectangle{{0, 0}, {1, 1}}, 0.1);
  FractureNet net;
  net.name = "joints";
  net.size = 0.03;
  net.pieces = {{{0.2, 0.3, 0}, {0.8, 0.6, 0}}, {{0.5, 0.1, 0}, {0.45, 1.2, 0}}};
  body.fractures = {net};
  Mesh<2> mesh = mesh_one<2>(body);
  add_fracture_region(mesh, 0, net, true);
  const double inside = (1 - 0.1) * std::hypot(0.05, 1.1) / 1.1;
  EXPECT_NEAR(face_area(mesh, "block.joints"), std::hypot(0.6, 0.3) + inside, 1e-6);
  EXPECT_GT(assess_quality(mesh).min_angle.value, 15 / 57.3);
  const double faces = static_cast<double>(find_region(mesh, "block.joints")->faces.size());
  EXPECT_NEAR(face_area(mesh, "block.joints") / faces, 0.03, 0.006);
  const Index before = mesh.points();
  cut_open(mesh, "block.joints");
  // A point between two faces is doubled, the crossing becomes four, the end on the surface two.
  EXPECT_EQ(mesh.points() - before, static_cast<Index>(faces) - 4 + 3 + 1);
}

TEST(MeshGmshFractures, DiscsInABoxKeepTheirRim) {
  BodyShape body = body_of("block", Box{{0, 0, 0}, {1, 1, 1}}, 0.25);
  FractureNet net;
  net.name = "penny";
  net.pieces = {disc_piece({0.5, 0.5, 0.5}, {1, 1, 2}, 0.3, 0.15)};
  body.fractures = {net};
  Mesh<3> mesh = mesh_one<3>(body);
  add_fracture_region(mesh, 0, net, true);
  EXPECT_NEAR(face_area(mesh, "block.penny"), std::numbers::pi * 0.09, 1e-6);
  const auto free = build_topology(mesh).free.size();
  const auto faces = find_region(mesh, "block.penny")->faces.size();
  const auto points = static_cast<Index>(find_region(mesh, "block.penny")->points.size());
  const Index before = mesh.points();
  cut_open(mesh, "block.penny");
  EXPECT_EQ(build_topology(mesh).free.size(), free + 2 * faces);
  // Euler: a disc of F triangles and P points has 2 P - F - 2 points on its rim.
  EXPECT_EQ(mesh.points() - before, points - (2 * points - static_cast<Index>(faces) - 2));
}

}  // namespace
}  // namespace breccia
