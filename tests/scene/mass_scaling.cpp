// S-02: a block with slivers swings like one without, at the step of the good mesh, and says what
// mass that took.
#include "harness/scenes.hpp"

#include <gtest/gtest.h>

namespace breccia {
namespace {

BlockScene swinging_block(const std::string& more) {
  BlockScene scene;
  scene.size = "[2, 1]";
  scene.cells = "[24, 12]";
  scene.pattern = "right";
  scene.run = "duration = 1\n" + more;
  scene.more =
      "[[boundary]]\nwhere = \"b.left\"\nfixed = [0, 0]\n[gravity]\nacceleration = [0, -10]\n";
  return scene;
}

/// Moves one inner node towards its neighbour until the elements between are `aspect` thin.
void make_slivers(Mesh<2>& mesh, double aspect) {
  const auto at = [&](double x, double y) {
    for (std::size_t n = 0; n < mesh.point.size(); ++n)
      if (std::hypot(mesh.point[n][0] - x, mesh.point[n][1] - y) < 1e-9) return n;
    return mesh.point.size();
  };
  const double h = 1.0 / 12;
  mesh.point.at(at(12 * h, 6 * h))[0] += h * (1 - 1 / aspect);
}

/// Deflection of the far end, summed over time up to `end`.
double swing(SceneWorld<2>& world, double end) {
  Index tip = 0;
  for (Index n = 0; n < world.model().mesh.points(); ++n)
    if (world.model().mesh.point[n][0] == 2 && world.model().mesh.point[n][1] == 1) tip = n;
  const double start = world.host<NodePosition<2>>()(tip, 1);
  double sum = 0;
  while (world.time() < end) {
    const double before = world.time();
    world.step(end);
    sum += (world.host<NodePosition<2>>()(tip, 1) - start) * (world.time() - before);
  }
  return sum / end;
}

TEST(MassScaling, SliversSwingAtTheStepOfTheGoodMesh) {
  const double end = 0.05;
  SceneWorld<2> good(swinging_block("").text());
  good.simulation.start();
  const double whole = good.simulation.clock().dt;
  const double expected = swing(good, end);
  // Rate and mass of a sliver's node grow as their aspect: steps that need a few per cent of mass.
  for (const auto& [aspect, share] : {std::pair{1e1, 0.8}, {1e2, 0.3}, {1e3, 0.1}}) {
    const double step = share * whole;
    SceneWorld<2> plain(swinging_block("").text());
    make_slivers(plain.model().mesh, aspect);
    plain.simulation.start();
    EXPECT_LT(plain.simulation.clock().dt, 0.75 * step) << "no slivers";

    SceneWorld<2> scaled(
        swinging_block(fmt::format("mass_scaling = {{ step = {:.17g} }}", step)).text());
    make_slivers(scaled.model().mesh, aspect);
    scaled.simulation.start();
    EXPECT_NEAR(scaled.simulation.clock().dt, step, 1e-6 * step);
    EXPECT_GT(scaled.model().added_mass, 0);
    // The added mass lies at one node in the middle.
    EXPECT_NEAR(swing(scaled, end), expected, 0.01 * std::abs(expected));
    const Ledger ledger = scaled.step_and_book();
    EXPECT_LT(ledger.residual_1(), 1e-12);
    EXPECT_LT(ledger.residual_2(), 1e-3);
  }
}

// A block that swings has the energy of its first swing for ever; 1e5 steps, with and without mass
// for the slivers.
TEST(MassScalingSlow, SliversStayBoundedOverManySteps) {
  SceneWorld<2> good(swinging_block("").text());
  good.simulation.start();
  const double whole = good.simulation.clock().dt;
  double swings = 0;  // J, most of the good mesh
  for (int k = 0; k < 3000; ++k) {
    const Ledger ledger = good.step_and_book();
    swings = std::max(swings, ledger.kinetic + ledger.stored());
  }
  for (const auto& [aspect, share] : {std::pair{1e2, 0.3}, {1e3, 0.1}, {1e4, 0.03}}) {
    for (const bool scale : {true, false}) {
      SceneWorld<2> world(
          swinging_block(scale ? fmt::format("mass_scaling = {{ step = {:.17g} }}", share * whole)
                               : "")
              .text());
      make_slivers(world.model().mesh, aspect);
      world.simulation.start();
      EXPECT_EQ(world.model().added_mass > 0, scale);
      EXPECT_LT(world.model().added_mass, 0.05);
      double residual = 0, fall = 0;
      for (int k = 0; k < 200; ++k) {
        world.steps(499);
        const Ledger ledger = world.step_and_book();
        residual = std::max(residual, ledger.residual_2());
        fall = std::max(fall, ledger.kinetic + ledger.stored());
        ASSERT_LT(ledger.residual_1(), 1e-10) << aspect;
      }
      EXPECT_LT(residual, 1e-2) << aspect;  // what comes in and what is there, all along
      EXPECT_LT(fall, 1.05 * swings) << aspect;
      EXPECT_GT(fall, 0.1 * swings) << aspect;
    }
  }
}

TEST(MassScaling, AddedMassHasNoWeight) {
  BlockScene scene = swinging_block("mass_scaling = { step = 4e-5, quasi_static = true }");
  scene.more = "[gravity]\nacceleration = [0, -10]\n";
  SceneWorld<2> world(scene.text());
  world.simulation.start();
  ASSERT_GT(world.model().added_mass, 0.1);
  const auto mass = world.host<NodeMass>();
  const auto added = world.host<NodeAddedMass>();
  double all = 0, weightless = 0;
  for (Index n = 0; n < world.model().mesh.points(); ++n) all += mass(n), weightless += added(n);
  EXPECT_NEAR(all - weightless, 1000 * 2, 1e-9 * all);
  EXPECT_NEAR(weightless / (all - weightless), world.model().added_mass, 1e-9);
  world.step();
  double momentum = 0;
  const auto v = world.host<NodeVelocity<2>>();
  for (Index n = 0; n < world.model().mesh.points(); ++n) momentum += mass(n) * v(n, 1);
  // The first kick is half a step.
  EXPECT_NEAR(momentum, -10 * 2000 * 0.5 * world.time(), 1e-9 * all);
}

}  // namespace
}  // namespace breccia
