// Two bodies that meet: momenta, energies, and where the energy stays (V-037, S-06).
#include "contact_samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace breccia;

constexpr const char* kSoft = "density = 1000\nelastic = { young = 1e9, poisson = 0.2 }\n";

/// Oblique, spinning, of different size: the corner of one meets the side of the other.
std::string oblique(const std::string& run, double speed, const std::string& direction) {
  const auto by = [&](double x, double y) { return fmt::format("[{}, {}]", x * speed, y * speed); };
  return contact_scene(
      {{"a", "[0, 0]", "[0.3, 0.2]", "[9, 6]", by(20, 1), fmt::format("{}", 30 * speed)},
       {"b", "[0.32, 0.05]", "[0.2, 0.24]", "[5, 6]", by(-10, -3), fmt::format("{}", -40 * speed),
        "right"}},
      kSoft, "friction = 0\ndamping = 0\ndirection = \"" + direction + "\"", run);
}

struct Collision {
  double energy_error = 0, linear = 0, angular = 0, elastic = 0;
  int touched = 0;
};

Collision collide(double step, double speed, const std::string& direction) {
  SceneWorld<2> world(oblique(fmt::format("step = {:.17g}", step), speed, direction));
  world.simulation.start();
  const Momentum start = momentum(world);
  double energy = 0;
  Collision c;
  while (world.time() < 4e-3 / speed) {
    const Ledger ledger = world.step_and_book();
    if (energy == 0) energy = total_energy(ledger);
    c.touched += ledger.value("CT_stored") > 0 ? 1 : 0;
    c.energy_error = std::max(c.energy_error, std::abs(total_energy(ledger) / energy - 1));
    c.elastic = std::max(c.elastic, ledger.value("CT_stored") / energy);
    EXPECT_LT(ledger.residual_1(), 1e-12);
  }
  const Momentum end = momentum(world);
  c.linear = norm(end.linear - start.linear) / start.size;
  c.angular = std::abs(end.angular - start.angular) / (start.size * 0.3);
  return c;
}

// V-037, frictionless and undamped. The exact gradient makes no energy: what is left falls with the
// step. The smooth one trades some for a steady direction where a corner digs into a side.
TEST(ContactCollision, ObliqueKeepsMomentaAndEnergy) {
  for (const double speed : {1.0, 0.1}) {
    const Collision coarse = collide(2e-6, speed, "conservative");
    const Collision fine = collide(1e-6, speed, "conservative");
    const Collision smooth = collide(2e-6, speed, "smooth");
    for (const Collision& c : {coarse, fine, smooth}) {
      EXPECT_GT(c.touched, 100);
      EXPECT_GT(c.elastic, 1e-3);
      EXPECT_LT(c.linear, 1e-13);
      EXPECT_LT(c.angular, 1e-12);
    }
    EXPECT_LT(coarse.energy_error, 1e-3);
    EXPECT_LT(fine.energy_error, 0.8 * coarse.energy_error);
    EXPECT_LT(smooth.energy_error, 4e-3);
    std::printf("energy error %.3g, at half the step %.3g, smooth %.3g\n", coarse.energy_error,
                fine.energy_error, smooth.energy_error);
  }
}

// Two equal bars exchange their velocities (V-007); the meshes do not match.
TEST(ContactCollision, EqualBarsExchangeVelocities) {
  SceneWorld<2> world(
      contact_scene({{"a", "[0, 0]", "[1, 0.05]", "[100, 5]", "[1, 0]"},
                     {"b", "[1.0002, 0]", "[1, 0.05]", "[120, 6]", "[0, 0]", "0", "right"}},
                    "density = 1000\nelastic = { young = 1e9, poisson = 0 }\n",
                    "friction = 0\ndamping = 0", "plane = \"stress\""));
  world.simulation.start();
  while (world.time() < 4e-3) world.step();
  EXPECT_NEAR(momentum(world, "a").velocity()[0], 0.0, 5e-3);
  EXPECT_NEAR(momentum(world, "b").velocity()[0], 1.0, 5e-3);
}

/// Moves a body as a whole, as if it had always been there.
void shift(SceneWorld<2>& world, const std::string& body, const Vec<2>& by) {
  const auto x = world.host<NodePosition<2>>();
  for (const Index n : find_region(world.model().mesh, body)->points)
    for (int d = 0; d < 2; ++d) x(n, d) += by[d];
  world.put<NodePosition<2>>(x);
}

