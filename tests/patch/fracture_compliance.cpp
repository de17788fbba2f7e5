// V-062: springs that are there from the start make a solid softer, by a closed form; those that
// come at the strength do not.
#include "harness/fracture_world.hpp"
#include "mesh/geometry.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace breccia {
namespace {

constexpr double kLength = 10e-3, kHeight = 1e-3, kYoung = 60e9;
constexpr int kStripes = 8;

/// A bar of stripes that only interfaces across it part.
void give_stripes(Model<2>& model) {
  for (Index e = 0; e < model.elements(); ++e) {
    const double x = centroid<2>(corners(model.mesh, e))[0];
    if (model.mesh.body[e] == 0) model.mesh.body[e] = static_cast<int>(x * kStripes / kLength) % 2;
  }
  for (Material& material : model.materials) material.poisson = 0;
}

struct Stiffness {
  double ratio;       ///< of the bar to that of its material
  double reciprocal;  ///< spring over bulk stiffness of a stripe, k_n L / E
  std::int64_t inserted;
};

/// Pulled slowly by 1e-4, over a hundred times the way of a wave.
Stiffness pull(double alpha, double factor) {
  const std::string law = fmt::format(
      "[[interface]]\nbetween = [\"rock\", \"other\"]\ntensile_strength = 8e6\ncohesion = 24e6\n"
      "friction_angle = 0.8\nenergy_tension = 50\nenergy_shear = 500\nalpha = {}\n"
      "stiffness_factor = {}\n",
      alpha, factor);
  const std::string pulled =
      "velocity = [{}5e-3, \"free\"]\ntable = [[0, 0], [100e-6, 1], [200e-6, 0]]\n";
  const auto end = [&](const char* side, const char* sign) {
    std::string text = pulled;
    text.replace(text.find("{}"), 2, sign);
    return fmt::format("[[boundary]]\nwhere = \"block.{}\"\n{}", side, text);
  };
  FractureWorld<2> world(
      block_scene(2, "cross", "[40, 4]", "[10e-3, 1e-3]", law, end("left", "-") + end("right", "")),
      give_stripes);
  world.start();
  while (world.clock.time < 210e-6) world.step();
  Counts counts;
  world.fracture.count(world.model, counts);
  const auto x = world.host<NodePosition<2>>();
  double low = 1, high = 0;
  for (Index n = 0; n < world.model.nodes(); ++n) {
    if (x(n, 0) > 0.5) continue;
    low = std::min(low, x(n, 0));
    high = std::max(high, x(n, 0));
  }
  const auto force = world.host<ElementForce<2>>();
  const auto nodes = world.host<ElementNodes<2>>();
  double pull = 0;  // of the elements on the nodes of the right end
  for (Index e = 0; e < world.model.elements(); ++e)
    for (int a = 0; a < 3; ++a)
      if (std::abs(x(nodes(e, a), 0) - high) < 1e-9) pull += std::abs(force(e, a, 0));
  const double strain = (high - low) / kLength - 1;
  // h_f of a triangle that reaches the face from the middle of its cell: a quarter of the cell.
  const double springs = factor * kYoung / (kLength / 40 / 4);
  return {pull / kHeight / (kYoung * strain), springs * (kLength / (kStripes - 1)) / kYoung,
          counts.inserted};
}

TEST(FractureCompliance, IntrinsicBarIsSofterByTheClosedForm) {
  for (const double factor : {2.0, 5.0, 20.0}) {
    const Stiffness bar = pull(0, factor);
    EXPECT_EQ(bar.inserted, (kStripes - 1) * 4);
    EXPECT_NEAR(bar.ratio, 1 / (1 + 1 / bar.reciprocal), 1e-3) << factor;
  }
}

TEST(FractureCompliance, ExtrinsicBarIsAsStiffAsItsMaterial) {
  for (const double alpha : {0.8, 1.0}) {
    const Stiffness bar = pull(alpha, 5);
    EXPECT_EQ(bar.inserted, 0);
    EXPECT_NEAR(bar.ratio, 1, 1e-3) << alpha;
  }
}

}  // namespace
}  // namespace breccia
