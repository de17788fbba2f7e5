#include "point/cohesive.hpp"

#include "point/cohesive_encode.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace breccia {
namespace {

// Granite-like; springs as gives them for kf = 5 on half-millimetre elements.
constexpr CohesiveStrength kRock{8e6, 24e6, 1.19, 0.6, 50, 500};
constexpr CohesiveSprings kSprings{7.2e14, 2.4e14, 0, 0};

template <class S>
constexpr Cohesive<2, S> kLaw{kRock, kSprings};

struct Path {
  double work = 0;  ///< J/m2, by the trapezoidal rule
  double peak_normal = 0, peak_shear = 0;
  CohesiveSpent spent;
  CohesiveState<2> state;
  Vec<2> traction = Vec<2>::zero();
};

template <class S>
void drive(const Cohesive<2, S>& law, Path& path, const Vec<2>& to, int steps, double rate = 0) {
  const Vec<2> from = path.state.jump;
  for (int i = 1; i <= steps; ++i) {
    const Vec<2> jump = from + (to - from) * (static_cast<double>(i) / steps);
    const auto r = law.respond(path.state, jump, rate);
    EXPECT_GE(r.next.damage, path.state.damage);
    path.work += 0.5 * dot(path.traction + r.traction, jump - path.state.jump);
    path.spent.tension += r.spent.tension;
    path.spent.shear += r.spent.shear;
    path.spent.friction += r.spent.friction;
    path.spent.viscous += r.spent.viscous;
    path.peak_normal = std::max(path.peak_normal, r.traction[0]);
    path.peak_shear = std::max(path.peak_shear, std::abs(r.traction[1]));
    path.traction = r.traction;
    path.state = r.next;
  }
}

template <class S>
Path born(const Cohesive<2, S>& law, const Vec<2>& t0) {
  Path path;
  path.state = encode<2, S>(law.strength, law.springs, t0);
  path.traction = t0;
  return path;
}

// Linear softening is integrated exactly by the trapezoidal rule; the z-curve to its error
// (1/12) h^2 z'' with h = 1e-4.
template <class S>
void check_opening(double share_of_strength, double tolerance) {
  const auto law = kLaw<S>;
  Path path = born(law, {{share_of_strength * kRock.tension, 0}});
  drive(law, path, {{1.01 * (path.state.opening_reach + 2e-8), 0}}, 10000);
  EXPECT_NEAR(path.peak_normal, std::max(1.0, share_of_strength) * kRock.tension,
              2e-3 * kRock.tension);
  EXPECT_EQ(path.state.damage, 1);
  EXPECT_EQ(path.traction[0], 0);
  EXPECT_NEAR(path.spent.tension / kRock.energy_tension, 1, tolerance);
  // The driven work misses the peak and the foot, each by at most half a step times the kink.
  EXPECT_NEAR(path.work / kRock.energy_tension, 1, 1e-5);
  EXPECT_NEAR(law.stored(path.state), 0, 1e-12);
  EXPECT_EQ(path.spent.shear, 0);
}

TEST(Cohesive, OpeningSpendsTheEnergyOfTension) {
  for (const double share : {0.0, 0.3, 0.5, 0.95, 1.0, 1.4}) {
    SCOPED_TRACE(share);
    check_opening<LinearSoftening>(share, 1e-11);
    check_opening<ZCurve>(share, 1e-6);
  }
}

template <class S>
void check_sliding(double tolerance) {
  const auto law = kLaw<S>;
  Path path = born(law, {{0, 0}});
  drive(law, path, {{0, 1.02 * (path.state.slip_reach + 1e-7)}}, 10000);
  EXPECT_NEAR(path.peak_shear, kRock.cohesion, 2e-3 * kRock.cohesion);
  EXPECT_EQ(path.state.damage, 1);
  EXPECT_NEAR(path.spent.shear / kRock.energy_shear, 1, tolerance);
  EXPECT_NEAR(path.work / kRock.energy_shear, 1, 1e-5);
  EXPECT_EQ(path.spent.tension, 0);
  EXPECT_EQ(path.spent.friction, 0);
}

TEST(Cohesive, SlidingSpendsTheEnergyOfShear) {
  check_sliding<LinearSoftening>(1e-11);
  check_sliding<ZCurve>(1e-6);
}

// The driver wants a constant pressure: the jump that gives it depends on the damage at the end
// of the step, found by repeating the (pure) call.
template <class S>
void check_sliding_under_pressure(double start) {
  constexpr double kPressure = 5e6;
  const auto law = kLaw<S>;
  Path path = born(law, {{start > 0 ? -kPressure : 0, start}});
  const double offset = path.state.offset;
  const int steps = 20000;
  const double end = 1.05 * (path.state.slip_reach + 2e-7);
  double damage = 0;
  for (int i = 0; i <= steps; ++i) {
    Vec<2> jump{{0, end * i / steps}};
    CohesiveResponse<2> r;
    for (int repeat = 0; repeat < 4; ++repeat) {
      jump[0] = -kPressure / kSprings.normal - (1 - damage) * offset;
      r = law.respond(path.state, jump, 0);
      damage = r.next.damage;
    }
    if (i == 0) {
      EXPECT_NEAR(r.traction[1], start, 1e-12 * (1 + start));
    }
    EXPECT_NEAR(r.traction[0], -kPressure, 1e-6 * kPressure);
    path.spent.shear += r.spent.shear;
    path.spent.friction += r.spent.friction;
    path.state = r.next;
    path.traction = r.traction;
  }
  EXPECT_NEAR(path.spent.shear / kRock.energy_shear, 1, 1e-6);
  EXPECT_NEAR(path.traction[1], kRock.residual_friction * kPressure, 1e-6 * kPressure);
  // Heat is the friction at the mean coefficient while S falls linearly with slip, then mu_r.
  EXPECT_GT(path.spent.friction, kRock.residual_friction * kPressure * path.state.slip);
}

TEST(Cohesive, SlidingUnderPressureSpendsTheSameAndRubs) {
  check_sliding_under_pressure<LinearSoftening>(0);
  check_sliding_under_pressure<LinearSoftening>(23e6);
  check_sliding_under_pressure<ZCurve>(0);
  check_sliding_under_pressure<ZCurve>(23e6);
}

TEST(Cohesive, UnloadsToTheVirtualOriginAndReloadsToTheSamePoint) {
  const auto law = kLaw<LinearSoftening>;
  Path path = born(law, {{6e6, 0}});
  drive(law, path, {{4e-6, 0}}, 1000);
  const double top = path.traction[0], damage = path.state.damage;
  const double spent = path.spent.tension;
  ASSERT_GT(damage, 0.2);
  const double origin = -(1 - damage) * path.state.offset;
  drive(law, path, {{origin, 0}}, 10);
  EXPECT_NEAR(path.traction[0], 0, 1e-9 * top);
  drive(law, path, {{4e-6, 0}}, 7);
  EXPECT_NEAR(path.traction[0], top, 1e-9 * top);
  EXPECT_EQ(path.state.damage, damage);
  EXPECT_EQ(path.spent.tension, spent);
}

TEST(Cohesive, CompressionNeverDamages) {
  const auto law = kLaw<ZCurve>;
  Path path = born(law, {{0, 0}});
  drive(law, path, {{-1e-6, 0}}, 100);
  EXPECT_EQ(path.state.damage, 0);
  EXPECT_NEAR(path.traction[0], -1e-6 * kSprings.normal, 1e-3);
  EXPECT_EQ(path.spent.tension, 0);
}

TEST(Cohesive, BrokenFaceOnlyPressesAndRubs) {
  const auto law = kLaw<LinearSoftening>;
  Path path = born(law, {{7e6, 1e6}});
  drive(law, path, {{2e-5, 0}}, 1000);
  ASSERT_EQ(path.state.damage, 1);
  EXPECT_EQ(norm(path.traction), 0);
  drive(law, path, {{-1e-8, 0}}, 100);
  EXPECT_NEAR(path.traction[0], -1e-8 * kSprings.normal, 1e-3);
  drive(law, path, {{-1e-8, 3e-7}}, 1000);
  EXPECT_NEAR(path.traction[1], kRock.residual_friction * 1e-8 * kSprings.normal, 1);
  const double energy = path.spent.tension + path.spent.shear;
  drive(law, path, {{1e-8, 3e-7}}, 100);
  EXPECT_EQ(norm(path.traction), 0);
  EXPECT_EQ(path.spent.tension + path.spent.shear, energy);
}

// V-061: proportional loading gives an energy that does not depend on the steps, and with
// mu_i = 0 the shares of the two modes lie on the quarter circle of the root-sum damage.
TEST(Cohesive, ProportionalMixedLoadingIsPathIndependent) {
  CohesiveStrength rock = kRock;
  rock.friction = 0;
  const Cohesive<2, LinearSoftening> law{rock, kSprings};
  for (const double slope : {0.5, 2.0, 5.0}) {
    std::vector<double> total;
    for (const int steps : {4000, 16000}) {
      Path path = born(law, {{0, 0}});
      drive(law, path, {{2e-5, slope * 2e-5}}, steps);
      ASSERT_EQ(path.state.damage, 1);
      total.push_back(path.spent.tension + path.spent.shear);
      EXPECT_NEAR(std::hypot(path.spent.tension / 50, path.spent.shear / 500), 1, 1e-2);
      EXPECT_NEAR(path.work, total.back(), 2e-5 * total.back());
    }
    EXPECT_NEAR(total[0] / total[1], 1, 1e-6);
  }
}

// Whatever the path, a face gives back no more than it was born with, and the books close.
TEST(Cohesive, RandomClosedCyclesNeverGiveEnergy) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto law = kLaw<LinearSoftening>;
  for (int cycle = 0; cycle < 300; ++cycle) {
    const Vec<2> t0{{7e6 * unit(random), 15e6 * unit(random)}};
    Path path = born(law, t0);
    // Both springs; the normal one is not in `stored` of a new face.
    const double start = 0.5 * t0[0] * t0[0] / kSprings.normal + law.stored(path.state);
    const double books = law.stored(path.state);
    for (int leg = 0; leg < 6; ++leg)
      drive(law, path, {{1e-5 * unit(random), 4e-5 * unit(random)}}, 4000);
    drive(law, path, {{0, 0}}, 4000);
    const CohesiveSpent& s = path.spent;
    EXPECT_GT(path.work + start, 0);
    EXPECT_GE(s.friction, 0);
    EXPECT_GE(s.shear, 0);
    const double spent = s.tension + s.shear + s.friction;
    const double moved = std::abs(path.work) + spent + start;
    // Steps of 1e-3 of the path cut corners of the traction by their squares.
    EXPECT_NEAR(path.work + books, law.stored(path.state) + spent, 2e-3 * moved);
  }
}

