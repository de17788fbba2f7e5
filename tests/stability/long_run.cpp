// V-010: a free block, shaken at random, keeps its energy and its momenta for as long as it runs.
#include "harness/tensors.hpp"
#include "harness/waves.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace breccia {
namespace {

template <int D>
using Spin = std::conditional_t<D == 2, double, Vec<3>>;

inline double size_of(double spin) {
  return std::abs(spin);
}
inline double size_of(const Vec<3>& spin) {
  return norm(spin);
}

template <int D>
struct Momenta {
  Vec<D> linear = Vec<D>::zero();
  Spin<D> angular{};
  double linear_sum = 0, angular_sum = 0;  ///< of the sizes, as the scale of round-off
};

/// With positions at t^(n+1) and velocities at t^(n+1/2) the scheme keeps both exactly.
template <int D>
Momenta<D> momenta(SceneWorld<D>& world) {
  const auto x = world.template host<NodePosition<D>>();
  const auto v = world.template host<NodeVelocity<D>>();
  const auto mass = world.template host<NodeMass>();
  Momenta<D> m;
  if constexpr (D == 3) m.angular = Vec<3>::zero();
  for (Index n = 0; n < world.model().nodes(); ++n) {
    const Vec<D> p = row<D>(v, n) * mass(n);
    m.linear += p;
    m.angular += cross(row<D>(x, n), p);
    m.linear_sum += norm(p);
    m.angular_sum += norm(row<D>(x, n)) * norm(p);
  }
  return m;
}

/// Slope of a straight line through energies at equal intervals, times the whole time.
double secular_change(const std::vector<double>& energy) {
  const auto n = static_cast<double>(energy.size());
  double covariance = 0, variance = 0, mean = 0;
  for (const double e : energy) mean += e / n;
  for (std::size_t i = 0; i < energy.size(); ++i) {
    const double t = (static_cast<double>(i) + 0.5) / n - 0.5;
    covariance += t * (energy[i] - mean);
    variance += t * t;
  }
  return covariance / variance;
}

template <int D>
void check_long_run(BlockScene scene, double speed, int steps, int interval, double allowed_slope) {
  scene.run = "duration = 1e9\nstep_factor = 0.8";
  scene.jitter = 0.2;
  SceneWorld<D> world(scene.text());
  world.simulation.start();
  const Random random{31, D};
  std::uint64_t node = 0;
  put_field<NodeVelocity<D>, D>(world, [&](const Vec<D>&) {
    Vec<D> v;
    for (int d = 0; d < D; ++d) v[d] = speed * random.normal(node, static_cast<std::uint32_t>(d));
    ++node;
    return v;
  });
  world.step();
  const Momenta<D> start = momenta(world);
  std::vector<double> energy;
  for (int i = 0; i < steps; i += interval) {
    world.steps(interval - 1);
    const Ledger ledger = world.step_and_book();
    energy.push_back(ledger.kinetic + ledger.stored());
  }
  const Momenta<D> end = momenta(world);
  EXPECT_LT(norm(end.linear - start.linear), 1e-12 * start.linear_sum);
  EXPECT_LT(size_of(end.angular - start.angular), 1e-10 * start.angular_sum);
  double least = energy[0], most = energy[0];
  for (const double e : energy) {
    least = std::min(least, e);
    most = std::max(most, e);
  }
  const double slope = secular_change(energy) / energy[0];
  std::printf("%dD, %d steps: drift %.2e, ripple %.2e of the energy\n", D, steps, slope,
              (most - least) / energy[0]);
  EXPECT_LT(std::abs(slope), allowed_slope);
  // The ripple is that of a linear body, none, plus the strain in size: that of neighbours, whose
  // random velocities differ by three sigmas now and then, is some ten times speed over 1000 m/s.
  EXPECT_LT((most - least) / energy[0], 1e-2 * speed);
}

const BlockScene kPlane{2, "[1, 1]", "[3, 3]"};
const BlockScene kSpace{3, "[1, 1, 1]", "[2, 2, 2]"};

// A line through a ripple has a slope of about that ripple even where there is none: strains of
// 1e-6 ripple by less than 1e-5 and let a slope of 1e-6 be seen, strains of 1e-3 do not.
TEST(LongRun, PlaneKeepsEnergyAndMomenta) {
  check_long_run<2>(kPlane, 1e-4, 20000, 10, 1e-6);
  check_long_run<2>(kPlane, 1, 10000, 10, 1e-3);
}
TEST(LongRun, SpaceKeepsEnergyAndMomenta) {
  check_long_run<3>(kSpace, 1e-4, 10000, 10, 1e-6);
  check_long_run<3>(kSpace, 1, 5000, 10, 1e-3);
}
TEST(LongRunSlow, PlaneKeepsEnergyForAMillionSteps) {
  check_long_run<2>(kPlane, 1e-4, 1000000, 20, 1e-6);
}
TEST(LongRunSlow, SpaceKeepsEnergyForAMillionSteps) {
  check_long_run<3>(kSpace, 1e-4, 1000000, 20, 1e-6);
}

}  // namespace
}  // namespace breccia
