// Boundaries that let waves out, against d'Alembert's solution in a strip.
#include "harness/scenes.hpp"

#include <gtest/gtest.h>

namespace breccia {
namespace {

constexpr double kLength = 1, kWidth = 0.05;

/// A strip along the direction `along` of its cells; sides roll so that plane P waves (or S waves,
/// which move along y) run as in an endless medium.
struct Strip {
  int dimension = 2;
  bool shear = false;
  int cells = 100;

  std::string text(const std::string& right, const std::string& left) const {
    BlockScene scene;
    scene.dimension = dimension;
    scene.size = dimension == 2 ? fmt::format("[{}, {}]", kLength, kWidth)
                                : fmt::format("[{0}, {1}, {1}]", kLength, kWidth);
    const int across = std::max(1, static_cast<int>(cells * kWidth / kLength / 2));
    scene.cells = dimension == 2 ? fmt::format("[{}, {}]", cells, across)
                                 : fmt::format("[{0}, {1}, {1}]", cells, across);
    scene.poisson = 0.25;
    scene.run = "duration = 1";
    const std::string z = dimension == 2 ? "" : ", \"free\"";
    for (const char* side : {"bottom", "top"})
      scene.more += fmt::format("[[boundary]]\nwhere = \"b.{}\"\nfixed = [{}{}]\n", side,
                                shear ? "0, \"free\"" : "\"free\", 0", z);
    for (const char* side : {"front", "back"})
      if (dimension == 3)
        scene.more += fmt::format("[[boundary]]\nwhere = \"b.{}\"\nfixed = [{}, \"free\", 0]\n",
                                  side, shear ? "0" : "\"free\"");
    scene.more += "[[boundary]]\nwhere = \"b.right\"\n" + right;
    if (!left.empty()) scene.more += "[[boundary]]\nwhere = \"b.left\"\n" + left;
    return scene.text();
  }
};

template <int D>
double speed(const Model<D>& model, bool shear) {
  const Material& m = model.materials[0];
  return std::sqrt((shear ? m.mu() : m.p_wave_modulus(false)) / m.density);
}

/// A smooth pulse of unit velocity that runs to the right: u = -c^-1 integral of v.
struct Pulse {
  double centre, width, c;
  double velocity(double x) const {
    const double s = (x - centre) / width;
    return std::abs(s) < 1 ? std::pow(std::cos(1.5707963267948966 * s), 2) : 0.0;
  }
  /// Integral of the velocity from x to infinity, over c.
  double displacement(double x) const {
    const double s = std::clamp((x - centre) / width, -1.0, 1.0);
    const double pi = 3.141592653589793;
    return width * (0.5 * (1 - s) - std::sin(pi * s) / (2 * pi)) / c;
  }
};

template <int D>
double largest_speed(SceneWorld<D>& world) {
  const auto v = world.template host<NodeVelocity<D>>();
  double most = 0;
  for (Index n = 0; n < world.model().mesh.points(); ++n) most = std::max(most, norm(row<D>(v, n)));
  return most;
}

template <int D>
void check_pulse(bool shear, int cells) {
  Strip strip{D, shear, cells};
  SceneWorld<D> world(strip.text("non_reflecting = true\n", ""));
  world.simulation.start();
  const double c = speed(world.model(), shear);
  const Pulse pulse{0.5, 0.3, c};
  const int axis = shear ? 1 : 0;
  const double size = 1e-4;  // of strains: small
  put_field<NodePosition<D>, D>(world, [&](Vec<D> x) {
    x[axis] += size * pulse.displacement(x[0]) * c;
    return x;
  });
  // Half a kick is still to come; the velocities are those of t = 0.
  put_field<NodeVelocity<D>, D>(world, [&](const Vec<D>& x) {
    Vec<D> v = Vec<D>::zero();
    v[axis] = size * c * pulse.velocity(x[0]);
    return v;
  });
  EXPECT_NEAR(largest_speed(world), size * c, 0.01 * size * c);
  const double kinetic = world.simulation.motion().kinetic_energy(world.model());
  Ledger ledger;
  while (world.time() < 1.0 / c) ledger = world.step_and_book();
  EXPECT_LT(largest_speed(world), 0.01 * size * c);
  EXPECT_NEAR(ledger.value("ABSORBED") / (2 * kinetic), 1, 0.01);
}

TEST(Absorbing, PulsesLeaveThePlane) {
  check_pulse<2>(false, 100);
  check_pulse<2>(true, 100);
}
TEST(Absorbing, PulsesLeaveSpace) {
  check_pulse<3>(false, 60);
  check_pulse<3>(true, 60);
}

/// What comes in through the left moves the inside as it says, and leaves through the right.
template <int D>
void check_input(bool shear) {
  Strip strip{D, shear, 60};
  const double v = 1e-3;
  const std::string input = fmt::format("input = [{}, {}{}]\nramp = 5e-4\n", shear ? 0 : v,
                                        shear ? v : 0, D == 3 ? ", 0" : "");
  SceneWorld<D> world(strip.text("non_reflecting = true\n", "non_reflecting = true\n" + input));
  world.simulation.start();
  const double c = speed(world.model(), shear);
  Ledger ledger;
  while (world.time() < 6e-4 + 1.5 / c) ledger = world.step_and_book();
  const auto velocity = world.template host<NodeVelocity<D>>();
  for (Index n = 0; n < world.model().mesh.points(); ++n)
    EXPECT_NEAR(velocity(n, shear ? 1 : 0), v, 0.01 * v) << n;
  EXPECT_LT(ledger.residual_1(), 1e-12);
  EXPECT_LT(ledger.residual_2(), 0.01);
}

TEST(Absorbing, InputMovesTheInsideAsItSays) {
  check_input<2>(false);
  check_input<2>(true);
  check_input<3>(false);
}

}  // namespace
}  // namespace breccia
