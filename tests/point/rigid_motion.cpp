// V-053: a body that no torque acts on, turned as the code turns it.
#include "point/rigid_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace breccia {
namespace {

/// A torque-free body of principal moments `inertia`, axes along those of space at the start.
struct Rotor {
  Vec<3> inertia;
  Vec<3> momentum;
  Quaternion q = Quaternion::identity();

  Rotor(const Vec<3>& moments, const Vec<3>& spin) : inertia(moments) {
    for (int i = 0; i < 3; ++i) momentum[i] = inertia[i] * spin[i];
  }
  Vec<3> along_axes() const { return transpose(matrix_of(q)) * momentum; }
  Vec<3> spin_along_axes() const {
    Vec<3> w = along_axes();
    for (int i = 0; i < 3; ++i) w[i] /= inertia[i];
    return w;
  }
  double energy() const { return 0.5 * dot(along_axes(), spin_along_axes()); }
  void step(double h) {
    const FreeRotor rotor{{1 / inertia[0], 1 / inertia[1], 1 / inertia[2]}};
    q = normalised(q * rotor.turn(along_axes(), h));
  }
};

const Vec<3> kMoments{1, 2, 3};
const Vec<3> kNearlySecond{0.01, 2, 0.01};

// Momentum is kept as it stands; energy wavers with the fourth power of the step and does not drift.
TEST(RigidMotion, EnergyStaysOverManySteps) {
  Rotor rotor(kMoments, kNearlySecond);
  const double start = rotor.energy();
  double most = 0;
  for (int n = 0; n < 100000; ++n) {
    rotor.step(0.002);
    most = std::max(most, std::abs(rotor.energy() / start - 1));
  }
  EXPECT_LT(most, 1e-8);
  EXPECT_GT(most, 1e-16) << "turned nothing";
  EXPECT_NEAR(norm(rotor.along_axes()), norm(rotor.momentum), 1e-12 * norm(rotor.momentum));
}

// Turning about the middle axis is unstable: (w1, w3) grow at
// w2 sqrt((I2 - I1) (I3 - I2) / (I1 I3)) = 2 sqrt(1 / 3).
TEST(RigidMotion, SmallPartsGrowAboutTheMiddleAxis) {
  Rotor rotor(kMoments, {1e-7, 2, 1e-7});
  const double h = 1e-3;
  const auto advance = [&](double time) {
    for (int n = 0; n < std::lround(time / h); ++n) rotor.step(h);
    return std::abs(rotor.spin_along_axes()[0]);
  };
  const double first = advance(3), second = advance(4);
  EXPECT_NEAR(std::log(second / first) / 4, 2 * std::sqrt(1.0 / 3), 1e-2 * 2 * std::sqrt(1.0 / 3));
}

// In the body the spin of a symmetric top goes round at (I3 - I1) / I1 w3.
TEST(RigidMotion, ASymmetricTopPrecesses) {
  Rotor rotor({1, 1, 1.6}, {0.3, 0, 5});
  const double rate = 0.6 * 5, h = 1e-3;
  const int n = 1000;
  for (int i = 0; i < n; ++i) rotor.step(h);
  const Vec<3> spin = rotor.spin_along_axes();
  EXPECT_NEAR(std::remainder(std::atan2(spin[1], spin[0]) - rate * n * h, 2 * M_PI), 0,
              1e-4 * rate * n * h);
  EXPECT_NEAR(spin[2], 5, 1e-12);
}

TEST(RigidMotion, ATopKeepsItsEnergyOverAThousandTurns) {
  Rotor rotor({1, 1.1, 1.6}, {0.5, 0.2, 6});
  const double start = rotor.energy(), h = 0.005 / 6;
  for (int n = 0; n < static_cast<int>(1000 * 2 * M_PI / 6 / h); ++n) rotor.step(h);
  EXPECT_NEAR(rotor.energy() / start, 1, 1e-8);
  EXPECT_NEAR(norm(rotor.along_axes()) / norm(rotor.momentum), 1, 1e-8);
}

TEST(RigidMotion, TheErrorFallsWithTheFourthPowerOfTheStep) {
  const auto turned = [](double h) {
    Rotor rotor(kMoments, {1, 2, 1});
    for (int n = 0; n < std::lround(1 / h); ++n) rotor.step(h);
    return rotor.q;
  };
  const Quaternion exact = turned(0.001);
  std::vector<double> error;
  for (const double h : {0.1, 0.05, 0.025}) {
    const Quaternion q = turned(h);
    error.push_back(std::hypot(norm(q.u - exact.u), q.w - exact.w));
  }
  EXPECT_NEAR(std::log2(error[0] / error[1]), 4, 0.3);
  EXPECT_NEAR(std::log2(error[1] / error[2]), 4, 0.3);
}

TEST(RigidMotion, SmallTurnsKeepTheirDigits) {
  const double angle = 1e-9;
  const Mat<3> change = turn_less_one(Quaternion::of({0, 0, angle}));
  EXPECT_NEAR(change(1, 0), angle, 1e-15 * angle);
  EXPECT_NEAR(change(0, 0), -0.5 * angle * angle, 1e-15 * angle * angle);
  const Mat<3> quarter = matrix_of(Quaternion::of({0, 0, M_PI / 2}));
  EXPECT_NEAR(quarter(1, 0), 1, 1e-15);
  EXPECT_NEAR(quarter(0, 1), -1, 1e-15);
}

}  // namespace
}  // namespace breccia