// S-14
TEST(Cohesive, CyclesOfAHalfBrokenFaceOnlyRub) {
  const auto law = kLaw<LinearSoftening>;
  Path path = born(law, {{7.6e6, 0}});
  drive(law, path, {{6e-6, 0}}, 1000);
  const double damage = path.state.damage, spent = path.spent.tension;
  ASSERT_GT(damage, 0.4);
  ASSERT_LT(damage, 0.6);
  for (int cycle = 0; cycle < 1000; ++cycle) {
    drive(law, path, {{5e-6, 1e-8}}, 25);
    drive(law, path, {{-1e-9, -1e-8}}, 25);
    drive(law, path, {{-1e-9, 1e-8}}, 25);
    drive(law, path, {{5e-6, 0}}, 25);
  }
  EXPECT_EQ(path.state.damage, damage);
  EXPECT_EQ(path.spent.tension, spent);
  drive(law, path, {{-(1 - damage) * path.state.offset, 0}}, 25);
  EXPECT_NEAR(path.traction[0], 0, 1e-3);
}

// A corner starts with the traction it is given, undamaged and without slip, however far that is
// above the strength or turned into shear.
template <int D>
void check_first_traction() {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  const Cohesive<D, LinearSoftening> law{kRock, kSprings};
  for (int i = 0; i < 2000; ++i) {
    Vec<D> t0;
    for (int d = 0; d < D; ++d) t0[d] = 4e7 * unit(random);
    const auto state = encode<D, LinearSoftening>(kRock, kSprings, t0);
    const auto r = law.respond(state, Vec<D>::zero(), 1e8);
    EXPECT_NEAR(norm(r.traction - t0), 0, 1e-14 * norm(t0));
    EXPECT_LE(r.next.damage, 1e-15);
    EXPECT_EQ(r.spent.tension, 0);
    EXPECT_LE(r.next.slip, 1e-15 * state.slip_reach);
    // Stored energy at zero jump is that of the encoded slip alone; the normal parts cancel.
    const double scale = norm2(t0) / kSprings.shear;
    EXPECT_NEAR(law.stored(state), encoded_energy<D>(kSprings, state), 1e-14 * scale);
  }
}

