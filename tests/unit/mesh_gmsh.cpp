#include "harness/temp_folder.hpp"
#include "mesh/geometry.hpp"
#include "mesh/quality.hpp"
#include "mesh/shapes.hpp"
#include "mesh/topology.hpp"
#include "mesh/validate.hpp"
#include "unit/mesh_samples.hpp"

#include <Kokkos_Core.hpp>

#include <gmock/gmock.h>

#include <clocale>
#include <cmath>
#include <complex>
#include <numbers>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace breccia {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(MeshGmsh, DiscAreaIsThatOfItsPolygon) {
  const auto mesh = mesh_one<2>(body_of("disc", Disc{{0.1, 0.2}, 0.025}, 0.002));
  const Region* rim = find_region(mesh, "disc.rim");
  ASSERT_TRUE(rim);
  const auto n = static_cast<double>(rim->faces.size());
  // Four arcs of equal chords, so the mesh is a regular polygon inscribed in the circle.
  const double polygon = 0.5 * n * 0.025 * 0.025 * std::sin(2 * std::numbers::pi / n);
  EXPECT_NEAR(total_volume(mesh), polygon, 1e-9 * polygon);  // OCC places points to about 1e-10
  EXPECT_NEAR(n, 2 * std::numbers::pi * 0.025 / 0.002, 4);
}

TEST(MeshGmsh, DiscHasPointsOnItsPoles) {
  const auto mesh = mesh_one<2>(body_of("disc", Disc{{0, 0}, 0.025}, 0.002));
  for (const Point<2>& pole : {Point<2>{0, 0.025}, Point<2>{0, -0.025}, Point<2>{0.025, 0}}) {
    double nearest = 1;
    for (const auto& x : mesh.point) nearest = std::min(nearest, length(minus(x, pole)));
    EXPECT_EQ(nearest, 0);
  }
}

TEST(MeshGmsh, SizeIsWhatWasAsked) {
  const auto mesh = mesh_one<2>(body_of("disc", Disc{{0, 0}, 0.025}, 0.001));
  const auto report = assess_quality(mesh);
  EXPECT_NEAR(report.mean_size, 0.001, 0.1e-3);
  EXPECT_GT(report.mean_shape, 0.9);
  EXPECT_GT(report.min_angle.value, 20 / 57.3);
}

/// Mean of exp(6 i angle) over the edges: 1 for a crystal of equilateral triangles, 0 when edges
/// point in all directions alike.
double hexatic_order(const Mesh<2>& mesh) {
  std::complex<double> sum = 0;
  for (Index e = 0; e < mesh.elements(); ++e) {
    const auto x = corners(mesh, e);
    for (int a = 0; a < 3; ++a) {
      const auto edge = minus(x[(a + 1) % 3], x[a]);
      sum += std::polar(1.0, 6 * std::atan2(edge[1], edge[0]));
    }
  }
  return std::abs(sum) / (3.0 * mesh.elements());
}

TEST(MeshGmsh, IrregularMeshHasNoPreferredDirection) {
  auto body = body_of("disc", Disc{{0, 0}, 0.025}, 0.001);
  EXPECT_LT(hexatic_order(mesh_one<2>(body)), 0.08);  // 0.016 on a finer disc; noise ~ edges^-1/2
  body.arrangement = Arrangement::quick;
  EXPECT_LT(hexatic_order(mesh_one<2>(body)), 0.3);
  body.arrangement = Arrangement::regular;
  EXPECT_GT(hexatic_order(mesh_one<2>(body)), 0.5);
}

TEST(MeshGmsh, SameBitsTwiceAndOtherBitsForAnotherSeed) {
  auto body = body_of("disc", Disc{{0, 0}, 0.025}, 0.003);
  const auto first = mesh_one<2>(body);
  expect_same_mesh(first, mesh_one<2>(body));
  body.seed = 2;
  EXPECT_NE(first.point, mesh_one<2>(body).point);
}

TEST(MeshGmsh, ScaleOfTheSceneDoesNotMatter) {
  const auto grain = mesh_one<2>(body_of("grain", Disc{{0, 0}, 0.5e-6}, 0.05e-6));
  const auto dome = mesh_one<2>(body_of("dome", Disc{{0, 0}, 5e5}, 0.5e5));
  // Scaled lengths differ by less than a factor 2, so the meshes are alike but not equal.
  EXPECT_NEAR(grain.elements(), dome.elements(), 0.05 * grain.elements());
  EXPECT_GT(assess_quality(grain).mean_shape, 0.9);
  EXPECT_GT(assess_quality(dome).mean_shape, 0.9);
}

