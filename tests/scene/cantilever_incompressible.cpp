// V-013 and V-016: Timoshenko and Goodier's cantilever with a parabolic load at its end.
#include "scene/static_bodies.hpp"

namespace breccia {
namespace {

constexpr double kLength = 10, kDepth = 2, kLoad = -1000, kYoung = 1e7;
constexpr double kInertia = kDepth * kDepth * kDepth / 12;

/// Theory of Elasticity, article 21, for plane strain; x from the held end, y from the axis.
Vec<2> exact(const Vec<2>& at, double poisson) {
  const double x = at[0], y = at[1];
  const double young = kYoung / (1 - poisson * poisson), nu = poisson / (1 - poisson);
  const double k = kLoad / (6 * young * kInertia), depth2 = kDepth * kDepth / 4;
  return {{-k * y * ((6 * kLength - 3 * x) * x + (2 + nu) * (y * y - depth2)),
           k * (3 * nu * y * y * (kLength - x) + (4 + 5 * nu) * depth2 * x +
                (3 * kLength - x) * x * x)}};
}

/// Exact tractions on one of the ends, as means over its segments.
std::string end_load(double x, int segments) {
  std::string text;
  const double size = kDepth / segments, near = 1e-3 * size, side = x > 0 ? 1 : -1;
  for (int i = 0; i < segments; ++i) {
    const double lower = -kDepth / 2 + i * size, upper = lower + size;
    const auto integral = [](double y) { return kDepth * kDepth / 4 * y - y * y * y / 3; };
    const double shear = kLoad / (2 * kInertia) * (integral(upper) - integral(lower)) / size;
    const double bending = -kLoad * (kLength - x) / kInertia * 0.5 * (lower + upper);
    text += fmt::format(
        "[[boundary]]\nbox = {{ lower = [{:.17g}, {:.17g}], upper = [{:.17g}, {:.17g}] }}\n"
        "traction = [{:.17g}, {:.17g}]\n",
        x - near, lower - near, x + near, upper + near, side * bending, side * shear);
  }
  return text;
}

/// Holds what the exact solution leaves in its place at (0, y).
std::string hold(double y, const std::string& components) {
  return fmt::format(
      "[[boundary]]\nbox = {{ lower = [-1e-3, {0:.17g}], upper = [1e-3, {1:.17g}] }}\n"
      "fixed = {2}\n",
      y - 1e-3, y + 1e-3, components);
}

struct Tip {
  double deflection, index;
};

/// Deflection of the tip in shares of the exact one.
Tip tip(const std::string& element, int segments, double poisson) {
  BlockScene scene;
  scene.young = kYoung;
  scene.poisson = poisson;
  scene.run = "duration = 1e4\nrest = { method = \"local\", tolerance = 3e-4 }";
  scene.more = end_load(0, segments) + end_load(kLength, segments) + hold(0, "[0, 0]") +
               hold(-1, "[0, \"free\"]") + hold(1, "[0, \"free\"]");
  StaticBody beam(scene, element, 5 * segments, segments, [](double s, double t) {
    return Point<2>{kLength * s, kDepth * (t - 0.5)};
  });
  beam.settle();
  const Vec<2> end = {{kLength, 0}};
  const Tip out{beam.displacement(end)[1] / exact(end, poisson)[1], beam.checkerboard()};
  std::printf("%-6s %2d segments, nu %.4f: tip %.4f, checkerboard %.4f, %lld steps\n",
              element.c_str(), segments, poisson, out.deflection, out.index,
              static_cast<long long>(beam.world->simulation.clock().step));
  return out;
}

TEST(Timoshenko, ExactSolutionIsThatOfTheCatalogue) {
  EXPECT_NEAR(exact({{kLength, 0}}, 0.3)[1], -0.0468975, 5e-8);
  EXPECT_NEAR(exact({{kLength, 0}}, 0.4999)[1], -0.0391923, 5e-8);
}

// Four composites through the depth, 2 % (V-013).
TEST(Timoshenko, CompositesBend) {
  EXPECT_NEAR(tip("tri6c", 8, 0.3).deflection, 1, 0.02);
}

// Triangles with the same nodes are more than 40 % too stiff, and their pressure is a checkerboard.
TEST(TimoshenkoSlow, CompositesDoNotLock) {
  const Tip composites = tip("tri6c", 8, 0.4999), triangles = tip("tri3", 8, 0.4999);
  EXPECT_NEAR(composites.deflection, 1, 0.02);
  EXPECT_LT(triangles.deflection, 0.6);
  EXPECT_GT(triangles.index, 1.9);
  EXPECT_LT(composites.index, 0.3);
}

}  // namespace
}  // namespace breccia
