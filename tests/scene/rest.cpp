// Coming to rest: both ways end in the static state, and what they take is booked.
#include "harness/scenes.hpp"

#include <gtest/gtest.h>

namespace breccia {
namespace {

/// A bar on a foot that slides, pulled at its top by a traction that rises within `ramp`.
BlockScene pulled_bar(const std::string& rest, double ramp) {
  BlockScene scene;
  scene.size = "[1, 4]";
  scene.cells = "[3, 12]";
  scene.run = "duration = 2\nrest = " + rest;
  scene.more = fmt::format(
      "[[boundary]]\nwhere = \"b.bottom\"\nfixed = [\"free\", 0]\n"
      "[[boundary]]\nwhere = \"b.left\"\nfixed = [0, \"free\"]\n"
      "[[boundary]]\nwhere = \"b.top\"\ntraction = [0, 1e6]\n{}",
      ramp > 0 ? fmt::format("ramp = {}\n", ramp) : "");
  return scene;
}

/// Steps until rest; the energies of the step in which it is found.
Ledger run_to_rest(SceneWorld<2>& world, int most) {
  world.simulation.start();
  Ledger ledger;
  for (int i = 0; i < most && !world.model().rest.reached; ++i) ledger = world.step_and_book();
  return ledger;
}

/// Plane strain without lateral stress: nominal traction = E / (1 - nu^2) times the strain, to first
/// order in the strain (1e-3).
double expected_rise(const BlockScene& scene, double y) {
  return 1e6 * (1 - scene.poisson * scene.poisson) / scene.young * y;
}

void check_rest(const std::string& rest) {
  const BlockScene scene = pulled_bar(rest, 0);
  SceneWorld<2> world(scene.text());
  const Ledger ledger = run_to_rest(world, 100000);
  ASSERT_TRUE(world.model().rest.reached) << rest;
  EXPECT_LT(world.model().rest.unbalance, 1e-6);
  const auto x = world.host<NodePosition<2>>();
  for (Index n = 0; n < world.model().mesh.points(); ++n) {
    const double y = world.model().mesh.point[n][1];
    // Second order terms of a strain of 1e-3, and what a net force of 1e-6 may still move.
    EXPECT_NEAR(x(n, 1) - y, expected_rise(scene, y), 2e-3 * expected_rise(scene, 4)) << n;
  }
  // Of the work of a dead load half is stored, half taken.
  const double work = ledger.external();
  EXPECT_GT(work, 0);
  EXPECT_NEAR(ledger.value("IE_elastic") / work, 0.5, 2e-3);
  EXPECT_NEAR(ledger.value("RELAX") / work, 0.5, 2e-3);
  EXPECT_LT(ledger.residual_1(), 1e-12);
  EXPECT_LT(ledger.residual_2(), 2e-3);
}

TEST(Rest, TakingVelocitiesEndsInTheStaticState) {
  check_rest("{ method = \"kinetic\", tolerance = 1e-6 }");
}
TEST(Rest, ResistingMotionEndsInTheStaticState) {
  check_rest("{ method = \"local\", tolerance = 1e-6 }");
}

// Nothing moves at t = 0, and that is not rest: the load is still to come.
TEST(Rest, CountsFromTheEndOfTheRampOnly) {
  SceneWorld<2> world(pulled_bar("{ tolerance = 0.2 }", 0.2).text());
  run_to_rest(world, 100000);
  ASSERT_TRUE(world.model().rest.reached);
  EXPECT_GE(world.model().rest.time, 0.2);
  SceneWorld<2> early(pulled_bar("{ tolerance = 0.2, after = 0 }", 0.2).text());
  run_to_rest(early, 100000);
  ASSERT_TRUE(early.model().rest.reached);
  EXPECT_LT(early.model().rest.time, 0.2);
}

TEST(Rest, LetsGoWhereTheRunGoesOn) {
  SceneWorld<2> world(pulled_bar("{ tolerance = 1e-3, then = \"go on\" }", 0).text());
  run_to_rest(world, 100000);
  ASSERT_TRUE(world.model().rest.reached);
  EXPECT_FALSE(world.model().rest.stops);
  put_field<NodeVelocity<2>, 2>(world, [](const Vec<2>& x) { return Vec<2>{{0, 0.1 * x[1]}}; });
  const double taken = world.model().rest.taken;
  Ledger ledger;
  const double start =
      world.simulation.motion().kinetic_energy(world.model()) + world.model().stored_energy();
  double least = start;
  for (int i = 0; i < 400; ++i) {
    ledger = world.step_and_book();
    least = std::min(least, ledger.kinetic);
  }
  EXPECT_EQ(world.model().rest.taken, taken);
  EXPECT_LT(least, 0.1 * start) << "it did not swing";
}

}  // namespace
}  // namespace breccia
