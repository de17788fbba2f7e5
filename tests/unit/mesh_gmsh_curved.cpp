// Composites on the curved boundaries that Gmsh knows.

#include "harness/temp_folder.hpp"
#include "mesh/composite.hpp"
#include "mesh/topology.hpp"
#include "mesh/validate.hpp"
#include "unit/mesh_samples.hpp"

#include <cmath>
#include <numbers>

namespace breccia {
namespace {

template <int D>
Mesh<D> composites_of(BodyShape body, int group) {
  body.curved = true;
  return refined_to_composites(mesh_one<D>(body), std::vector<int>{group});
}

TEST(MeshGmshCurved, DiscIsAPolygonOfTwiceTheSides) {
  const Disc disc{{0.1, 0.2}, 0.025};
  const auto mesh = composites_of<2>(body_of("disc", disc, 0.005), 4);
  EXPECT_NO_THROW(validate(mesh, "disc"));
  const Region& rim = *find_region(mesh, "disc.rim");
  const auto n = static_cast<double>(rim.faces.size());
  EXPECT_NEAR(n, 2 * 2 * std::numbers::pi * disc.radius / 0.005, 8);
  for (Index p : rim.points) {
    EXPECT_NEAR(length(minus(mesh.point[p], disc.centre)), disc.radius, 1e-9 * disc.radius);
  }
  const double polygon = 0.5 * n * disc.radius * disc.radius * std::sin(2 * std::numbers::pi / n);
  EXPECT_NEAR(total_volume(mesh), polygon, 1e-8 * polygon);
  EXPECT_EQ(build_topology(mesh).free.size(), rim.faces.size());
}

// The volume of a body of chords is off by h^2: half the chord, a quarter of the error.
TEST(MeshGmshCurved, BallIsNearerToItsVolume) {
  const BodyShape ball = body_of("ball", Ball{{0, 0, 0}, 0.01}, 0.005);
  const double exact = 4.0 / 3 * std::numbers::pi * std::pow(0.01, 3);
  const double straight = exact - total_volume(mesh_one<3>(ball));
  for (int group : {8, 12}) {
    const auto mesh = composites_of<3>(ball, group);
    EXPECT_NO_THROW(validate(mesh, "ball"));
    EXPECT_NEAR((exact - total_volume(mesh)) / straight, 0.25, 0.05);
    for (Index p : find_region(mesh, "ball.surface")->points) {
      EXPECT_NEAR(length(mesh.point[p]), 0.01, 1e-8);
    }
  }
}

TEST(MeshGmshCurved, StraightBodiesStayStraight) {
  auto body = body_of("plate", Polygon{{{0, 0}, {2, 0}, {0, 1}}, {}}, 0.3);
  body.curved = true;
  EXPECT_TRUE(mesh_one<2>(body).curved.empty());
}

TEST(MeshGmshCurved, LinesHaveTheirMidPoints) {
  auto body = body_of("plate", Rectangle{{0, 0}, {1, 1}}, 0.3);
  body.lines = {{"flaw", {{0.3, 0.3}, {0.7, 0.6}}}};
  const auto mesh = composites_of<2>(body, 4);
  const Region& flaw = *find_region(mesh, "plate.flaw");
  EXPECT_EQ(flaw.points.size(), flaw.faces.size() + 1);
  EXPECT_EQ(flaw.faces.size() % 2, 0U);
  EXPECT_NEAR(face_area(mesh, "plate.flaw"), 0.5, 1e-12);
}

TEST(MeshGmshCurved, ScriptsAreFollowed) {
  const TempFolder folder;
  const std::string path = folder / "quarter.geo";
  put_text(path, R"(Point(1) = {0, 0, 0, 0.3}; Point(2) = {1, 0, 0, 0.3}; Point(3) = {0, 1, 0, 0.3};
Line(1) = {1, 2}; Circle(2) = {2, 1, 3}; Line(3) = {3, 1};
Curve Loop(1) = {1, 2, 3}; Plane Surface(1) = {1};
Physical Surface("rock") = {1}; Physical Curve("arc") = {2};
)");
  const BodyShape body = body_of("slab", MeshFile{path, "rock"}, 0);
  const auto mesh = composites_of<2>(body, 4);
  const Region& arc = *find_region(mesh, "slab.arc");
  EXPECT_EQ(arc.points.size(), arc.faces.size() + 1);
  for (Index p : arc.points) EXPECT_NEAR(length(mesh.point[p]), 1, 1e-9);
  const double straight = std::numbers::pi / 4 - total_volume(mesh_one<2>(body));
  EXPECT_NEAR((std::numbers::pi / 4 - total_volume(mesh)) / straight, 0.25, 0.02);
}

}  // namespace
}  // namespace breccia