TEST(MeshGmsh, RefinementIsFineInsideAndCoarseOutside) {
  auto body = body_of("plate", Rectangle{{0, 0}, {1, 1}}, 0.1);
  body.refinements = {{{0.5, 0.5, 0}, 0.1, 0.01, 0}};
  const auto mesh = mesh_one<2>(body);
  double fine = 0, coarse = 0, n_fine = 0, n_coarse = 0;
  for (Index e = 0; e < mesh.elements(); ++e) {
    const auto x = corners(mesh, e);
    const double r = length(minus(centroid<2>(x), Point<2>{0.5, 0.5}));
    const double size = length(minus(x[0], x[1]));
    if (r < 0.08) fine += size, n_fine += 1;
    if (r > 0.5) coarse += size, n_coarse += 1;
  }
  EXPECT_NEAR(fine / n_fine, 0.01, 0.002);
  EXPECT_NEAR(coarse / n_coarse, 0.1, 0.03);
}

TEST(MeshGmsh, PolygonWithHoleHasAreaAndSides) {
  const Polygon l_shape{{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}},
                        {{{0.2, 0.2}, {0.4, 0.2}, {0.4, 0.5}, {0.2, 0.5}}}};
  const auto mesh = mesh_one<2>(body_of("frame", l_shape, 0.1));
  EXPECT_NEAR(total_volume(mesh), 3 - 0.06, 1e-9);
  EXPECT_NEAR(face_area(mesh, "frame.hole0"), 1, 1e-9);
  EXPECT_NEAR(face_area(mesh, "frame.side0"), 2, 1e-9);
  EXPECT_NEAR(face_area(mesh, "frame.side2"), 1, 1e-9);
}

TEST(MeshGmsh, PartsShareTheirCommonFaces) {
  std::vector<BodyShape> bodies = {body_of("left", Rectangle{{0, 0}, {1, 1}}, 0.2),
                                   body_of("right", Rectangle{{1, 0}, {2, 1}}, 0.1)};
  const auto apart = mesh_bodies<2>(bodies);
  bodies[0].part_of = bodies[1].part_of = "wall";
  const auto joined = mesh_bodies<2>(bodies);
  const auto count_between = [](const Mesh<2>& mesh) {
    double sum = 0;
    for (const SharedFace& f : build_topology(mesh).shared) {
      if (mesh.body[f.left] == mesh.body[f.right]) continue;
      sum += length(face_normal_area<2>(corners(mesh, f.left), f.left_face));
    }
    return sum;
  };
  EXPECT_EQ(count_between(apart), 0);
  EXPECT_NEAR(count_between(joined), 1, 1e-9);
  EXPECT_NEAR(total_volume(joined, 0), 1, 1e-9);
  EXPECT_NEAR(face_area(joined, "left.right"), 1, 1e-9);
  EXPECT_NEAR(face_area(joined, "right.left"), 1, 1e-9);
}

TEST(MeshGmsh, LaterPartTakesTheOverlap) {
  std::vector<BodyShape> bodies = {body_of("matrix", Rectangle{{0, 0}, {1, 1}}, 0.1),
                                   body_of("grain", Disc{{0.5, 0.5}, 0.25}, 0.05)};
  bodies[0].part_of = bodies[1].part_of = "rock";
  const auto mesh = mesh_bodies<2>(bodies);
  EXPECT_NEAR(total_volume(mesh), 1, 1e-9);
  // Chords of about 0.05 on a circle of radius 0.25 lose up to 1 % of its area.
  EXPECT_NEAR(total_volume(mesh, 1), std::numbers::pi / 16, 0.01 * std::numbers::pi / 16);
  EXPECT_GT(face_area(mesh, "grain.rim"), 1.5);
}

