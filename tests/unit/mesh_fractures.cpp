#include "harness/temp_folder.hpp"
#include "mesh/fracture_faces.hpp"
#include "mesh/fracture_files.hpp"
#include "mesh/fracture_sets.hpp"
#include "mesh/quality.hpp"
#include "mesh/topology.hpp"
#include "mesh/validate.hpp"
#include "unit/mesh_samples.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <numbers>

namespace breccia {
namespace {

using testing::AllOf;
using testing::HasSubstr;

FractureNet net_of(std::vector<FracturePiece> pieces) {
  FractureNet net;
  net.name = "flaw";
  net.pieces = std::move(pieces);
  return net;
}

FracturePiece line(double x0, double y0, double x1, double y1) {
  return {{x0, y0, 0}, {x1, y1, 0}};
}

/// A square at the height z = 0.5.
FracturePiece square(double from, double to) {
  return {{from, from, 0.5}, {to, from, 0.5}, {to, to, 0.5}, {from, to, 0.5}};
}

TEST(MeshFractures, FacesOfAGridAreFound) {
  Mesh<2> mesh = grid_mesh<2>(8, Pattern::cross);
  add_fracture_region(mesh, 0, net_of({line(0.25, 0.5, 0.75, 0.5)}), false);
  const std::string name = mesh.body_names[0] + ".flaw";
  EXPECT_NEAR(face_area(mesh, name), 0.5, 1e-12);
  EXPECT_EQ(find_region(mesh, name)->faces.size(), 4U);
  Mesh<3> space = grid_mesh<3>(4, Pattern::kuhn);
  add_fracture_region(space, 0, net_of({square(0.25, 0.75)}), false);
  EXPECT_NEAR(face_area(space, space.body_names[0] + ".flaw"), 0.25, 1e-12);
  const std::string said = error_text(
      [&] { add_fracture_region(mesh, 0, net_of({line(0.25, 0.51, 0.75, 0.51)}), false); });
  EXPECT_THAT(said, AllOf(HasSubstr("only 0 of 0.5 lie on faces"), HasSubstr("let Gmsh mesh")));
}

template <int D>
void check_cut(Mesh<D> mesh, const FracturePiece& piece, Index doubled, std::size_t faces) {
  const auto before = build_topology(mesh);
  const Index points = mesh.points();
  const double volume = total_volume(mesh);
  add_fracture_region(mesh, 0, net_of({piece}), false);
  cut_open(mesh, mesh.body_names[0] + ".flaw");
  const auto after = build_topology(mesh);
  EXPECT_EQ(mesh.points(), points + doubled);
  EXPECT_EQ(after.free.size(), before.free.size() + 2 * faces);
  EXPECT_EQ(after.shared.size(), before.shared.size() - faces);
  EXPECT_EQ(total_volume(mesh), volume);
  const Region* body = find_region(mesh, mesh.body_names[0]);
  EXPECT_EQ(body->points.size(), static_cast<std::size_t>(mesh.points()));
  EXPECT_EQ(body->faces, after.free);
}

// The rim inside stays whole: of n points along a line inside n - 2 are doubled, of a line through
// the body all n; of (n + 1)^2 points of a square (n - 1)^2.
TEST(MeshFractures, CutDoublesAllPointsButTheRim) {
  check_cut(grid_mesh<2>(8, Pattern::cross), line(0.25, 0.5, 0.75, 0.5), 3, 4);
  check_cut(grid_mesh<2>(8, Pattern::cross), line(0, 0.5, 1, 0.5), 9, 8);
  // Two of eight triangles have all their corners on the rim.
  check_cut(grid_mesh<3>(4, Pattern::kuhn), square(0.25, 0.75), 1, 6);
  check_cut(grid_mesh<3>(4, Pattern::kuhn), square(0, 1), 25, 32);
}

TEST(MeshFractures, CrossingCutsMakeFourSides) {
  Mesh<2> mesh = grid_mesh<2>(8, Pattern::cross);
  const Index points = mesh.points();
  add_fracture_region(mesh, 0, net_of({line(0.25, 0.5, 0.75, 0.5), line(0.5, 0.25, 0.5, 0.75)}),
                      false);
  cut_open(mesh, mesh.body_names[0] + ".flaw");
  EXPECT_EQ(mesh.points(), points + 4 + 3);
}

TEST(MeshFractures, WhatLeavesSliversIsRefused) {
  BodyShape body = body_of("block", Rectangle{{0, 0}, {1, 1}}, 0.1);
  const auto said = [&](std::vector<FracturePiece> pieces) {
    body.fractures = {net_of(std::move(pieces))};
    return error_text([&] { check_fractures(2, body); });
  };
  const FracturePiece base = line(0.2, 0.5, 0.8, 0.5);
  EXPECT_THAT(said({base, line(0.2, 0.485, 0.8, 0.515)}), HasSubstr("meets it at 2.8"));
  EXPECT_THAT(said({base, line(0.3, 0.5, 0.9, 0.5)}), HasSubstr("coincides"));
  EXPECT_THAT(said({base, line(0.5, 0.505, 0.5, 0.8)}), HasSubstr("ends 0.005 m beside it"));
  EXPECT_THAT(said({base, line(0.8, 0.5, 0.2, 0.53)}), HasSubstr("meets it at 2.8"));
  EXPECT_THAT(said({line(0.5, 0.5, 0.995, 0.5)}),
              AllOf(HasSubstr("beside it"), HasSubstr("let it end on the surface")));
  EXPECT_THAT(said({line(0.5, 0.5, 0.5, 0.5)}), HasSubstr("has no extent"));
  body.shape = Disc{{0, 0}, 1};
  EXPECT_THAT(said({line(0, 0, 0.995, 0)}), HasSubstr("ends 0.005 m below the surface"));
  body.shape = Rectangle{{0, 0}, {1, 1}};
  for (const FracturePiece& good : {line(0.5, 0.5, 0.5, 0.8), line(0.8, 0.5, 1, 0.5),
                                    line(0.2, 0.3, 0.8, 0.7), line(0.8, 0.5, 1.2, 0.55)}) {
    body.fractures = {net_of({base, good})};
    EXPECT_NO_THROW(check_fractures(2, body)) << good[1][0];
  }
}

TEST(MeshFractures, WhatLeavesSliversInSpaceIsRefused) {
  BodyShape body = body_of("block", Box{{0, 0, 0}, {1, 1, 1}}, 0.1);
  const auto said = [&](std::vector<FracturePiece> pieces) {
    body.fractures = {net_of(std::move(pieces))};
    return error_text([&] { check_fractures(3, body); });
  };
  FracturePiece shifted = square(0.3, 0.7), tilted = square(0.2, 0.8), bent = square(0.2, 0.8);
  for (auto& x : shifted) x[2] += 0.004;
  for (auto& x : tilted) x[2] += 0.06 * (x[0] - 0.5);
  bent[2][2] += 0.1;
  EXPECT_THAT(said({square(0.2, 0.8), shifted}), HasSubstr("coincides"));
  EXPECT_THAT(said({square(0.2, 0.8), tilted}),
              testing::AnyOf(HasSubstr("meets it at 3.4"), HasSubstr("coincides")));
  EXPECT_THAT(said({bent}), HasSubstr("is not flat"));
  EXPECT_THAT(said({square(0.2, 0.995)}), HasSubstr("below the surface"));
  body.fractures = {
      net_of({square(0.2, 0.8), {{0.5, 0.2, 0.2}, {0.5, 0.8, 0.2}, {0.5, 0.8, 0.8}}})};
  EXPECT_NO_THROW(check_fractures(3, body));
}

TEST(MeshFractures, FilesAreRead) {
  const TempFolder folder;
  const std::string csv = folder.path() + "/a.csv", dxf = folder.path() + "/a.dxf";
  std::ofstream(csv) << "x, y\n# one\n0, 0\n1, 0.5\n2, 0\n\n3,3\n4,4\n";
  const auto lines = read_fractures(csv, 2, 0.5);
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[1], line(0.5, 0.25, 1, 0));
  EXPECT_EQ(lines[2], line(1.5, 1.5, 2, 2));
  std::ofstream(dxf) << "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\nrock\n10\n1\n20\n2\n11\n3\n21\n4\n"
                        "0\nCIRCLE\n10\n9\n20\n9\n40\n1\n"
                        "0\nLWPOLYLINE\n90\n3\n70\n1\n10\n0\n20\n0\n10\n1\n20\n0\n10\n1\n20\n1\n"
                        "0\nPOLYLINE\n66\n1\n70\n0\n10\n0\n20\n0\n0\nVERTEX\n10\n5\n20\n6\n70\n0\n"
                        "0\nVERTEX\n10\n7\n20\n8\n0\nSEQEND\n0\nENDSEC\n0\nEOF\n";
  const auto drawn = read_fractures(dxf, 2, 1);
  ASSERT_EQ(drawn.size(), 5U);
  EXPECT_EQ(drawn[0], line(1, 2, 3, 4));
  EXPECT_EQ(drawn[3], line(1, 1, 0, 0));
  EXPECT_EQ(drawn[4], line(5, 6, 7, 8));
  std::ofstream(dxf) << "0\n3DFACE\n10\n0\n20\n0\n30\n0\n11\n1\n21\n0\n31\n0\n12\n1\n22\n1\n32\n2\n"
                        "13\n1\n23\n1\n33\n2\n0\nEOF\n";
  const auto faces = read_fractures(dxf, 3, 1);
  ASSERT_EQ(faces.size(), 1U);
  EXPECT_EQ(faces[0], (FracturePiece{{0, 0, 0}, {1, 0, 0}, {1, 1, 2}}));
  std::ofstream(csv) << "0, 0\n1, one\n";
  EXPECT_THAT(error_text([&] { read_fractures(csv, 2, 1); }),
              AllOf(HasSubstr("a.csv:2"), HasSubstr("\"one\" is not a number")));
  std::ofstream(csv) << "0, 0, 0\n";
  EXPECT_THAT(error_text([&] { read_fractures(csv, 2, 1); }), HasSubstr("more than 2 numbers"));
  std::ofstream(csv) << "# nothing\n";
  EXPECT_THAT(error_text([&] { read_fractures(csv, 2, 1); }), HasSubstr("no fracture"));
}

TEST(MeshFractures, SetsHaveTheirDistributions) {
  BodyShape body = body_of("block", Rectangle{{0, 0}, {1000, 1000}}, 1e-3);
  FractureSet set;
  set.number = 2000;
  set.length = {1, 100, 2.5};
  set.concentration = 4;
  const auto pieces = draw_fractures(2, set, body, {});
  ASSERT_EQ(pieces.size(), 2000U);
  EXPECT_EQ(draw_fractures(2, set, body, {}), pieces);
  // Density l^-2.5 from 1 to 100: mean 3 (1 - 0.1) / (1 - 0.001); standard error 6.4 / sqrt(2000).
  double mean = 0, cosine = 0;
  for (const auto& p : pieces) {
    mean += measure_of(p) / 2000;
    cosine += (p[1][0] - p[0][0]) / measure_of(p) / 2000;
  }
  EXPECT_NEAR(mean, 3 * 0.9 / 0.999, 0.45);
  // von Mises: mean cosine I1(4) / I0(4) = 0.8635; standard error 0.004.
  EXPECT_NEAR(cosine, 0.8635, 0.015);
  set.number = 0;
  set.intensity = 0.002;
  double sum = 0;
  for (const auto& p : draw_fractures(2, set, body, {})) sum += measure_of(p);
  EXPECT_NEAR(sum, 0.002 * 1e6, 150);  // one fracture, and what sticks out
}

TEST(MeshFractures, SetsInSpaceFollowFisher) {
  BodyShape body = body_of("block", Box{{0, 0, 0}, {100, 100, 100}}, 0.1);
  FractureSet set;
  set.number = 1000;
  set.length = {1, 1, 0};
  set.direction = {0, 0, 2};
  set.concentration = 5;
  double cosine = 0, area = 0;
  for (const auto& p : draw_fractures(3, set, body, {})) {
    const auto n = cross(minus(p[1], p[0]), minus(p[2], p[0]));
    cosine += n[2] / length(n) / 1000;
    area += measure_of(p) / 1000;
  }
  // coth 5 - 1/5; standard error 0.006
  EXPECT_NEAR(std::abs(cosine), 1 / std::tanh(5.0) - 0.2, 0.02);
  EXPECT_NEAR(area, std::numbers::pi / 4, 1e-9);
}

TEST(MeshFractures, NoRoomIsTold) {
  BodyShape body = body_of("block", Rectangle{{0, 0}, {1, 1}}, 0.5);
  FractureSet set;
  set.number = 1000;
  set.length = {0.5, 0.5, 0};
  set.parallel = true;
  EXPECT_THAT(error_text([&] { draw_fractures(2, set, body, {}); }),
              HasSubstr("no room for more without slivers"));
}

TEST(MeshFractures, PlanesCrossTheWholeBody) {
  const BodyShape body = body_of("block", Rectangle{{0, 0}, {1, 1}}, 0.05);
  EXPECT_EQ(parallel_planes(2, body, 0.2, {1, 0, 0}, {0, 0.1, 0}).size(), 5U);
  const BodyShape cube = body_of("block", Box{{0, 0, 0}, {1, 1, 1}}, 0.05);
  EXPECT_EQ(parallel_planes(3, cube, 0.25, {0, 0, 1}, {0, 0, 0.125}).size(), 4U);
}

}  // namespace
}  // namespace breccia
