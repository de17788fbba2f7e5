// Order in the length of the step, on a fixed mesh: large motion with gravity, driven and loaded
// sides; compared among themselves.
#include "harness/waves.hpp"

#include <gtest/gtest.h>

namespace breccia {
namespace {

const char* kLoads = R"(
[gravity]
acceleration = [0, -2e4]
[[boundary]]
where = "b.left"
velocity = ["20 m/s", 0]
ramp = "2 ms"
[[boundary]]
where = "b.right"
traction = [0, "20 MPa"]
ramp = "3 ms"
[[boundary]]
where = "b.top"
pressure = "10 MPa"
ramp = "2.5 ms"
)";

struct Result {
  std::vector<Vec<2>> u;
  double ripple = 0;  ///< largest imbalance of kinetic and stored energy and work, J
};

/// Strains of some percent: E = 1 GPa, rho = 1000 kg/m3, velocities of 20 m/s.
Result run(double dt, int steps, double damping) {
  BlockScene scene;
  scene.damping = damping;
  scene.jitter = 0.2;
  scene.run = fmt::format("duration = 1\nstep = {:.17g}", dt);
  scene.more = kLoads;
  SceneWorld<2> world(scene.text());
  world.simulation.start();
  Result result;
  for (int i = 0; i < steps; ++i) {
    const Ledger l = world.step_and_book();
    const double balance = l.kinetic + l.stored() - l.external();
    result.ripple = std::max(result.ripple, std::abs(balance));
  }
  result.u = displacements(world);
  return result;
}

double distance(const Result& a, const Result& b) {
  double sum = 0;
  for (std::size_t n = 0; n < a.u.size(); ++n) sum += norm2(a.u[n] - b.u[n]);
  return std::sqrt(sum);
}

/// The results after the same time with 1, 1/2, 1/4 and 1/8 of the longest step.
std::vector<Result> ladder(double damping) {
  std::vector<Result> results;
  const double longest = 3e-5;
  for (int level = 0; level < 4; ++level)
    results.push_back(run(longest / (1 << level), 80 << level, damping));
  return results;
}

TEST(OrderTime, MotionIsOfSecondOrder) {
  const auto r = ladder(0);
  const double coarse = distance(r[0], r[1]), middle = distance(r[1], r[2]),
               fine = distance(r[2], r[3]);
  std::printf("differences %.3e %.3e %.3e, orders %.2f %.2f\n", coarse, middle, fine,
              slope(coarse, middle, 2), slope(middle, fine, 2));
  EXPECT_NEAR(slope(coarse, middle, 2), 2, 0.1);
  EXPECT_NEAR(slope(middle, fine, 2), 2, 0.1);
}

// V-010 (c): the energy of the leapfrog ripples with the square of the step.
TEST(OrderTime, RippleOfEnergyIsOfSecondOrder) {
  const auto r = ladder(0);
  std::printf("ripples %.3e %.3e %.3e %.3e J\n", r[0].ripple, r[1].ripple, r[2].ripple,
              r[3].ripple);
  EXPECT_NEAR(slope(r[1].ripple, r[2].ripple, 2), 2, 0.1);
  EXPECT_NEAR(slope(r[2].ripple, r[3].ripple, 2), 2, 0.1);
}

// Damping takes the velocities of half a step ago: it is of first order, and the manual says so.
TEST(OrderTime, DampedMotionIsOfFirstOrder) {
  const auto r = ladder(0.2);
  const double middle = distance(r[1], r[2]), fine = distance(r[2], r[3]);
  std::printf("differences %.3e %.3e, order %.2f\n", middle, fine, slope(middle, fine, 2));
  EXPECT_GT(slope(middle, fine, 2), 0.9);
}

}  // namespace
}  // namespace breccia
