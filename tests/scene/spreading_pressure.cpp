// V-103: a pressure that depends on time and distance from its source, and follows cracks.
#include "harness/scenes.hpp"

#include <gtest/gtest.h>

namespace breccia {
namespace {

const char* const kFracture =
    "[fracture.m]\ntensile_strength = \"10 MPa\"\ncohesion = \"20 MPa\"\n"
    "friction_angle = \"40 deg\"\nenergy_tension = \"10 kJ/m2\"\n"
    "energy_shear = \"30 kJ/m2\"\nalpha = 1\n";

template <int D>
Vec<D> resultant(SceneWorld<D>& world) {
  Vec<D> sum = Vec<D>::zero();
  for (const Vec<D>& f : nodal_forces<LoadForce<D>>(world)) sum += f;
  return sum;
}

template <int D>
void check_closed(BlockScene scene) {
  scene.jitter = 0.3;
  scene.more = "[[boundary]]\nwhere = \"b\"\npressure = 1e6\n";
  SceneWorld<D> world(scene.text());
  world.simulation.start();
  evaluate_forces(world, Clock{});
  double most = 0;
  for (const Vec<D>& f : nodal_forces<LoadForce<D>>(world)) most = std::max(most, norm(f));
  EXPECT_LT(norm(resultant(world)), 1e-12 * most * world.model().mesh.points());
}

TEST(SpreadingPressure, HasNoResultantOnAClosedSurface) {
  check_closed<2>({});
  check_closed<3>({3, "[1, 1, 1]", "[3, 3, 3]"});
}

// On the left side, at a distance y from the source in its corner: eq:boundary-5.
TEST(SpreadingPressure, DecaysAndArrivesWithDistance) {
  BlockScene scene;
  scene.cells = "[4, 8]";
  scene.more =
      "[[boundary]]\nwhere = \"b.left\"\npressure = 1e6\ntable = [[0, 0], [1, 1]]\n"
      "source = { point = [0, 0], speed = 2, decay = [[0, 1], [1, 0.5]] }\n";
  SceneWorld<2> world(scene.text());
  world.simulation.start();
  Clock clock;
  clock.time = 0.4;
  evaluate_forces(world, clock);
  const auto force = nodal_forces<LoadForce<2>>(world);
  const auto on_face = [](double y) {
    return 1e6 / 8 * (1 - 0.5 * y) * std::max(0.0, 0.4 - y / 2);
  };
  for (Index n = 0; n < world.model().mesh.points(); ++n) {
    const Point<2>& x = world.model().mesh.point[n];
    const bool there = x[0] == 0;
    double expected = 0;
    if (there && x[1] > 1e-9) expected += 0.5 * on_face(x[1] - 1.0 / 16);
    if (there && x[1] < 1 - 1e-9) expected += 0.5 * on_face(x[1] + 1.0 / 16);
    EXPECT_NEAR(force[n][0], expected, 1e-9) << x[0] << " " << x[1];
  }
}

/// Calls the faces released whose middles are on y = 1/2, x < `end`, as the fracture module would.
int release(SceneWorld<2>& world, double end) {
  const auto status = world.host<FaceStatus>();
  const Model<2>& model = world.model();
  int count = 0;
  for (std::size_t f = 0; f < model.topology.shared.size(); ++f) {
    const SharedFace& face = model.topology.shared[f];
    double x = 0, y = 0, dy = 0;
    for (int j = 0; j < 2; ++j) {
      const Point<2>& p =
          model.mesh.point[model.mesh.element[face.left][face_node<2>(face.left_face, j)]];
      x += p[0] / 2, y += p[1] / 2, dy += (j ? 1 : -1) * p[1];
    }
    if (std::abs(y - 0.5) > 1e-9 || std::abs(dy) > 1e-9 || x > end) continue;
    status(f) = face_status::released;
    ++count;
  }
  world.put<FaceStatus>(status);
  ++world.model().releases;
  return count;
}

// The crack opens from the pressed side: its faces take the pressure in the next step, both sides
// alike. A crack that does not touch a pressed face stays dry.
TEST(SpreadingPressure, FollowsACrackWithinAStep) {
  BlockScene scene;
  scene.cells = "[8, 8]";
  scene.pattern = "right";
  scene.more = std::string(kFracture) +
               "[[boundary]]\nwhere = \"b.left\"\npressure = 1e6\non_new_faces = true\n";
  SceneWorld<2> world(scene.text());
  world.simulation.start();
  evaluate_forces(world, Clock{});
  const Vec<2> before = resultant(world);
  EXPECT_NEAR(before[0], 1e6, 1e-6);
  ASSERT_EQ(release(world, 0.4), 3);
  evaluate_forces(world, Clock{});
  EXPECT_LT(norm(resultant(world) - before), 1e-6) << "both sides of a crack balance";
  const auto corner = world.host<LoadForce<2>>();
  double up = 0;
  for (Index e = 0; e < world.model().elements(); ++e)
    for (int a = 0; a < 3; ++a) up += std::abs(corner(e, a, 1));
  EXPECT_NEAR(up, 2 * 3 * 1e6 / 8, 1e-6);
}

TEST(SpreadingPressure, StaysOffCracksThatItDoesNotReach) {
  BlockScene scene;
  scene.cells = "[8, 8]";
  scene.pattern = "right";
  scene.more = std::string(kFracture) +
               "[[boundary]]\nwhere = \"b.top\"\npressure = 1e6\non_new_faces = true\n";
  SceneWorld<2> world(scene.text());
  world.simulation.start();
  release(world, 0.4);
  evaluate_forces(world, Clock{});
  const auto corner = world.host<LoadForce<2>>();
  double up = 0;
  for (Index e = 0; e < world.model().elements(); ++e)
    for (int a = 0; a < 3; ++a) up += std::abs(corner(e, a, 1));
  EXPECT_NEAR(up, 1e6, 1e-6);
}

}  // namespace
}  // namespace breccia