// S-06: overlaps of 10, 50, 90 % of an element at the start. What contact reports as stored comes
// out as energy, no more; nobody is faster than it allows; nothing is missed.
TEST(ContactCollision, DeepOverlapReleasesItsPotential) {
  for (const std::string direction : {"conservative", "smooth"})
    for (const double share : {0.1, 0.5, 0.9}) {
      SceneWorld<2> world(contact_scene(
          {{"a", "[0, 0]", "[0.4, 0.2]", "[8, 4]"}, {"b", "[0.1, 0.21]", "[0.2, 0.2]", "[5, 5]"}},
          kSoft, "friction = 0\ndamping = 0\ndirection = \"" + direction + "\"",
          "step_factor = 0.2"));
      world.simulation.start();
      shift(world, "b", {{0.0, -0.01 - share * 0.04}});
      const double stored = world.step_and_book().value("CT_stored");
      EXPECT_GT(stored, 0);
      double error = 0;
      Ledger last;
      while (world.time() < 3e-3) {
        last = world.step_and_book();
        error = std::max(error, std::abs(total_energy(last) / stored - 1));
      }
      EXPECT_EQ(last.value("CT_stored"), 0) << share;
      EXPECT_LT(error, direction == "smooth" ? 0.02 + 0.1 * share : 0.01) << direction << share;
      const Momentum b = momentum(world, "b");
      EXPECT_LE(norm(b.velocity()), std::sqrt(2 * stored / b.mass));
      std::printf("%s, overlap %.1f: stored %.4g J, energy off by %.3g\n", direction.c_str(), share,
                  stored, error);
    }
}

// A body that goes in deeper than the targets reach is followed there, not lost.
TEST(ContactCollision, DeepImpactIsFollowed) {
  SceneWorld<2> world(contact_scene({{"a", "[0, 0]", "[1, 1]", "[25, 25]"},
                                     {"b", "[0.45, 1.001]", "[0.1, 0.3]", "[3, 9]", "[0, -60]"}},
                                    "density = 1000\nelastic = { young = 1e9, poisson = 0 }\n",
                                    "friction = 0\ndamping = 0\nstiffness = \"6e7 Pa/m\""));
  world.simulation.start();
  double deepest = 0, first = 0;
  Row row;
  Ledger ledger;
  while (world.time() < 0.06) {
    ledger = world.step_and_book();
    if (first == 0) first = total_energy(ledger);
    const auto x = momentum(world, "b").centre;
    deepest = std::max(deepest, 1.15 - x[1]);
    if (momentum(world, "b").velocity()[1] > 0 && ledger.value("CT_stored") == 0) break;
  }
  for (const auto& module : world.simulation.modules())
    module->observe(world.model(), world.simulation.clock(), Moment::before, row);
  EXPECT_GT(deepest, 0.16);  // four elements; targets reach three at first
  EXPECT_EQ(row.get("contacts_lost"), 0);
  EXPECT_GT(momentum(world, "b").velocity()[1], 30);
  EXPECT_NEAR(ledger.kinetic + ledger.stored() + ledger.dissipated(), first, 0.02 * first);
  std::printf("depth %.3f, energy %.4f of the first\n", deepest, total_energy(ledger) / first);
}

// V-054: nodes that move farther than the list covers stop the run; nothing is missed in silence.
TEST(ContactCollision, LateSearchStopsTheRun) {
  SceneWorld<2> world(contact_scene(
      {{"a", "[0, 0]", "[0.4, 0.2]", "[8, 4]"}, {"b", "[0.1, 0.3]", "[0.2, 0.2]", "[4, 4]"}}, kSoft,
      "friction = 0"));
  world.simulation.start();
  world.steps(3);
  EXPECT_FALSE(world.model().stop.raised);
  shift(world, "b", {{0, -0.12}});
  world.steps(10);
  EXPECT_TRUE(world.model().stop.raised);
  EXPECT_NE(world.model().stop.cause.find("contact search came too late"), std::string::npos);
  EXPECT_NE(world.model().stop.cause.find("contact.skin"), std::string::npos);
}

}  // namespace