TEST(Cohesive, FirstTractionIsTheEncodedOne) {
  check_first_traction<2>();
  check_first_traction<3>();
}

TEST(Cohesive, ShearHasNoPreferredDirection) {
  const Cohesive<3, LinearSoftening> law{kRock, kSprings};
  const Cohesive<2, LinearSoftening> plane{kRock, kSprings};
  auto a = encode<2, LinearSoftening>(kRock, kSprings, {{-3e6, 0}});
  auto b = encode<3, LinearSoftening>(kRock, kSprings, {{-3e6, 0, 0}});
  const double c = std::cos(0.7), s = std::sin(0.7);
  for (int i = 1; i <= 200; ++i) {
    const double n = -1e-9 * i, t = 2e-7 * i;
    const auto ra = plane.respond(a, {{n, t}}, 0);
    const auto rb = law.respond(b, {{n, c * t, s * t}}, 0);
    a = ra.next;
    b = rb.next;
    EXPECT_NEAR(rb.traction[0], ra.traction[0], 1e-6);
    EXPECT_NEAR(rb.traction[1], c * ra.traction[1], 1e-5);
    EXPECT_NEAR(rb.traction[2], s * ra.traction[1], 1e-5);
    EXPECT_NEAR(b.damage, a.damage, 1e-13);
  }
  EXPECT_GT(a.damage, 0.5);
}

