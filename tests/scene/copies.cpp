// Copies of a body: each with its own spin and its own way to a place.
#include "harness/simulation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace breccia;

TEST(Copies, FlyAndSpinEachByItself) {
  SceneWorld<3> world(R"(
[run]
dimension = 3
duration = 1
[[body]]
name = "cube"
material = "m"
spin = [0, 0, "7 rad/s"]
shape = { box = { corner = [-3, -3, -0.5], size = [1, 1, 1] } }
mesh = { generator = "structured", size = 0.5 }
towards = { place = [0, 0, 0], speed = 2 }
copies = { count = [3, 3, 1], pitch = [2.5, 2.5, 0], hollow = [1, 1, 1], turned = true }
[material.m]
density = 1000
elastic = { young = 1e9, poisson = 0.2 }
)");
  world.simulation.start();
  const auto x = world.host<NodePosition<3>>();
  const auto v = world.host<NodeVelocity<3>>();
  const auto m = world.host<NodeMass>();
  const Index nodes = world.model().nodes(), each = nodes / 8;
  ASSERT_EQ(nodes, 8 * 27);
  double mass = 0;
  for (Index c = 0; c < 8; ++c) {
    // Copies of one body of 27 nodes; reordered, so they are told by their site.
    const Index site = c < 4 ? c : c + 1;
    const Vec<3> at{{-2.5 + 2.5 * static_cast<double>(site / 3),
                     -2.5 + 2.5 * static_cast<double>(site % 3), 0}};
    Vec<3> momentum = Vec<3>::zero(), spin = Vec<3>::zero();
    double own = 0, inertia = 0;
    Index found = 0;
    for (Index n = 0; n < nodes; ++n) {
      const Vec<3> arm = row<3>(x, n) - at;
      if (norm(arm) > 1) continue;
      ++found;
      own += m(n);
      momentum += row<3>(v, n) * m(n);
      spin += cross(arm, row<3>(v, n)) * m(n);
      inertia += m(n) * (arm[0] * arm[0] + arm[1] * arm[1]);
    }
    EXPECT_EQ(found, each);
    EXPECT_NEAR(norm(momentum * (1 / own) + at * (2 / norm(at))), 0, 1e-12);
    EXPECT_NEAR(spin[2], 7 * inertia, 1e-9 * inertia);
    mass += own;
  }
  EXPECT_NEAR(mass, 8000, 1e-9 * mass);
}

}  // namespace
