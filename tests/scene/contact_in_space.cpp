// Bodies in space: momenta and energy of collisions (V-037), slopes of any direction (V-042), cracks
// that close, the same bits for any number of threads.
#include "contact_samples.hpp"

#include <algorithm>
#include <numbers>

namespace {

using namespace breccia;

std::string box(const std::string& name, const Vec<3>& corner, const Vec<3>& size,
                const std::string& cells, const std::string& more = {}) {
  return fmt::format(
      "[[body]]\nname = \"{}\"\nmaterial = \"m\"\n"
      "shape = {{ box = {{ corner = [{}, {}, {}], size = [{}, {}, {}] }} }}\n"
      "mesh = {{ generator = \"structured\", cells = {}, jitter = 0.15 }}\n{}\n",
      name, corner[0], corner[1], corner[2], size[0], size[1], size[2], cells, more);
}

std::string scene(const std::string& run, const std::string& bodies, const std::string& contact,
                  const std::string& material) {
  return "[run]\ndimension = 3\nduration = 1\n" + run + "\n" + bodies + "[material.m]\n" +
         material + "\n[contact]\n" + contact + "\n";
}

constexpr const char* kSoft = "density = 1000\nelastic = { young = 1e9, poisson = 0.2 }\n";

struct Collision {
  double energy_error = 0, linear = 0, angular = 0, elastic = 0;
  int touched = 0;
};

/// Oblique, spinning, of different size: the corner of one meets the side of the other.
Collision collide(double step, const std::string& direction) {
  SceneWorld<3> world(
      scene(fmt::format("step = {}", step),
            box("a", {{0, 0, 0}}, {{0.3, 0.2, 0.2}}, "[6, 4, 4]",
                "velocity = [20, 1, 2]\nspin = [\"30 rad/s\", \"10 rad/s\", \"-20 rad/s\"]") +
                box("b", {{0.32, 0.05, 0.04}}, {{0.2, 0.24, 0.2}}, "[4, 5, 4]",
                    "velocity = [-10, -3, 0]\nspin = [\"0 rad/s\", \"40 rad/s\", \"30 rad/s\"]"),
            "friction = 0\ndamping = 0\ndirection = \"" + direction + "\"", kSoft));
  world.simulation.start();
  const MomentumOf<3> start = momentum(world);
  double energy = 0;
  Collision c;
  while (world.time() < 3e-3 && !world.model().stop.raised) {
    const Ledger ledger = world.step_and_book();
    const double now = total_energy(ledger);
    if (energy == 0) energy = now;
    c.touched += ledger.value("CT_stored") > 0 ? 1 : 0;
    c.energy_error = std::max(c.energy_error, std::abs(now / energy - 1));
    c.elastic = std::max(c.elastic, ledger.value("CT_stored") / energy);
    EXPECT_LT(ledger.residual_1(), 1e-12);
  }
  EXPECT_FALSE(world.model().stop.raised) << world.model().stop.cause;
  const MomentumOf<3> end = momentum(world);
  c.linear = norm(end.linear - start.linear) / start.size;
  c.angular = norm(end.angular - start.angular) / (start.size * 0.3);
  return c;
}

// V-037, frictionless and undamped: what the exact gradient loses falls with the step. The smooth one
// trades some for a steady direction where a corner digs into a side.
TEST(ContactInSpace, ObliqueKeepsMomentaAndEnergy) {
  const Collision coarse = collide(4e-6, "conservative"), fine = collide(2e-6, "conservative");
  const Collision smooth = collide(4e-6, "smooth");
  for (const Collision& c : {coarse, fine, smooth}) {
    EXPECT_GT(c.touched, 50);
    EXPECT_GT(c.elastic, 1e-3);
    EXPECT_LT(c.linear, 1e-13);
    EXPECT_LT(c.angular, 1e-12);
  }
  std::printf("energy error %.3g, at half the step %.3g, smooth %.3g\n", coarse.energy_error,
              fine.energy_error, smooth.energy_error);
  EXPECT_LT(coarse.energy_error, 2e-3);
  EXPECT_LT(fine.energy_error, 0.8 * coarse.energy_error);
  EXPECT_LT(smooth.energy_error, 1e-2);
}

/// V-042 with gravity inclined in an arbitrary direction of the plane: a block on a floor that is
/// held as a whole.
class Slope {
 public:
  Slope(double angle, double mu, double heading)
      : world(scene("",
                    box("floor", {{-0.2, -0.2, -0.05}}, {{0.6, 0.6, 0.05}}, "[8, 8, 1]") +
                        box("block", {{0, 0, 0}}, {{0.1, 0.1, 0.05}}, "[3, 3, 2]"),
                    fmt::format("friction = {}\ndamping = 0.1", mu) +
                        "\n[gravity]\nacceleration = [0, 0, 0]\n"
                        "[[boundary]]\nwhere = \"floor\"\nfixed = [0, 0, 0]\n",
                    "density = 2000\ndamping = 1.0\nelastic = { young = 20e6, poisson = 0.2 }\n")),
        down_{{0, 0, -std::cos(angle)}},
        along_{{std::cos(heading), std::sin(heading), 0}},
        sine_(std::sin(angle)) {
    world.simulation.start();
  }

  void run(double until) {
    while (world.time() < until && !world.model().stop.raised) {
      const double into = std::min(1.0, world.time() / 0.03);
      const double push = std::clamp((world.time() - 0.03) / 0.02, 0.0, 1.0);
      world.model().gravity = (down_ * into + along_ * (sine_ * push)) * 9.81;
      world.step(until);
    }
  }
  Vec<3> speed() { return momentum(world, "block").velocity(); }
  Vec<3> place() { return momentum(world, "block").centre; }

