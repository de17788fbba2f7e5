#include "point/friction_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace breccia;

FrictionLaw weakening() {
  return {FrictionKind::slip_weakening, 0.6, 0.4, 0.01, 0, 0, 0, 0};
}

FrictionLaw rate_and_state(FrictionKind kind) {
  return {kind, 0.6, 0.6, 10e-6, 1e-6, 0.010, 0.015, 10};
}

// eq:friction-1, 2, 3 at rest, at the scale of the law, and far beyond.
TEST(FrictionLaw, WeakensBetweenItsTwoCoefficients) {
  FrictionLaw law{FrictionKind::static_dynamic, 0.6, 0.4, 0, 0.1, 0, 0, 0};
  EXPECT_DOUBLE_EQ(law.coefficient(0, 0, 0), 0.6);
  EXPECT_NEAR(law.coefficient(0, 0.1, 0), 0.4 + 0.2 / std::exp(1.0), 1e-15);
  EXPECT_NEAR(law.coefficient(0, 100, 0), 0.4, 1e-15);
  law.kind = FrictionKind::velocity_weakening;
  EXPECT_DOUBLE_EQ(law.coefficient(0, 0, 0), 0.6);
  EXPECT_NEAR(law.coefficient(0, 0.1, 0), 0.5, 1e-15);
  law = weakening();
  EXPECT_DOUBLE_EQ(law.coefficient(0, 0, 0), 0.6);
  EXPECT_DOUBLE_EQ(law.coefficient(0.005, 0, 0), 0.5);
  EXPECT_DOUBLE_EQ(law.coefficient(1, 0, 0), 0.4);
}

// eq:friction-7: the slip of a step leaves the spring at mu of the slip it ends with.
TEST(FrictionLaw, SlipWeakeningIsImplicit) {
  const FrictionLaw law = weakening();
  const double k = 1e6, n = 1000;
  for (const double trial : {700.0, 5000.0, 9000.0, 20000.0}) {
    const Slide s = slide_of(law, trial, n, k, 1, 0, {});
    EXPECT_NEAR(trial - k * s.slipped, n * law.coefficient(s.slipped, 0, 0), 1e-9 * trial);
  }
  EXPECT_EQ(slide_of(law, 599, n, k, 1, 0, {}).slipped, 0);
}

// eq:friction-4 far from rest is mu_0 + a ln(V/V_0) + b ln(V_0 theta/L); in steady state
// theta = L/V, so that mu changes by (a - b) ln 10 per decade of speed. eq:friction-5 and 6 go from
// one steady state to the other.
TEST(FrictionLaw, StepsOfSpeedFollowRateAndState) {
  for (const FrictionKind kind : {FrictionKind::ageing, FrictionKind::slip_law}) {
    const FrictionLaw law = rate_and_state(kind);
    const double decade = std::log(10.0);
    EXPECT_NEAR(law.coefficient(0, 1e-6, 10), 0.6, 1e-15);
    EXPECT_NEAR(law.coefficient(0, 1e-5, 10), 0.6 + law.a * decade, 1e-15);  // direct effect
    EXPECT_NEAR(law.aged(10, 1e-5, 1000), 1, 1e-12);
    EXPECT_NEAR(law.coefficient(0, 1e-5, 1), 0.6 + (law.a - law.b) * decade, 1e-15);
    // In two halves as in one, and along the differential equation.
    EXPECT_NEAR(law.aged(law.aged(10, 1e-5, 0.4), 1e-5, 0.4), law.aged(10, 1e-5, 0.8), 1e-12);
    const double dt = 1e-6, theta = 4, rate = 3e-6, x = rate * theta / law.length;
    const double slope = kind == FrictionKind::ageing ? 1 - x : -x * std::log(x);
    EXPECT_NEAR((law.aged(theta, rate, dt) - theta) / dt, slope, 1e-5);
  }
  EXPECT_DOUBLE_EQ(rate_and_state(FrictionKind::ageing).aged(3, 0, 5), 8);  // healing at rest
  EXPECT_DOUBLE_EQ(rate_and_state(FrictionKind::slip_law).aged(3, 0, 5), 3);
  EXPECT_EQ(rate_and_state(FrictionKind::ageing).coefficient(0, 0, 10), 0);
}

TEST(FrictionLaw, RateAndStateSolvesForTheSpeed) {
  const FrictionLaw law = rate_and_state(FrictionKind::ageing);
  const double k = 1e9, n = 1e6, dt = 1e-3;
  for (const double trial : {1e3, 5.8e5, 6e5, 7e5, 2e6}) {
    const Slide s = slide_of(law, trial, n, k, dt, 0, {0, 1e-6, 10});
    EXPECT_NEAR(trial - k * s.slipped, n * law.coefficient(0, s.rate, 10), 1e-6 * trial) << trial;
    EXPECT_NEAR(s.slipped, s.rate * dt, 1e-18);
  }
}

/// Spring slider without mass, pulled at V_0; after it was disturbed by a hundredth of its speed,
/// largest deviation of ln V in the third over the second period of time.
double growth_of(FrictionKind kind, double stiffness) {
  const FrictionLaw law = rate_and_state(kind);
  const double n = 1e6, dt = 0.02;
  Slide s{0, law.speed, 10};
  double pulled = 0.6 * n / stiffness, slid = 0;
  double most[3] = {0, 0, 0};
  constexpr int kSteps = 40000;
  for (int i = 0; i < 3 * kSteps; ++i) {
    pulled += law.speed * dt * (i < 100 ? 1.01 : 1);
    s = slide_of(law, stiffness * (pulled - slid), n, stiffness, dt, slid, s);
    slid += s.slipped;
    most[i / kSteps] = std::max(most[i / kSteps], std::abs(std::log(s.rate / law.speed)));
  }
  return most[2] / most[1];
}

// Small disturbances grow where the spring is softer than k_c = (b - a) N / L (Ruina 1983).
TEST(FrictionLaw, SlidingIsStableAboveTheCriticalStiffness) {
  const double critical = 0.005 * 1e6 / 10e-6;
  for (const FrictionKind kind : {FrictionKind::ageing, FrictionKind::slip_law}) {
    EXPECT_LT(growth_of(kind, 1.02 * critical), 1);
    EXPECT_GT(growth_of(kind, 0.98 * critical), 1);
  }
}

}  // namespace