TEST(MeshGmsh, LinesBecomeFaces) {
  auto body = body_of("plate", Rectangle{{0, 0}, {1, 1}}, 0.1);
  body.lines = {{"kink", {{0.3, 0.3}, {0.6, 0.4}, {0.7, 0.7}}},
                {"cut", {{0.2, -0.1}, {0.2, 1.1}}},
                {"crossing", {{0.1, 0.5}, {0.9, 0.5}}}};
  const auto mesh = mesh_one<2>(body);
  EXPECT_NEAR(total_volume(mesh), 1, 1e-9);
  EXPECT_NEAR(face_area(mesh, "plate.kink"), std::hypot(0.3, 0.1) + std::hypot(0.1, 0.3), 1e-9);
  EXPECT_NEAR(face_area(mesh, "plate.cut"), 1, 1e-9);
  EXPECT_NEAR(face_area(mesh, "plate.crossing"), 0.8, 1e-9);
}

TEST(MeshGmsh, SolidsHaveVolumesAndSides) {
  const auto box = mesh_one<3>(body_of("box", Box{{0, 0, 0}, {1, 2, 1}}, 0.4));
  EXPECT_NEAR(total_volume(box), 2, 1e-9);
  EXPECT_NEAR(face_area(box, "box.left"), 2, 1e-9);
  EXPECT_NEAR(face_area(box, "box.back"), 2, 1e-9);
  const auto ball = mesh_one<3>(body_of("ball", Ball{{0, 0, 1}, 1}, 0.25));
  // Chords of 0.25 on radius 1 lose about 3 h^2 / 8 R^2 of the volume.
  EXPECT_NEAR(total_volume(ball), 4.18879, 0.03 * 4.18879);
  EXPECT_EQ(find_region(ball, "ball.surface")->faces.size(), build_topology(ball).free.size());
  const auto rod = mesh_one<3>(body_of("rod", Cylinder{{0, 0, 0}, {0, 0, 2}, 0.5}, 0.2));
  EXPECT_NEAR(total_volume(rod), std::numbers::pi / 2, 0.03 * std::numbers::pi / 2);
  const auto faces = find_region(rod, "rod.start")->faces.size() +
                     find_region(rod, "rod.end")->faces.size() +
                     find_region(rod, "rod.side")->faces.size();
  EXPECT_EQ(faces, build_topology(rod).free.size());
  for (const auto& mesh : {box, ball, rod}) EXPECT_NO_THROW(validate(mesh, "solid"));
}

TEST(MeshGmsh, BodiesKeepTheirOrderAcrossParts) {
  std::vector<BodyShape> bodies = {body_of("a", Rectangle{{0, 0}, {1, 1}}, 0.5),
                                   body_of("b", Rectangle{{5, 0}, {6, 1}}, 0.5),
                                   body_of("c", Rectangle{{1, 0}, {2, 1}}, 0.5)};
  bodies[0].part_of = bodies[2].part_of = "wall";
  const auto mesh = mesh_bodies<2>(bodies);
  EXPECT_EQ(mesh.body_names, (std::vector<std::string>{"a", "b", "c"}));
  for (Index e = 0; e < mesh.elements(); ++e) {
    const double x = centroid<2>(corners(mesh, e))[0];
    EXPECT_EQ(mesh.body[e], x > 4 ? 1 : (x > 1 ? 2 : 0));
  }
}
TEST(MeshGmsh, LinesOutsideTheirBodyAreRefused) {
  auto body = body_of("plate", Rectangle{{0, 0}, {1, 1}}, 0.2);
  body.lines = {{"crack", {{2, 2}, {3, 3}}}};
  EXPECT_THAT(error_text([&] { mesh_one<2>(body); }),
              HasSubstr("body \"plate\": the line \"crack\" does not run through it"));
}

