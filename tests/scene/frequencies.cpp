// V-012: frequencies of a free bar and of a cantilever.
#include "harness/scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace breccia {
namespace {

/// Nodal velocity of a mode of vibration.
using Mode = VectorField<2>;

/// Frequency of a mode from the moment a quarter of its period after a start at rest positions: the
/// projection of the momenta on it changes its sign.
double frequency(const BlockScene& scene, const Mode& mode, double most) {
  SceneWorld<2> world(scene.text());
  world.simulation.start();
  put_field<NodeVelocity<2>, 2>(world, mode);
  const auto start = world.host<NodeReference<2>>();
  const auto m = world.host<NodeMass>();
  const auto projection = [&] {
    const auto v = world.host<NodeVelocity<2>>();
    double sum = 0;
    for (Index n = 0; n < world.model().nodes(); ++n)
      sum += m(n) * dot(row<2>(v, n), mode(row<2>(start, n)));
    return sum;
  };
  double before = projection(), time = 0;
  while (world.time() < most) {
    world.step();
    const double now = projection(), middle = world.time() - 0.5 * world.simulation.clock().dt;
    if (now < 0) return 1 / (4 * (time + (middle - time) * before / (before - now)));
    before = now;
    time = middle;
  }
  ADD_FAILURE() << "the mode does not turn";
  return 0;
}

TEST(Frequencies, FreeBar) {
  BlockScene bar{2, "[1, 0.02]", "[100, 2]"};
  bar.plane = "stress";
  bar.poisson = 0;
  bar.density = 8000;
  bar.young = 2e11;  // 5000 m/s
  const double f = frequency(
      bar,
      [](const Vec<2>& x) {
        return Vec<2>{{1e-3 * std::cos(std::numbers::pi * x[0]), 0}};
      },
      1e-3);
  EXPECT_NEAR(f, 2500, 2500 * 2e-4);
}

/// First bending mode of Euler and Bernoulli's cantilever; sections stay upright to its axis.
Vec<2> bending(const Vec<2>& x) {
  constexpr double length = 2, root = 1.8751040687, sigma = 0.7340955138;
  const double z = root * x[0] / length;
  const double w = std::cosh(z) - std::cos(z) - sigma * (std::sinh(z) - std::sin(z));
  const double slope =
      root / length * (std::sinh(z) + std::sin(z) - sigma * (std::cosh(z) - std::cos(z)));
  return {{-1e-3 * slope * (x[1] - 0.05), 1e-3 * w}};
}

double cantilever(int rows, const std::string& element = "") {
  BlockScene beam{2, "[2, 0.1]", fmt::format("[{}, {}]", 20 * rows, rows)};
  beam.element = element;
  beam.plane = "stress";
  beam.poisson = 0.3;
  beam.density = 7800;
  beam.young = 210e9;
  beam.more = "[[boundary]]\nwhere = \"b.left\"\nfixed = [0, 0]\n";
  return frequency(beam, bending, 20e-3);
}

// 1.8751^2 / (2 pi L^2) sqrt(E h^2 / (12 rho)), less than 1 % lower by shear (V-012); linear triangles
// are too stiff in bending, by an error of second order.
TEST(Frequencies, Cantilever) {
  const double coarse = cantilever(2), middle = cantilever(4), fine = cantilever(8);
  EXPECT_NEAR(fine, 20.955, 0.03 * 20.955);
  EXPECT_GT(middle, fine);
  const double order = std::log2((coarse - middle) / (middle - fine));
  EXPECT_GT(order, 1.8);
  const double limit = fine - (middle - fine) / 3;
  EXPECT_GT(limit, 0.99 * 20.955);
  EXPECT_LT(limit, 20.955);
  std::printf("%.4f, %.4f, %.4f Hz; order %.2f, limit %.4f Hz\n", coarse, middle, fine, order,
              limit);
}

// Four rows of cells of composites, as many sub-elements as triangles in eight: 0.7 % (V-012).
TEST(Frequencies, CantileverOfComposites) {
  EXPECT_NEAR(cantilever(4, "tri6c"), 20.93, 0.007 * 20.93);  // what triangles converge to
}

}  // namespace
}  // namespace breccia