  /// Slope of the line through the speeds along the way.
  double acceleration(double from, double to) {
    run(from);
    double n = 0, t1 = 0, t2 = 0, v1 = 0, tv = 0;
    for (double t = from; t < to; t += (to - from) / 200) {
      run(t);
      const double v = dot(speed(), along_), s = world.time() - from;
      n += 1;
      t1 += s;
      t2 += s * s;
      v1 += v;
      tv += s * v;
    }
    return (n * tv - t1 * v1) / (n * t2 - t1 * t1);
  }

  SceneWorld<3> world;
  Vec<3> down_, along_;
  double sine_;
};

constexpr double kDegree = std::numbers::pi / 180;

TEST(ContactInSpace, BlockSlides) {
  for (const double heading : {0.0, 0.7}) {
    Slope slope(30 * kDegree, 0.3, heading);
    const double a = slope.acceleration(0.08, 0.16);
    EXPECT_NEAR(a, 2.356287, 5e-3 * 2.356287) << heading;
    const Vec<3> v = slope.speed();
    EXPECT_LT(std::abs(v[0] * std::sin(heading) - v[1] * std::cos(heading)), 0.005 * norm(v));
  }
}

TEST(ContactInSpace, BlockSticks) {
  Slope slope(30 * kDegree, 0.6, 0.4);
  slope.run(0.12);
  const Vec<3> x = slope.place();
  slope.run(0.17);
  EXPECT_LT(norm(slope.place() - x) / 0.05, 1e-9);
}

// A body wholly inside another and one that overlaps by half an element: what contact reports as
// stored comes out, no more (S-06).
TEST(ContactInSpace, OverlapReleasesItsPotential) {
  for (const double share : {0.5, 2.5}) {
    SceneWorld<3> world(scene("",
                              box("a", {{0, 0, 0}}, {{0.3, 0.3, 0.3}}, "[6, 6, 6]") +
                                  box("b", {{0.08, 0.09, 0.31}}, {{0.1, 0.1, 0.1}}, "[2, 2, 2]"),
                              "friction = 0\ndamping = 0\nstiffness = \"3e8 Pa/m\"", kSoft));
    world.simulation.start();
    const auto x = world.host<NodePosition<3>>();
    for (const Index n : find_region(world.model().mesh, "b")->points)
      x(n, 2) -= 0.01 + share * 0.05;
    world.put<NodePosition<3>>(x);
    const double stored = world.step_and_book().value("CT_stored");
    ASSERT_GT(stored, 0);
    double error = 0;
    Ledger last;
    while (world.time() < 15e-3 && !world.model().stop.raised) {
      last = world.step_and_book();
      error = std::max(error, std::abs(total_energy(last) / stored - 1));
    }
    EXPECT_FALSE(world.model().stop.raised) << world.model().stop.cause;
    std::printf("overlap %.1f: stored %.4g J, energy off by %.3g\n", share, stored, error);
    EXPECT_EQ(last.value("CT_stored"), 0) << share;
    // The smooth direction gives and takes where corners are inside.
    EXPECT_LT(error, share < 1 ? 0.02 : 0.1) << share;
  }
}

// A crack through a bar that opens, closes and presses: the released faces carry it.
TEST(ContactInSpace, CrackThatClosesPresses) {
  const auto half = [](const std::string& name, double at, int v) {
    return fmt::format(
        "[[body]]\nname = \"{0}\"\nmaterial = \"{0}\"\npart_of = \"bar\"\nvelocity = [{2}, 0, 0]\n"
        "shape = {{ box = {{ corner = [{1}, 0, 0], size = [4e-3, 2e-3, 2e-3] }} }}\n"
        "mesh = {{ size = 1e-3 }}\n"
        "[material.{0}]\ndensity = 2650\nelastic = {{ young = 60e9, poisson = 0 }}\n",
        name, at, v);
  };
  SceneWorld<3> world("[run]\ndimension = 3\nduration = 1\n" + half("a", 0, -1) +
                      half("b", 4e-3, 1) +
                      "[[interface]]\nbetween = [\"a\", \"b\"]\ntensile_strength = 8e6\n"
                      "cohesion = 24e6\nfriction_angle = 0.7\nenergy_tension = 1\n"
                      "energy_shear = 10\n[contact]\n");
  world.simulation.start();
  const auto whole = [&] {
    const Counts counts = world.simulation.counts();
    return counts.bonded + counts.inserted;
  };
  ASSERT_GT(whole(), 0);
  for (int i = 0; i < 2000 && whole() > 0; ++i) world.step();
  ASSERT_EQ(whole(), 0);
  const auto v = world.host<NodeVelocity<3>>();
  for (Index n = 0; n < world.model().nodes(); ++n)
    for (int d = 0; d < 3; ++d) v(n, d) *= -3;
  world.put<NodeVelocity<3>>(v);
  double pressed = 0;
  for (int i = 0; i < 3000; ++i) {
    world.step();
    pressed = std::max(pressed, static_cast<double>(world.simulation.counts().contact_points));
    if (i % 100 == 0 && world.model().stop.raised) FAIL() << world.model().stop.cause;
  }
  EXPECT_GT(pressed, 10);
  // They have bounced: the halves leave each other again.
  EXPECT_GT(momentum(world, "b").velocity()[0], 0);
  EXPECT_LT(momentum(world, "a").velocity()[0], 0);
}

}  // namespace
