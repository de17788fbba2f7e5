#include "eos_samples.hpp"

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace breccia;
using namespace breccia::eos_samples;

// V-030: aluminium, eq:eos-6 to eq:eos-8.
TEST(Eos, TillotsonStates) {
  const Eos eos = aluminium();
  const struct {
    double rho, e, gpa;
  } rows[] = {{2700, 0, 0},
              {3000, 1e6, 14.8662863},
              {3500, 1e7, 71.5357296},
              {2500, 1e6, -.659520483},
              {2000, 5e6, -2.39887081},
              {1500, 1e7, 1.37462521},
              {1000, 2e7, 10.0000006},
              {300, 3e7, 4.5}};
  for (const auto& row : rows) {
    EXPECT_NEAR(eos.pressure(row.rho, row.e), row.gpa * 1e9, 1e-8 * std::abs(row.gpa * 1e9))
        << row.rho << " " << row.e;
  }
}

// V-030, S-24: no jump of pressure at rho0, e_iv, e_cv or where cold tension ends.
TEST(Eos, TillotsonIsContinuous) {
  const Eos eos = aluminium();
  const Tillotson& t = eos.tillotson;
  const double size = 1e-12 * t.bulk;
  for (const double e : {0.0, 1e6, 2.9e6, 4e6, 9e6, 2e7, 1e8}) {
    for (const double at : {1.0, Tillotson::kPullsAbove, Tillotson::kPullsFully}) {
      const double rho = at * t.rho0;
      EXPECT_NEAR(eos.pressure(std::nextafter(rho, 0), e), eos.pressure(rho, e), size);
      EXPECT_NEAR(eos.pressure(std::nextafter(rho, 1e9), e), eos.pressure(rho, e), size);
    }
  }
  for (const double eta : {1e-3, 0.3, 0.55, 0.9, 0.999}) {
    for (const double e : {0.0, t.e_iv, t.e_cv}) {
      const double rho = eta * t.rho0;
      EXPECT_NEAR(eos.pressure(rho, e + 1e-6), eos.pressure(rho, e), size);
      EXPECT_NEAR(eos.pressure(rho, e - 1e-6), eos.pressure(rho, e), size);
    }
  }
}

// eq:eos-9: what has come apart does not pull, hot or cold.
TEST(Eos, SwollenSolidDoesNotPull) {
  for (const Eos& eos : {aluminium(), granite(), iron()}) {
    for (double eta = Tillotson::kPullsAbove; eta > 1e-3; eta *= 0.8)
      for (const double e : {0.0, 1e4, 1e6, 3e6, 5e6, 1e7, 1e8})
        EXPECT_GE(eos.pressure(eta * eos.rho0, e), 0);
    EXPECT_LT(eos.pressure(0.95 * eos.rho0, 0), 0);  // before that it does
  }
}

// The derivatives are those of the pressure, on every branch.
TEST(Eos, DerivativesAreThoseOfThePressure) {
  for (const Eos& eos : all()) {
    for (const double eta : {0.3, 0.6, 0.8, 0.97, 1.05, 1.3, 1.8}) {
      for (const double e : {1e5, 1e6, 5e6, 3e7}) {
        const double rho = eta * eos.rho0, d_rho = 1e-6 * rho, d_e = 1e-6 * e;
        const EosPoint q = eos.at(rho, e, eos.pores.alpha);
        const auto p = [&](double r, double x) { return eos.pressure(r, x, eos.pores.alpha); };
        const double by_rho = (p(rho + d_rho, e) - p(rho - d_rho, e)) / (2 * d_rho);
        const double by_e = (p(rho, e + d_e) - p(rho, e - d_e)) / (2 * d_e);
        const double size = (std::abs(q.p) + eos.modulus0) * 1e-8;
        EXPECT_NEAR(q.p_rho * rho, by_rho * rho, size) << eta << " " << e;
        EXPECT_NEAR(q.p_e * e, by_e * e, size) << eta << " " << e;
      }
    }
  }
}

