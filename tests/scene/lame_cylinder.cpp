// V-015 and V-016: Lame's thick cylinder under pressure inside.
#include "scene/static_bodies.hpp"

#include <numbers>

namespace breccia {
namespace {

/// A quarter of the ring from radius 1 to 2 m.
Point<2> ring(double s, double t) {
  const double angle = 0.5 * std::numbers::pi * t;
  return {(1 + s) * std::cos(angle), (1 + s) * std::sin(angle)};
}

struct Ring {
  Ring(const std::string& element, int segments, double poisson)
      : body(scene(poisson), element, segments, segments / 2, ring) {
    body.settle();
    // In units of the pressure, for E = 1000.
    inner = body.displacement({{1, 0}})[0] * 100;
    outer = body.displacement({{2, 0}})[0] * 100;
    index = body.checkerboard();
    for (const double p : body.pressures()) {
      const double off = std::abs(p * 100 / (-(1 + poisson) * 2 / 9) - 1);
      worst = std::max(worst, off);
    }
    std::printf(
        "%-6s %2d segments, nu %.4f: inner %.6e outer %.6e, checkerboard %.4f, worst pressure "
        "%.4f, %lld steps\n",
        element.c_str(), segments, poisson, inner, outer, index, worst,
        static_cast<long long>(body.world->simulation.clock().step));
  }

  static BlockScene scene(double poisson) {
    BlockScene s;
    s.young = 1000;
    s.poisson = poisson;
    s.run = "duration = 1e4\nrest = { method = \"local\", tolerance = 3e-4 }";
    s.more =
        "[[boundary]]\nwhere = \"b.left\"\npressure = 0.01\n"
        "[[boundary]]\nwhere = \"b.bottom\"\nfixed = [\"free\", 0]\n"
        "[[boundary]]\nwhere = \"b.top\"\nfixed = [0, \"free\"]\n";
    return s;
  }

  StaticBody body;
  double inner, outer, index, worst = 0;
};

// V-015; half of its elements through the wall, four times its tolerance.
TEST(Lame, CompressibleRing) {
  const Ring ring("tri6c", 16, 0.3);
  EXPECT_NEAR(ring.inner, 1.906667e-3, 0.02 * 1.906667e-3);
  EXPECT_NEAR(ring.outer, 1.213333e-3, 0.02 * 1.213333e-3);
}

// Sixteen composites through the wall: displacements to 1 %, and the pressure, which is the same
// everywhere, wherever one looks.
TEST(LameSlow, NearlyIncompressibleRing) {
  const Ring ring("tri6c", 32, 0.4999);
  EXPECT_NEAR(ring.inner, 1.999967e-3, 0.01 * 1.999967e-3);
  EXPECT_LT(ring.index, 0.05);
  EXPECT_LT(ring.worst, 0.06);
}

}  // namespace
}  // namespace breccia
