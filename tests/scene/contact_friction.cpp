// Blocks on slopes (V-042) and sliding to rest (V-043).
#include "contact_samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace {

using namespace breccia;

constexpr double kG = 9.81;
constexpr const char* kStone =
    "density = 2000\ndamping = 1.0\nelastic = { young = 20e6, poisson = 0.2 }\n";

/// A block on a long floor that is held as a whole, so that nothing is lost to its deformation.
/// Gravity stands for the slope.
class Slope {
 public:
  Slope(double angle, double mu, const std::string& more = {})
      : world(contact_scene({{"floor", "[-0.1, -0.05]", "[1.25, 0.05]", "[30, 1]"},
                             {"block", "[0, 0]", "[0.1, 0.05]", "[5, 3]"}},
                            kStone, fmt::format("friction = {}\ndamping = 0.1", mu), {},
                            "[gravity]\nacceleration = [0, 0]\n"
                            "[[boundary]]\nwhere = \"floor\"\nfixed = [0, 0]\n" +
                                more)),
        angle_(angle * std::numbers::pi / 180) {
    world.simulation.start();
  }

  /// Puts the weight on in 50 ms, first into the slope, then along it, so that nothing hops.
  void settle() {
    run_to(world, 0.06, [&] {
      const double into = std::min(1.0, world.time() / 0.03);
      const double along = std::clamp((world.time() - 0.03) / 0.02, 0.0, 1.0);
      world.model().gravity = {{along * kG * std::sin(angle_), -into * kG * std::cos(angle_)}};
      world.step();
    });
  }
  void run(double until) { run_to(world, until); }
  double place() { return momentum(world, "block").centre[0]; }
  double speed() { return momentum(world, "block").velocity()[0]; }
  /// Slope of the line through the speeds of all steps: the block trembles while it slides.
  double acceleration(double from, double to) {
    run(from);
    double n = 0, t1 = 0, t2 = 0, v1 = 0, tv = 0;
    run_to(world, to, [&] {
      const double t = world.time() - from, v = speed();
      n += 1;
      t1 += t;
      t2 += t * t;
      v1 += v;
      tv += t * v;
      world.steps(8);
    });
    return (n * tv - t1 * v1) / (n * t2 - t1 * t1);
  }

  SceneWorld<2> world;

 private:
  double angle_;
};

// V-042: sliding above the friction angle, g (sin a - mu cos a).
TEST(ContactFriction, BlockSlides) {
  for (const auto& [angle, expected] : {std::pair{30.0, 2.356287}, std::pair{20.0, 0.589702}}) {
    Slope slope(angle, 0.3);
    slope.settle();
    EXPECT_NEAR(slope.acceleration(0.08, 0.3), expected, 5e-3 * expected) << angle;
  }
}

// V-042: 30 degrees on mu = 0.6 (its friction angle is 30.96 degrees) sticks for good.
TEST(ContactFriction, BlockSticks) {
  Slope slope(30, 0.6);
  slope.settle();
  slope.run(0.15);
  const double x = slope.place(), t = slope.world.time();
  slope.run(0.25);
  EXPECT_LT(std::abs(slope.place() - x) / (slope.world.time() - t), 1e-9);
}

// 0.99 and 1.01 of the friction coefficient tell rest from motion.
TEST(ContactFriction, FrictionAngleIsSharp) {
  const double mu = 0.3, angle = 16.69924;
  Slope above(angle, mu / 1.01), below(angle, mu / 0.99);
  above.settle();
  below.settle();
  const double a = angle * std::numbers::pi / 180;
  const double expected = kG * (std::sin(a) - mu / 1.01 * std::cos(a));
  EXPECT_NEAR(above.acceleration(0.1, 0.4), expected, 0.02 * expected);
  below.run(0.2);
  const double x = below.place();
  below.run(0.4);
  EXPECT_NEAR(below.place(), x, 2e-10);
}

// V-043: from 2 m/s to rest; the distance, the time and the heat of friction.
TEST(ContactFriction, SlidingStops) {
  Slope slope(0, 0.3);
  slope.settle();
  SceneWorld<2>& world = slope.world;
  const auto v = world.host<NodeVelocity<2>>();
  for (const Index n : find_region(world.model().mesh, "block")->points) v(n, 0) += 2;
  world.put<NodeVelocity<2>>(v);
  const double x = slope.place(), t = world.time();
  double stopped = 0;
  const double before = world.step_and_book().value("CT_friction");
  run_to(world, t + 0.7, [&] {
    world.steps(4);
    if (stopped == 0 && slope.speed() < 0) stopped = world.time() - t;
  });
  const Ledger ledger = world.step_and_book();
  const double heat = ledger.value("CT_friction") - before;
  const double first = 0.5 * momentum(world, "block").mass * 4;
  EXPECT_NEAR(slope.place() - x, 0.679579, 5e-3 * 0.679579);
  EXPECT_NEAR(stopped, 0.679579, 5e-3 * 0.679579);
  // The rest swings as waves in the block and is lost to its damping.
  EXPECT_NEAR(heat, first, 0.01 * first);
  std::printf("stops after %.6f m, %.6f s; friction heat %.4f of the energy, numeric %.5f\n",
              slope.place() - x, stopped, heat / first, ledger.value("CT_numeric") / first);
}

// Pairs of materials have their own coefficient.
TEST(ContactFriction, PairsOverride) {
  Slope slope(20, 0.0, "[[contact.pair]]\nbetween = [\"m\"]\nfriction = 0.3\n");
  slope.settle();
  EXPECT_NEAR(slope.acceleration(0.08, 0.3), 0.589702, 5e-3 * 0.589702);
}

}  // namespace
