#include "point/fault.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace breccia;

const CohesiveSprings kSprings{1e9, 1e8, 0, 0};
const FrictionLaw kWeakening{FrictionKind::slip_weakening, 0.6, 0.4, 0.01, 0, 0, 0, 0};

/// V-044: a block on a fault under 1000 N, pulled at 0.01 m/s by a spring.
struct Slider {
  Fault<2> fault{kWeakening, kSprings};
  FaultState<2> state = fault.encode({{0, 0}}, {{-1000, 0}});
  CohesiveSpent spent;
  double stiffness, damping, mass = 1, x = 0, v = 0, time = 0, dt = 2e-5;

  explicit Slider(double k, double c = 0) : stiffness(k), damping(c) {}

  double pull() const { return stiffness * (0.01 * time - x); }
  void step() {
    const Vec<2> t = fault.advance(state, {{0, x}}, 1 / dt, spent);
    v += dt / mass * (pull() + damping * (0.01 - v) - t[1]);
    x += dt * v;
    time += dt;
  }
};

constexpr double kCritical = (0.6 - 0.4) * 1000 / 0.01;

TEST(Fault, StiffSpringSlidesSteadily) {
  // While it weakens the block moves k / (k - k_c) = 6 times as fast as the drive; the dashpot
  // keeps its mass from ringing.
  Slider s(1.2 * kCritical, 2 * std::sqrt(0.2 * kCritical));
  double fastest = 0;
  while (s.time < 4) {
    s.step();
    fastest = std::max(fastest, s.v);
  }
  EXPECT_LT(fastest, 0.1);
  EXPECT_NEAR(fastest, 0.06, 0.006);
  EXPECT_NEAR(s.pull(), 400, 4);
}

TEST(Fault, SoftSpringSlipsAndStops) {
  Slider s(0.8 * kCritical);  // runs away, if slowly
  while (s.v < 0.1) s.step();
  EXPECT_LT(s.time, 10);
}

// Energy: N ds (mu_s - mu_d) = k ds^2 / 2 + N (mu_s - mu_d) D_c / 2, or 2 (mu_s - mu_d) N / k for
// k << k_c. The drive goes on a little meanwhile: 1 %.
TEST(Fault, SlipOfAnEventIsThatOfItsEnergy) {
  Slider s(0.1 * kCritical);
  while (s.v < 0.1) s.step();
  while (s.v > 0) s.step();
  const double drop = 200, k = s.stiffness;
  const double slip = (drop + std::sqrt(drop * drop - k * drop * 0.01)) / k;
  EXPECT_NEAR(s.state.slip, slip, 0.01 * slip);
  EXPECT_NEAR(600 - s.pull(), k * slip, 0.01 * k * slip);
  // Work of friction N (mu_d s + (mu_s - mu_d) D_c / 2)
  const double heat = 1000 * (0.4 * s.state.slip + 0.2 * 0.01 / 2);
  EXPECT_NEAR(s.spent.friction, heat, 1e-3 * heat);
}

// V-043: constant speed, static and dynamic friction: one transition, then mu_d N.
TEST(Fault, StaticFrictionGivesWayOnce) {
  Fault<2> fault{{FrictionKind::static_dynamic, 0.6, 0.4, 0, 1e-4, 0, 0, 0}, kSprings};
  FaultState<2> state = fault.encode({{0, 0}}, {{-1000, 0}});
  CohesiveSpent spent;
  double peak = 0, last = 0;
  int turns = 0;
  bool rose = true;
  for (int i = 1; i < 2000; ++i) {
    last = fault.advance(state, {{0, i * 1e-8}}, 1e5, spent)[1];
    if (rose && last < peak - 1e-9) {
      ++turns;
      rose = false;
    }
    if (last > peak) rose = true;
    peak = std::max(peak, last);
  }
  EXPECT_NEAR(peak, 600, 1);  // one step of the spring is 1 N
  EXPECT_NEAR(last, 400 + 200 * std::exp(-10.0), 1e-6);
  EXPECT_EQ(turns, 1);
}