// eq:eos-4, S-24: sound is real everywhere, and at rest it is what it should be.
TEST(Eos, SoundIsRealEverywhere) {
  for (const Eos& eos : all()) {
    for (double eta = 1e-3; eta < 3; eta *= 1.1)
      for (const double e : {-1e5, 0.0, 1e5, 3e6, 1e7, 1e8}) {
        const double k = eos.bulk_modulus(eta * eos.rho0, e, eos.pores.alpha);
        ASSERT_TRUE(std::isfinite(k));
        ASSERT_GE(k, Eos::kFloor * eos.modulus0 * eta * (1 - 1e-12));
      }
  }
  EXPECT_NEAR(copper().bulk_modulus(8930, 0), 8930 * 3940.0 * 3940, 1);
  EXPECT_NEAR(aluminium().bulk_modulus(2700, 0), 75.2e9, 1);
  EXPECT_NEAR(tuff().bulk_modulus(tuff().start()), 2650 * 3500.0 * 3500 / 1.25, 10);
  EXPECT_NEAR(air().bulk_modulus(1.2, air().energy0), 1.4 * 1e5, 1e-6);
}

// eq:eos-1 to eq:eos-3: a limit of tension holds, at every energy.
TEST(Eos, SpallLimitsTension) {
  Eos eos = copper();
  eos.mie_gruneisen.spall = 1.2e9;
  EXPECT_EQ(eos.pressure(0.9 * 8930, 0), -1.2e9);
  EXPECT_GT(eos.pressure(0.9 * 8930, 2e6), 0);
  EXPECT_GT(eos.bulk_modulus(0.9 * 8930, 0), 1e9);
  Eos simple = linear();
  EXPECT_NEAR(simple.pressure(1.1 * simple.rho0, 1e5), 0.1 * 40e9 + 1.5 * 1e5 * simple.rho0, 1);
  simple.linear.spall = 1e8;
  EXPECT_EQ(simple.pressure(0.9 * simple.rho0, 0), -1e8);
}

// Past 1 - s eta = 0.1 the Hugoniot goes on along its tangent: stiff, but finite.
TEST(Eos, MieGruneisenHasNoPole) {
  const Eos eos = copper();
  const double end = 0.9 / 1.489, at = 8930 / (1 - end);
  EXPECT_NEAR(eos.pressure(at * (1 + 1e-12), 0), eos.pressure(at * (1 - 1e-12), 0),
              1e-8 * eos.pressure(at, 0));
  EXPECT_TRUE(std::isfinite(eos.pressure(10 * at, 0)));
}

// TNT: from the constants of eq:eos-11 alone the slowest detonation (Chapman and Jouguet)
// runs at 6930 m/s with 21 GPa.
TEST(Eos, JwlDetonates) {
  const Eos eos = tnt();
  double slowest = 1e300, pressure = 0;
  for (double v = 0.6; v < 0.9; v += 1e-5) {
    // E = E0 + p (1 - V) / 2; p is linear in E.
    const double rho = eos.rho0 / v;
    const EosPoint cold = eos.at(rho, 0);
    const double per_volume = cold.p_e / eos.rho0;
    const double p = (cold.p + per_volume * 7.0e9) / (1 - per_volume * (1 - v) / 2);
    const double speed = std::sqrt(p / (eos.rho0 * (1 - v)));
    if (speed < slowest) {
      slowest = speed;
      pressure = p;
    }
  }
  EXPECT_NEAR(slowest, 6930, 0.005 * 6930);
  EXPECT_NEAR(pressure, 21e9, 0.02 * 21e9);
}

// eq:eos-10 on an isentrope, and JWL far out, where it is an ideal gas of gamma = 1 + w.
TEST(Eos, GasesExpand) {
  EXPECT_NEAR(air().start().p, 1e5, 1e-9);
  const Eos eos = tnt();
  EXPECT_NEAR(eos.pressure(1.63, 1e6), 0.3 * 1.63 * 1e6, 1e-3 * 0.3 * 1.63e6);
}

}  // namespace
