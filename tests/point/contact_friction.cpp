// The laws of friction on a contact point.
#include "point/contact_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace breccia;

const FrictionLaw kWeakening{FrictionKind::slip_weakening, 0.6, 0.4, 0.01, 0, 0, 0, 0};
constexpr double kPressing = 1000, kNormal = 1e9, kTangential = 3e8;
constexpr double kCritical = (0.6 - 0.4) * kPressing / 0.01;

ContactParameters parameters(const FrictionLaw& law) {
  ContactParameters p;
  p.normal = kNormal;
  p.tangential = kTangential;
  p.friction = law.at_rest;
  p.law = &law;
  return p;
}

/// A point pressed by 1000 N against a target with normal +y, and what it spent.
struct Rubbing {
  ContactParameters law;
  ContactState<2> state;
  double friction = 0, rest = 0, work = 0;

  explicit Rubbing(const FrictionLaw& l) : law(parameters(l)) {}

  /// Drag along x on the point, which moved at v during the last step.
  double move(double v, double dt) {
    const ContactMotion<2> motion{kPressing / kNormal, {{0, 1}}, 1, {{v, 0}}, dt, 0.9, false};
    const auto r = contact_response(law, state, motion);
    work -= 0.5 * (state.force[0] + r.next.force[0]) * v * dt;
    friction += r.friction;
    rest += r.viscous + r.numeric;
    state = r.next;
    return state.force[0];
  }
};

/// V-044: the point on a mass that a spring pulls at 0.01 m/s.
struct Slider : Rubbing {
  double stiffness, damping, mass = 1, x = 0, v = 0, time = 0, dt = 1e-5;

  explicit Slider(double k, double c = 0) : Rubbing(kWeakening), stiffness(k), damping(c) {}

  double pull() const { return stiffness * (0.01 * time - x); }
  void step() {
    const double drag = move(v, dt);
    v += dt / mass * (pull() + damping * (0.01 - v) + drag);
    x += dt * v;
    time += dt;
  }
};

// While it weakens the block moves k / (k - k_c) = 6 times as fast as the drive.
TEST(ContactFrictionLaw, StiffSpringSlidesSteadily) {
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

TEST(ContactFrictionLaw, SoftSpringSlipsAndStops) {
  Slider s(0.8 * kCritical);
  while (s.v < 0.1) s.step();
  EXPECT_LT(s.time, 10);
}

// Energy: N ds (mu_s - mu_d) = k ds^2 / 2 + N (mu_s - mu_d) D_c / 2; heat
// N (mu_d s + (mu_s - mu_d) D_c / 2). The drive goes on a little meanwhile: 1 %.
TEST(ContactFrictionLaw, SlipOfAnEventIsThatOfItsEnergy) {
  Slider s(0.1 * kCritical);
  while (s.v < 0.1) s.step();
  while (s.v > 0) s.step();
  const double drop = 200, k = s.stiffness;
  const double slip = (drop + std::sqrt(drop * drop - k * drop * 0.01)) / k;
  EXPECT_NEAR(s.state.rubbed.slip, slip, 0.01 * slip);
  EXPECT_NEAR(600 - s.pull(), k * slip, 0.01 * k * slip);
  const double heat = kPressing * (0.4 * s.state.rubbed.slip + 0.2 * 0.01 / 2);
  EXPECT_NEAR(s.friction, heat, 1e-3 * heat);
}

// V-043: at a constant speed the force rises to mu_s N and falls once, to that of the speed.
TEST(ContactFrictionLaw, StaticFrictionGivesWayOnce) {
  for (const FrictionKind kind : {FrictionKind::static_dynamic, FrictionKind::velocity_weakening}) {
    const FrictionLaw law{kind, 0.6, 0.4, 0, 1e-4, 0, 0, 0};
    Rubbing point(law);
    double peak = 0, last = 0;
    int turns = 0;
    bool rose = true;
    for (int i = 0; i < 2000; ++i) {
      last = -point.move(0.1, 3e-8);  // 0.9 N per step of the spring
      if (rose && last < peak - 1e-9) ++turns;
      rose = last >= peak;
      peak = std::max(peak, last);
    }
    EXPECT_NEAR(peak, 600, 1);
    EXPECT_NEAR(last, kPressing * law.coefficient(0, 0.1, 0), 1e-6);
    EXPECT_EQ(turns, 1);
  }
}

// A step of speed from one steady state: mu rises by a ln(V_2/V_1) at once, and ends at
// (a - b) ln(V_2/V_1) from where it was.
TEST(ContactFrictionLaw, StepsOfSpeedFollowRateAndState) {
  for (const FrictionKind kind : {FrictionKind::ageing, FrictionKind::slip_law}) {
    const FrictionLaw law{kind, 0.6, 0.6, 10e-6, 1e-6, 0.010, 0.015, 10};
    Rubbing point(law);
    const double decade = std::log(10.0), dt = 1e-4;
    for (int i = 0; i < 100000; ++i) point.move(1e-5, dt);  // ten times state_slip
    const double before = -point.state.force[0] / kPressing;
    EXPECT_NEAR(before, 0.6 + (law.a - law.b) * decade, 1e-4);
    double peak = 0;
    for (int i = 0; i < 100000; ++i) peak = std::max(peak, -point.move(1e-4, dt / 10) / kPressing);
    EXPECT_NEAR(peak - before, law.a * decade, 0.02 * law.a * decade);
    EXPECT_NEAR(-point.state.force[0] / kPressing - before, (law.a - law.b) * decade,
                0.01 * law.b * decade);
    EXPECT_NEAR(point.friction + point.rest + point.state.stored, point.work, 1e-9 * point.work);
  }
}

// A law that is coulomb by its word is the contact without a law, up to rounding.
TEST(ContactFrictionLaw, CoulombIsTheSameWithAndWithoutALaw) {
  const FrictionLaw law{FrictionKind::coulomb, 0.6, 0.6, 0, 0, 0, 0, 0};
  Rubbing with(law), without(law);
  without.law.law = nullptr;
  with.law.tangential_damping = without.law.tangential_damping = 1e3;
  for (int i = 0; i < 3000; ++i) {
    const double v = std::cos(0.01 * i);
    EXPECT_NEAR(with.move(v, 3e-8), without.move(v, 3e-8), 1e-9 * kPressing);
  }
  EXPECT_NEAR(with.friction, without.friction, 1e-9 * without.friction);
  EXPECT_GT(with.state.rubbed.slip, 0);
  EXPECT_EQ(without.state.rubbed.slip, 0);
}

// Nothing slides by rate and state in no time, as when lists are made anew; what is not pressed
// holds nothing.
TEST(ContactFrictionLaw, NeedsTimeAndPressure) {
  const FrictionLaw law{FrictionKind::ageing, 0.6, 0.6, 10e-6, 1e-6, 0.010, 0.015, 10};
  Rubbing point(law);
  point.state.slip = {{1e-5, 0}};
  EXPECT_NEAR(point.move(0, 0), -1e-5 * kTangential, 1e-6);
  EXPECT_EQ(point.state.rubbed.slip, 0);
  EXPECT_EQ(point.state.rubbed.theta, 10);
  const ContactMotion<2> apart{-1e-3, {{0, 1}}, 1, {{0, 0}}, 1e-4, 0.9, false};
  const auto r = contact_response(point.law, point.state, apart);
  EXPECT_EQ(norm(r.next.force), 0);
  EXPECT_NEAR(norm(r.next.slip), 0, 1e-20);
}

}  // namespace
