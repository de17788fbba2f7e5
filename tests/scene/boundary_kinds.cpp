// Symmetry, held stress and gravity that rises.
#include "harness/scenes.hpp"

#include <gtest/gtest.h>

namespace breccia {
namespace {

TEST(BoundaryKinds, AMirrorHoldsItsNormalOnly) {
  BlockScene scene;
  scene.more =
      "[[boundary]]\nplane = { point = [0, 0], normal = [0, -2] }\nsymmetry = true\n"
      "[gravity]\nacceleration = [1, -1]\n";
  SceneWorld<2> world(scene.text());
  world.simulation.start();
  world.steps(20);
  const auto x = world.host<NodePosition<2>>();
  const double t = world.time();
  for (Index n = 0; n < world.model().mesh.points(); ++n) {
    if (world.model().mesh.point[n][1] != 0) continue;
    EXPECT_EQ(x(n, 1), 0);
    EXPECT_NEAR(x(n, 0) - world.model().mesh.point[n][0], 0.5 * t * t, 0.5 * t * t);
    EXPECT_GT(x(n, 0), world.model().mesh.point[n][0]);
  }
}

// Forces of the surface hold sigma n of every face, whatever its direction.
TEST(BoundaryKinds, HeldAndAbsorbingFacesCarryTheInitialStress) {
  for (const char* kind : {"held = true", "non_reflecting = true"}) {
    BlockScene scene;
    scene.jitter = 0.3;
    scene.more = fmt::format(
        "[[initial_stress]]\nstress = [-3, -5, -1, 2]\n[[boundary]]\nwhere = \"b\"\n{}\n", kind);
    SceneWorld<2> world(scene.text());
    world.simulation.start();
    evaluate_forces(world, Clock{});
    const auto force = nodal_forces<LoadForce<2>>(world);
    Vec<2> right = Vec<2>::zero(), top = Vec<2>::zero(), all = Vec<2>::zero();
    for (Index n = 0; n < world.model().mesh.points(); ++n) {
      const Point<2>& x = world.model().mesh.point[n];
      all += force[n];
      if (x[1] > 0.01 && x[1] < 0.99 && x[0] == 1) right += force[n];
      if (x[0] > 0.01 && x[0] < 0.99 && x[1] == 1) top += force[n];
    }
    EXPECT_LT(norm(all), 1e-14);
    // Without the corners, whose two faces have two normals.
    EXPECT_LT(std::abs(right[0] / right[1] - -3.0 / 2), 1e-12);
    EXPECT_LT(std::abs(top[1] / top[0] - -5.0 / 2), 1e-12);
  }
}

TEST(BoundaryKinds, GravityRisesWithItsRamp) {
  BlockScene scene;
  scene.more = "[gravity]\nacceleration = [0, -10]\nramp = 0.1\n";
  SceneWorld<2> world(scene.text());
  world.simulation.start();
  Ledger ledger;
  while (world.time() < 0.2) ledger = world.step_and_book(0.2);
  // Half of the ramp and all of what follows: v = -g (t - ramp / 2).
  const auto v = world.host<NodeVelocity<2>>();
  EXPECT_NEAR(v(0, 1), -10 * (0.2 - 0.05), 0.01);
  EXPECT_LT(ledger.residual_1(), 1e-12);
}

}  // namespace
}  // namespace breccia
