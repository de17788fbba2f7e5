// Discs that roll: on a slope (V-048), and as polygons over a flat floor (V-035).
#include "contact_samples.hpp"
#include "harness/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace breccia {
namespace {

constexpr double kG = 9.81;

struct Disc {
  double radius, young, speed, friction;
  int sides;
  std::string floor, cells;  ///< size of the floor, m, and its cells
};

/// A disc on a floor that is held as a whole. Gravity is turned on by the test.
std::string scene_of(const Disc& d) {
  return fmt::format(
      "[run]\ndimension = 2\nduration = 10\n"
      "[[body]]\nname = \"floor\"\nmaterial = \"m\"\n"
      "shape = {{ rectangle = {{ corner = [{:.17g}, {:.17g}], size = {} }} }}\n"
      "mesh = {{ generator = \"structured\", cells = {}, jitter = 0.2 }}\n"
      "[[body]]\nname = \"disc\"\nmaterial = \"m\"\n"
      "shape = {{ disc = {{ centre = [0, {:.17g}], diameter = {:.17g} }} }}\n"
      "mesh = {{ size = {:.17g} }}\nvelocity = [{}, 0]\nspin = {}\n"
      "[material.m]\ndensity = 1000\nelastic = {{ young = {}, poisson = 0.2 }}\n"
      "[contact]\nfriction = {}\ndamping = 0.5\n[gravity]\nacceleration = [0, 0]\n"
      "[[boundary]]\nwhere = \"floor\"\nfixed = [0, 0]\n",
      -d.radius, -0.2 * d.radius, d.floor, d.cells, d.radius, 2 * d.radius,
      2 * std::numbers::pi * d.radius / d.sides, d.speed, -d.speed / d.radius, d.young, d.friction);
}

/// Slope of the line through y(t).
struct Line {
  double n = 0, t1 = 0, t2 = 0, y1 = 0, ty = 0;
  void add(double t, double y) {
    n += 1;
    t1 += t;
    t2 += t * t;
    y1 += y;
    ty += t * y;
  }
  double slope() const { return (n * ty - t1 * y1) / (n * t2 - t1 * t1); }
};

struct Rates {
  double speed, spin;  ///< acceleration, m/s2 and rad/s2
};

/// Down a slope of 30 degrees; the weight comes on slowly, first into the slope.
Rates roll_down(double friction) {
  SceneWorld<2> world(scene_of({0.1, 4e6, 0, friction, 128, "[0.5, 0.02]", "[100, 2]"}));
  world.simulation.start();
  const double along = 0.5, into = std::sqrt(0.75), inertia = 0.5 * 0.1 * 0.1;
  Line speed, spin;
  run_to(world, 0.4, [&] {
    const double t = world.time();
    world.model().gravity = {
        {kG * along * std::clamp((t - 0.1) / 0.05, 0.0, 1.0), -kG * into * std::min(1.0, t / 0.1)}};
    world.step();
    if (t < 0.17 || world.simulation.clock().step % 20 != 0) return;
    const Momentum disc = momentum(world, "disc");
    speed.add(t, disc.velocity()[0]);
    spin.add(t, (cross(disc.centre, disc.linear) - disc.angular) / (disc.mass * inertia));
  });
  return {speed.slope(), spin.slope()};
}

// V-048: (2/3) g sin where friction of tan/3 = 0.192 can hold it.
TEST(Rolling, DiscRollsDownASlope) {
  const Rates rates = roll_down(0.3);
  EXPECT_NEAR(rates.speed, 3.2700, 5e-3 * 3.2700);
  EXPECT_NEAR(rates.spin * 0.1, 3.2700, 5e-3 * 3.2700);
}

// Below it slips: g (sin - mu cos), and the friction spins it by mu m g cos R / I.
TEST(Rolling, DiscSlipsDownASlope) {
  const Rates rates = roll_down(0.1);
  const double held = 0.1 * kG * std::sqrt(0.75);
  EXPECT_NEAR(rates.speed, 0.5 * kG - held, 5e-3 * (0.5 * kG - held));
  EXPECT_NEAR(rates.spin * 0.1, 2 * held, 5e-3 * 2 * held);
}

struct Ride {
  double lost, force, ripple, hop;  ///< share of the speed; over the weight; m
  double speed;                     ///< at the first second, m/s
  double residual, numeric;         ///< res_2; CT_numeric over the kinetic energy
};

/// Over a flat floor, from the first second to the end.
Ride roll_along(int sides, const std::string& cells, double end) {
  SceneWorld<2> world(scene_of({1, 1e8, 1, 0.5, sides, "[5, 0.2]", cells}));
  world.simulation.start();
  double n = 0, sum = 0, squares = 0, high = 0, low = 1e300, first = 0, last = 0;
  run_to(world, end, [&] {
    const double t = world.time(), dt = world.simulation.clock().dt;
    world.model().gravity = {{0, -kG * std::min(1.0, t / 0.5)}};
    const double before = momentum(world, "disc").velocity()[1];
    world.step();
    if (t < 1) return;
    const Momentum disc = momentum(world, "disc");
    if (first == 0) first = disc.velocity()[0];
    last = disc.velocity()[0];
    const double force = (disc.velocity()[1] - before) / dt / kG + 1;
    n += 1;
    sum += force;
    squares += force * force;
    high = std::max(high, disc.centre[1]);
    low = std::min(low, disc.centre[1]);
  });
  const double mean = sum / n;
  const Ledger ledger = world.step_and_book();
  return {1 - last / first,
          mean,
          std::sqrt(squares / n - mean * mean),
          high - low,
          first,
          ledger.residual_2(),
          std::abs(ledger.value("CT_numeric")) / ledger.kinetic};
}

// V-035: the speed is kept and the energies are booked, whatever the mesh of the floor. A polygon
// this stiff hops over its corners, the middles of whose sides are 1/800 of the radius lower than a
// circle: the force ripples by 0.8 of the weight and more where hops and corners fall in step; by
// less the more sides it has.
TEST(RollingSlow, PolygonKeepsItsSpeed) {
  const Ride ride = roll_along(64, "[50, 2]", 3), other = roll_along(64, "[61, 3]", 3);
  const Ride finer = roll_along(128, "[50, 2]", 2);
  for (const Ride& r : {ride, other, finer}) {
    std::printf("speed lost %.4f, force %.4f of the weight, ripple %.3f, hop %.2g m\n", r.lost,
                r.force, r.ripple, r.hop);
    // The speed of one instant: what a hop holds, m g hop, comes out of 3/4 m v^2 and goes back.
    EXPECT_LT(std::abs(r.lost), kG * r.hop / (1.5 * r.speed * r.speed));
    EXPECT_NEAR(r.force, 1, 0.1);
    EXPECT_LT(r.residual, 1e-5);
    EXPECT_LT(r.numeric, 5e-4);
  }
  EXPECT_LT(finer.ripple, 0.6 * ride.ripple);
  EXPECT_LT(finer.hop, 0.5 * ride.hop);
}

}  // namespace
}  // namespace breccia
