// S-12, S-13, S-15: everything breaks at once.
#include "harness/scenes.hpp"
#include "scene/fragments.hpp"

#include <gtest/gtest.h>

namespace breccia {
namespace {

/// A block that flies apart so fast that every face breaks within a few steps.
std::string bursting(const std::string& alpha, const std::string& more) {
  BlockScene scene;
  scene.size = "[10e-3, 10e-3]";
  scene.cells = "[12, 12]";
  scene.density = 2500;
  scene.young = 60e9;
  scene.poisson = 0.25;
  scene.body = "expansion = 4e5\nspin = 2e4\nvelocity = [30, 10]";
  scene.more =
      "[fracture.m]\ntensile_strength = 10e6\ncohesion = 30e6\nfriction_angle = 0.7\n"
      "energy_tension = 50\nenergy_shear = 500\nalpha = " +
      alpha + "\n" + more;
  return scene.text();
}

struct Sums {
  double mass = 0, momentum[2] = {}, kinetic = 0;
};

Sums sums_of(SceneWorld<2>& world) {
  const auto v = world.host<NodeVelocity<2>>();
  const auto mass = world.host<NodeMass>();
  Sums sum;
  for (Index n = 0; n < world.model().nodes(); ++n) {
    sum.mass += mass(n);
    for (int d = 0; d < 2; ++d) sum.momentum[d] += mass(n) * v(n, d);
    sum.kinetic += 0.5 * mass(n) * norm2(row<2>(v, n));
  }
  return sum;
}

void check_burst(const std::string& alpha, const std::string& more) {
  SCOPED_TRACE("alpha " + alpha + " " + more);
  SceneWorld<2> world(bursting(alpha, more));
  world.simulation.start();
  const Sums before = sums_of(world);
  double worst_1 = 0, worst_2 = 0;
  while (world.time() < 3e-6) {
    const Ledger ledger = world.step_and_book(3e-6);
    worst_1 = std::max(worst_1, ledger.residual_1());
    worst_2 = std::max(worst_2, ledger.residual_2());
  }
  EXPECT_LT(worst_1, 1e-11);
  EXPECT_LT(worst_2, 0.02);
  const Fragments found = find_fragments(world.model());
  EXPECT_EQ(found.pieces.size(), static_cast<std::size_t>(world.model().elements()));
  const Sums after = sums_of(world);
  EXPECT_NEAR(after.mass / before.mass, 1, 1e-13);
  for (int d = 0; d < 2; ++d)
    EXPECT_NEAR(after.momentum[d], before.momentum[d], 1e-12 * before.mass * 4e3);
  for (const Fragments::Piece& piece : found.pieces) {
    EXPECT_GT(piece.mass, 0);
    const double square =
        piece.velocity[0] * piece.velocity[0] + piece.velocity[1] * piece.velocity[1];
    EXPECT_LT(0.5 * piece.mass * square, before.kinetic);
  }
}

TEST(Pulverised, MassMomentaAndEnergyOutliveIt) {
  for (const std::string alpha : {"0", "0.5", "0.95", "1"}) check_burst(alpha, "");
  check_burst("0.95", "[contact]\nfriction = 0.3\n");
}

// A block that is torn, pressed together and torn again: what has been spent stays spent.
TEST(Pulverised, LoadThatTurnsRoundGivesNothingBack) {
  SceneWorld<2> world(
      "[run]\ndimension = 2\nduration = 1\n"
      "[[body]]\nname = \"b\"\nmaterial = \"m\"\n"
      "shape = { rectangle = { corner = [0, 0], size = [5e-3, 5e-3] } }\n"
      "mesh = { generator = \"structured\", cells = [6, 6] }\n"
      "[material.m]\ndensity = 2500\nelastic = { young = 60e9, poisson = 0.25 }\n"
      "[fracture.m]\ntensile_strength = 8e6\ncohesion = 24e6\nfriction_angle = 0.7\n"
      "energy_tension = 60\nenergy_shear = 600\n[contact]\nfriction = 0.5\n"
      "[[boundary]]\nplane = { point = [0, 0], normal = [0, 1] }\nfixed = [0, 0]\n"
      "[[boundary]]\nplane = { point = [0, 5e-3], normal = [0, 1] }\nvelocity = [0.1, 1]\n"
      "table = [[0, 0], [2e-6, 1], [8e-6, 1], [12e-6, -1.5], [20e-6, -1.5], [24e-6, 1], "
      "[40e-6, 1]]\n");
  world.simulation.start();
  double spent = 0, worst_1 = 0, worst_2 = 0;
  while (world.time() < 40e-6) {
    const Ledger ledger = world.step_and_book(40e-6);
    worst_1 = std::max(worst_1, ledger.residual_1());
    if (world.time() > 2e-6) worst_2 = std::max(worst_2, ledger.residual_2());
    const double now = ledger.value("IF_G1") + ledger.value("IF_G2") + ledger.value("IF_friction");
    EXPECT_GE(now, spent * (1 - 1e-12));
    spent = now;
  }
  EXPECT_GT(spent, 0.5 * 60 * 5e-3);  // half a crack through it at least
  EXPECT_LT(worst_1, 1e-11);
  EXPECT_LT(worst_2, 0.02);
}

}  // namespace
}  // namespace breccia