// eq:fault-1: the first traction is that of the ground, in whatever parts it is given.
TEST(Fault, BeginsWithTheTractionOfTheGround) {
  const Fault<3> fault{kWeakening, {1e9, 1e8, 1e3, 1e3}};
  const Vec<3> ground{{-5e6, 1e6, -2e6}}, load{{-3e6, 5e5, 0}};
  FaultState<3> state = fault.encode(ground, load);
  EXPECT_NEAR(fault.pressure(state), 8e6, 1e-3);
  CohesiveSpent spent;
  const Vec<3> t = fault.advance(state, Vec<3>::zero(), 1e6, spent);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(t[i], ground[i], 1e-3);
  EXPECT_EQ(state.slip, 0);
  // Above its friction it slides at once, down to mu N.
  const Fault<3> bare{kWeakening, {1e9, 1e8, 0, 0}};
  state = bare.encode({{-5e6, 5e6, 0}}, Vec<3>::zero());
  const Vec<3> slid = bare.advance(state, Vec<3>::zero(), 1e6, spent);
  EXPECT_NEAR(slid[1], bare.friction.coefficient(state.slip, 0, 0) * 5e6, 1e-3);
  EXPECT_GT(state.slip, 0);
}

// An open fault bears nothing, whatever it slid, and presses again where it closes.
TEST(Fault, OpensAndClosesAgain) {
  const Fault<2> fault{kWeakening, kSprings};
  FaultState<2> state = fault.encode({{-1e6, 1e5}}, Vec<2>::zero());
  CohesiveSpent spent;
  const Vec<2> open = fault.advance(state, {{2e-3, 5e-4}}, 1e6, spent);
  EXPECT_EQ(open[0], 0);
  EXPECT_NEAR(open[1], 0, 1e-6);
  const Vec<2> shut = fault.advance(state, {{0, 5e-4}}, 1e6, spent);
  EXPECT_NEAR(shut[0], -1e6, 1e-3);
  EXPECT_NEAR(shut[1], 0, 1e-6);
  // A fault that is pulled from the start opens.
  state = fault.encode({{1e6, 1e5}}, Vec<2>::zero());
  EXPECT_EQ(fault.advance(state, Vec<2>::zero(), 1e6, spent)[0], 0);
}

// eq:fault-4, 5: what the elements put in is stored, rubbed off or lost in the dashpots.
TEST(Fault, EnergyBalances) {
  for (const FrictionKind kind :
       {FrictionKind::coulomb, FrictionKind::slip_weakening, FrictionKind::ageing}) {
    const FrictionLaw law{kind, 0.6, 0.4, 1e-3, 1e-3, 0.01, 0.015, 1};
    const Fault<3> fault{law, {1e9, 1e8, 2e3, 1e3}};
    FaultState<3> state = fault.encode({{-5e6, 1e6, 2e6}}, {{-1e6, 5e5, 0}});
    CohesiveSpent spent;
    const double before = fault.stored(state);
    Vec<3> jump = Vec<3>::zero(), t = fault.advance(state, jump, 0, spent);
    double work = 0;
    for (int i = 1; i < 4000; ++i) {
      const double s = 1e-3 * i;
      const Vec<3> next{{1e-3 * std::sin(s), 0.05 * std::sin(3 * s), 0.02 * s}};
      const Vec<3> now = fault.advance(state, next, 1e4, spent);
      work += 0.5 * dot(t + now, next - jump);
      t = now;
      jump = next;
    }
    const double stored = fault.stored(state) - before;
    const double all = stored + spent.friction + spent.viscous;
    EXPECT_NEAR(work, all, 1e-9 * spent.friction);
    EXPECT_GT(spent.friction, 0);
  }
}

}  // namespace
