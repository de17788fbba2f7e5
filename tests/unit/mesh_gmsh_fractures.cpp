#include "mesh/fracture_faces.hpp"
#include "mesh/fracture_sets.hpp"
#include "mesh/grains.hpp"
#include "mesh/quality.hpp"
#include "mesh/topology.hpp"
#include "mesh/validate.hpp"
#include "unit/mesh_samples.hpp"

#include <algorithm>
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

/// Pieces of the body that the faces of a region separate.
Index pieces_without(const Mesh<2>& mesh, const Region& region) {
  std::vector<Index> root(static_cast<std::size_t>(mesh.elements()));
  for (Index e = 0; e < mesh.elements(); ++e) root[e] = e;
  const auto find = [&](Index e) {
    while (root[e] != e) e = root[e] = root[root[e]];
    return e;
  };
  Index pieces = mesh.elements();
  const auto cut = [&](Index e, int f) {
    return std::binary_search(region.faces.begin(), region.faces.end(), ElementFace{e, f});
  };
  for (const SharedFace& s : build_topology(mesh).shared) {
    const Index a = find(s.left), b = find(s.right);
    if (a == b || cut(s.left, s.left_face) || cut(s.right, s.right_face)) continue;
    root[b] = a;
    --pieces;
  }
  return pieces;
}

// Hexagons of 0.2 on a lattice: a grain takes 0.2^2 sqrt(3)/2 of the area; those at the sides are
// cut, so that there are more by about half of those that the sides meet.
TEST(MeshGmshFractures, GrainsFillTheBody) {
  for (const double jitter : {0.0, 0.4}) {
    BodyShape body = body_of("rock", Rectangle{{0, 0}, {1.4, 1.4}}, 0.07);
    FractureNet net;
    net.name = "grains";
    net.drawn = true;
    net.pieces = grain_edges(body, 0.2, jitter, 1);
    EXPECT_EQ(net.pieces, grain_edges(body, 0.2, jitter, 1));
    body.fractures = {net};
    Mesh<2> mesh = mesh_one<2>(body);
    add_fracture_region(mesh, 0, net, true);
    const double whole = 1.96 / (0.04 * std::sqrt(0.75)), cut = 1.4 / 0.2 + 1.4 / 0.1732;
    EXPECT_NEAR(pieces_without(mesh, *find_region(mesh, "rock.grains")), whole + cut, 0.15 * whole);
    EXPECT_GT(assess_quality(mesh).min_angle.value, 5 / 57.3) << jitter;  // no slivers
    // Side of a hexagon: 0.2 / sqrt(3), three of them to a grain.
    if (jitter > 0) continue;
    EXPECT_NEAR(face_area(mesh, "rock.grains") / (3 * 0.2 / std::sqrt(3.0) * whole), 1, 0.05);
  }
}

}  // namespace
}  // namespace breccia
