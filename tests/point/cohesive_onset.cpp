#include "point/cohesive_onset.hpp"

#include "base/mat.hpp"
#include "point/stress_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace breccia {
namespace {

constexpr double kMu = 1.19;
const CohesiveOnset kOnset{8e6, 24e6, kMu, 0.95, false};
const CohesiveOnset kElliptic{8e6, 24e6, kMu, 0.95, true};

double measure(const CohesiveOnset& onset, double t_n, double t_s) {
  return onset.measure<2>({{t_n, t_s}}, {{1, 0}});
}

TEST(CohesiveOnset, CutOffAndFriction) {
  EXPECT_NEAR(measure(kOnset, 8e6, 0), 1, 1e-15);
  EXPECT_NEAR(measure(kOnset, 0, 24e6), 1, 1e-15);
  EXPECT_NEAR(measure(kOnset, -10e6, 24e6 + kMu * 10e6), 1, 1e-15);
  EXPECT_NEAR(measure(kElliptic, 8e6, 0), 1, 1e-15);
  EXPECT_NEAR(measure(kElliptic, -10e6, 24e6 + kMu * 10e6), 1, 1e-15);
  EXPECT_NEAR(measure(kElliptic, 4e6, 0.6 * (24e6 - kMu * 4e6)), std::hypot(0.5, 0.6), 1e-15);
  EXPECT_LT(measure(kOnset, -50e6, 10e6), 0);
}

TEST(CohesiveOnset, MeasureIsContinuousThroughZeroNormalTraction) {
  for (const double t_s : {1e6, 10e6, 24e6})
    for (const auto& onset : {kOnset, kElliptic})
      EXPECT_NEAR(measure(onset, 1e-3, t_s), measure(onset, -1e-3, t_s), 1e-9);
}

// eq:cohesive-22
TEST(CohesiveOnset, StrengthGrowsWithTheRateToItsLimit) {
  CohesiveOnset onset = kOnset;
  EXPECT_EQ(onset.dynamic_share(1e6), 1);
  onset.rate_reference = 10;
  onset.rate_exponent = 1.0 / 3;
  onset.rate_limit = 3;
  EXPECT_EQ(onset.dynamic_share(0), 1);
  EXPECT_EQ(onset.dynamic_share(9.9), 1);
  EXPECT_NEAR(onset.dynamic_share(80), 2, 1e-15);
  EXPECT_EQ(onset.dynamic_share(1e6), 3);
  EXPECT_NEAR(measure(onset.scaled(2), 16e6, 0), 1, 1e-15);
  EXPECT_NEAR(measure(onset.scaled(2), -10e6, 48e6 + kMu * 10e6), 1, 1e-15);
}

// The prefilter of the element loop must never miss a plane.
template <int D>
void check_watch(const CohesiveOnset& onset, const StressWatch<D>& watch, bool tight) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> gauss;
  int hot = 0, needless = 0;
  for (int i = 0; i < 4000; ++i) {
    Sym<D> sigma;
    for (double& s : sigma.s) s = 1e7 * gauss(random);
    for (int d = 0; d < D; ++d) sigma.s[d] -= 1e7 * (i % 3);
    double worst = -1e30;
    for (int k = 0; k < 400; ++k) {
      Vec<D> n;
      for (int d = 0; d < D; ++d) n[d] = gauss(random);
      n *= 1 / norm(n);
      worst = std::max(worst, onset.measure<D>(sigma * n, n) / onset.alpha);
    }
    const bool near = watch.room(sigma, 1.0) <= 0;
    if (worst >= 1) {
      ASSERT_TRUE(near);
    }
    hot += near ? 1 : 0;
    needless += near && worst < 0.99 ? 1 : 0;
  }
  EXPECT_GT(hot, 100);
  if (tight) {
    EXPECT_EQ(needless, 0);
  }
}

TEST(CohesiveOnset, WatchNeverMissesAPlane) {
  const double tension = 1 / (0.95 * 8e6), cohesion = 1 / (0.95 * 24e6);
  check_watch<2>(kOnset, {tension, cohesion, kMu}, true);
  check_watch<3>(kOnset, {tension, cohesion, kMu}, false);
  // Elliptic: both shares at 1/sqrt(2), friction at alpha (modules/fracture/fracture_laws.cpp).
  const double share = 0.95 / std::sqrt(2.0);
  check_watch<2>(kElliptic, {1 / (share * 8e6), 1 / (share * 24e6), 0.95 * kMu}, false);
  check_watch<3>(kElliptic, {1 / (share * 8e6), 1 / (share * 24e6), 0.95 * kMu}, false);
}

}  // namespace
}  // namespace breccia