TEST(Cohesive, DashpotsTakeEnergyAndNeverPullABrokenFace) {
  CohesiveSprings springs = kSprings;
  springs.normal_damping = 4e5;
  springs.shear_damping = 2e5;
  const Cohesive<2, LinearSoftening> law{kRock, springs};
  Path path = born(law, {{2e6, 1e6}});
  const double rate = 1e8;
  drive(law, path, {{5e-9, 5e-9}}, 50, rate);
  EXPECT_GT(path.spent.viscous, 0);
  EXPECT_EQ(path.state.damage, 0);
  path.state.damage = 1;
  drive(law, path, {{-2e-8, 0}}, 20, rate);
  for (int i = 1; i <= 40; ++i) {
    drive(law, path, {{-2e-8 + i * 1e-9, 0}}, 1, rate);
    EXPECT_LE(path.traction[0], 0);
  }
  EXPECT_EQ(path.traction[0], 0);
}

// Slopes of the strength and lengths that numbers of the law rest on.
/// A random walk of openings, slips and pressures of one corner until it is broken and beyond.
template <int D, class S>
void check_advance(unsigned seed) {
  CohesiveSprings springs = kSprings;
  springs.normal_damping = 3e5;
  springs.shear_damping = 2e5;
  const Cohesive<D, S> law{kRock, springs};
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Vec<D> t0 = Vec<D>::zero();
  t0[0] = 6e6 * normal(random);
  CohesiveState<D> state = encode<D, S>(kRock, springs, t0), same = state;
  CohesiveSpent spent;
  Vec<D> jump = Vec<D>::zero();
  int stood = 0, moved = 0;
  for (int i = 0; i < 3000; ++i) {
    for (int d = 0; d < D; ++d)
      jump[d] = 0.98 * jump[d] + (i < 1500 ? 1e-8 : 2e-6) * normal(random);
    const auto r = law.respond(same, jump, 1e8);
    CohesiveSpent step;
    const Vec<D> t = law.advance(state, jump, 1e8, step);
    (r.next.damage > same.damage || r.next.slip > same.slip ? moved : stood) += 1;
    const double size = 1e-14 * (norm(r.traction) + springs.normal * norm(jump));
    ASSERT_LE(norm(t - r.traction), size) << i;
    ASSERT_EQ(state.damage, r.next.damage) << i;
    ASSERT_EQ(state.opening, r.next.opening) << i;
    ASSERT_EQ(state.slip, r.next.slip) << i;
    ASSERT_EQ(step.tension, r.spent.tension) << i;
    ASSERT_EQ(step.shear, r.spent.shear) << i;
    ASSERT_EQ(step.friction, r.spent.friction) << i;
    ASSERT_NEAR(step.viscous, r.spent.viscous, 1e-12 * std::abs(r.spent.viscous) + 1e-20) << i;
    same = r.next;
    state = same;
  }
  EXPECT_EQ(state.damage, 1);
  EXPECT_GT(stood, 100);
  EXPECT_GT(moved, 100);
}

TEST(Cohesive, TheShortWayIsTheLaw) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    check_advance<2, LinearSoftening>(seed);
    check_advance<3, LinearSoftening>(seed);
    check_advance<2, ZCurve>(seed);
    check_advance<3, ZCurve>(seed);
  }
}

template <class S>
void check_softening() {
  double area = 0, steepest = 0;
  const int n = 100000;
  for (int i = 0; i < n; ++i) {
    const double a = S::left(static_cast<double>(i) / n), b = S::left((i + 1.0) / n);
    area += 0.5 * (a + b) / n;
    steepest = std::max(steepest, (a - b) * n);
    ASSERT_GE(a, b - 1e-12);
  }
  EXPECT_NEAR(area, S::area, 1e-9);
  EXPECT_NEAR(steepest, S::steepest, 1e-4);
  EXPECT_NEAR(S::left(0), 1, 1e-15);
  EXPECT_NEAR(S::left(1), 0, 1e-15);
}

TEST(Cohesive, SofteningsHaveTheStatedAreaAndSlope) {
  check_softening<LinearSoftening>();
  check_softening<ZCurve>();
}

}  // namespace
}  // namespace breccia