TEST(MeshGmsh, AwkwardGeometryIsMeshed) {
  const auto coarse = mesh_one<2>(body_of("disc", Disc{{0, 0}, 1}, 10));
  EXPECT_NEAR(total_volume(coarse), std::sqrt(8), 1e-9);  // an octagon: two chords an arc
  // Points along a straight side, as digitised outlines have them.
  const Polygon straight{{{0, 0}, {0.5, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0.5}}, {}};
  EXPECT_NEAR(total_volume(mesh_one<2>(body_of("plate", straight, 0.2))), 1, 1e-9);
  // A grain that touches the side of its matrix at one point.
  std::vector<BodyShape> bodies = {body_of("matrix", Rectangle{{0, 0}, {1, 1}}, 0.1),
                                   body_of("grain", Disc{{0.25, 0.5}, 0.25}, 0.05)};
  bodies[0].part_of = bodies[1].part_of = "rock";
  EXPECT_NEAR(total_volume(mesh_bodies<2>(bodies)), 1, 1e-3);
  // Lines that meet, cross, end on the side and lie on the side.
  auto plate = body_of("plate", Rectangle{{0, 0}, {1, 1}}, 0.1);
  plate.lines = {{"a", {{0.2, 0.2}, {0.8, 0.8}}},
                 {"b", {{0.2, 0.8}, {0.8, 0.2}}},
                 {"c", {{0.8, 0.8}, {1, 0.8}}},
                 {"d", {{0, 0}, {0, 1}}}};
  const auto cut = mesh_one<2>(plate);
  EXPECT_NEAR(total_volume(cut), 1, 1e-9);
  EXPECT_NEAR(face_area(cut, "plate.c"), 0.2, 1e-9);
  EXPECT_NEAR(face_area(cut, "plate.d"), 1, 1e-9);
  EXPECT_THAT(error_text([] {
                mesh_one<3>(body_of("ball", Ball{{0, 0, 0}, 1}, 5));
              }),
              AllOf(HasSubstr("body \"ball\""), HasSubstr("a smaller size")));
}

constexpr const char* kGeo = R"(
SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 2, 1};
Rectangle(2) = {2, 0, 0, 1, 1};
Coherence;
Physical Surface("rock") = {1};
Physical Surface("steel") = {2};
Physical Curve("foot") = {1};
MeshSize {:} = 0.25;
)";

TEST(MeshGmsh, ReadsScripts) {
  const TempFolder folder;
  const std::string path = folder / "slab.geo";
  put_text(path, kGeo);
  const auto mesh = mesh_one<2>(body_of("slab", MeshFile{path, "rock"}, 0));
  EXPECT_NEAR(total_volume(mesh), 2, 1e-9);
  ASSERT_TRUE(find_region(mesh, "slab.foot"));
  EXPECT_GT(face_area(mesh, "slab.foot"), 0.9);
  EXPECT_NEAR(assess_quality(mesh).mean_size, 0.25, 0.06);
  const auto fine = mesh_one<2>(body_of("slab", MeshFile{path, "rock"}, 0.1));
  EXPECT_NEAR(assess_quality(fine).mean_size, 0.1, 0.02);
}

TEST(MeshGmsh, WrongScriptsAreRefusedByName) {
  const TempFolder folder;
  const std::string path = folder / "slab.geo";
  put_text(path, "Point(1) = {0, 0, 0};\nFoo(2);\n");
  const auto refusal = [&] {
    return error_text([&] { mesh_one<2>(body_of("slab", MeshFile{path, ""}, 0)); });
  };
  EXPECT_THAT(refusal(), AllOf(HasSubstr("slab.geo"), HasSubstr("line 2")));
  put_text(path, "Point(1) = {0, 0, 0};\n");
  EXPECT_THAT(refusal(), AllOf(HasSubstr("slab.geo"), HasSubstr("no triangles")));
  std::filesystem::remove(path);
  EXPECT_THAT(refusal(), AllOf(HasSubstr("slab.geo"), HasSubstr("cannot be read")));
}

TEST(MeshGmsh, PartsThatAreTakenWholeAreRefused) {
  std::vector<BodyShape> bodies = {body_of("grain", Disc{{0, 0}, 0.1}, 0.05),
                                   body_of("cover", Disc{{0, 0}, 0.2}, 0.05)};
  bodies[0].part_of = bodies[1].part_of = "rock";
  EXPECT_THAT(error_text([&] { mesh_bodies<2>(bodies); }),
              HasSubstr("body \"grain\": later bodies of its part cover it wholly"));
}

TEST(MeshGmsh, LeavesThreadsAndLocaleAlone) {
  const std::string locale = std::setlocale(LC_ALL, nullptr);
  const int threads = Kokkos::DefaultHostExecutionSpace().concurrency();
  mesh_one<2>(body_of("disc", Disc{{0, 0}, 1}, 0.5));
  EXPECT_EQ(std::setlocale(LC_ALL, nullptr), locale);
  EXPECT_EQ(Kokkos::DefaultHostExecutionSpace().concurrency(), threads);
#ifdef _OPENMP
  EXPECT_EQ(omp_get_max_threads(), threads);
#endif
}

}  // namespace
}  // namespace breccia
