// Pieces that fly clear of all others need no search, and are not missed when they arrive.
#include "contact_samples.hpp"
#include "step/observation.hpp"

#include <gtest/gtest.h>

#include <cstdio>

namespace {

using namespace breccia;

constexpr const char* kRock =
    "density = 2650\ndamping = 0.05\nelastic = { young = 20e9, poisson = 0.25 }\n";

/// A block that slides over a floor, and a fragment above it.
SceneWorld<2> sliding(const std::string& speed_of_fragment) {
  return SceneWorld<2>(contact_scene(
      {{"floor", "[0, -0.05]", "[0.4, 0.05]", "[20, 3]"},
       {"block", "[0.1, 0]", "[0.2, 0.05]", "[10, 3]", "[10, 0]"},
       {"fragment", "[0.195, 0.06]", "[0.01, 0.01]", "[2, 2]", "[0, " + speed_of_fragment + "]"}},
      kRock, "friction = 0.3", "step = 2e-7",
      "[gravity]\nacceleration = [0, -9.81]\n"
      "[[boundary]]\nwhere = \"floor.bottom\"\nfixed = [0, 0]\n"));
}

// Whether the fragment waits or flies changes no bit of what the others do, though lists are made
// at other times.
TEST(ContactFlyers, FragmentFarAwayChangesNoBit) {
  SceneWorld<2> waits = sliding("0"), flies = sliding("2000");
  waits.simulation.start();
  flies.simulation.start();
  waits.steps(1000);
  flies.steps(1000);
  const auto x = waits.host<NodePosition<2>>(), y = flies.host<NodePosition<2>>();
  const auto v = waits.host<NodeVelocity<2>>(), w = flies.host<NodeVelocity<2>>();
  for (const char* body : {"floor", "block"})
    for (const Index n : find_region(waits.model().mesh, body)->points)
      for (int d = 0; d < 2; ++d) {
        ASSERT_EQ(x(n, d), y(n, d)) << n;
        ASSERT_EQ(v(n, d), w(n, d)) << n;
      }
  EXPECT_NEAR(momentum(flies, "fragment").centre[1], 0.065 + 2000 * flies.time(), 1e-3);
}

/// Points that press now.
Index pressing(SceneWorld<2>& world) {
  Counts counts;
  for (const auto& m : world.simulation.modules()) m->count(world.model(), counts);
  return counts.contact_points;
}

// S-08: a grain of 1 mm meets a plate of 0.5 mm at 10 km/s, after it has flown 40 times its size.
// It is seen in the step in which it arrives; so is one that comes back from beside.
TEST(ContactFlyers, GrainIsSeenWhenItArrives) {
  const double gap = 0.04, speed = 1e4;
  for (const bool spinning : {false, true}) {
    Slab grain{"grain", "[0.0095, 0.0005]", "[1e-3, 1e-3]", "[2, 2]", "[0, -1e4]"};
    if (spinning) grain.spin = "1000";
    SceneWorld<2> world(
        contact_scene({{"plate", "[0, -0.0405]", "[0.02, 0.0005]", "[40, 1]"}, grain}, kRock,
                      "friction = 0\npoints = \"corners\""));
    world.simulation.start();
    const double arrival = (gap + 0.0005) / speed;
    while (world.time() < 0.9 * arrival) {
      world.step();
      ASSERT_EQ(pressing(world), 0);
    }
    while (pressing(world) == 0 && world.time() < 1.2 * arrival) world.step();
    ASSERT_FALSE(world.model().stop.raised) << world.model().stop.cause;
    const double dt = world.simulation.clock().dt_before;
    std::printf("seen %.2f steps after it arrived\n", (world.time() - arrival) / dt);
    if (!spinning) {
      EXPECT_GT(world.time(), arrival);
      EXPECT_LT(world.time(), arrival + 2.01 * dt);
    } else {
      EXPECT_LT(world.time(), arrival + 2.01 * dt);
    }
  }
}

}  // namespace
