#include "point/plastic_holmquist.hpp"

#include "material_paths.hpp"

#include <gtest/gtest.h>

namespace {

using namespace breccia;

// Alumina AD-99.5: Anderson, Johnson and Holmquist, 1995, as tabulated by Cronin et al., 4th
// European LS-DYNA Users Conference (2003), table 1: HEL 2.79 GPa at 1.46 GPa.
Holmquist alumina() {
  Holmquist law;
  law.bulk = 130.95e9;
  law.shear = 90.16e9;
  law.hel_stress = 1.5 * (2.79e9 - 1.46e9);
  law.hel_pressure = 1.46e9;
  law.intact = 0.93;
  law.intact_power = 0.6;
  law.fractured = 0.31;
  law.fractured_power = 0.6;
  law.tension = 0.2e9;
  law.ductility = 0.005;
  law.ductility_power = 1;
  return law;
}

double q_of(const PrincipalStress& s) {
  return std::sqrt(3.0) * s.root_j2();
}

// The published constants agree with each other: in plane compression the material yields at its
// Hugoniot elastic limit.
TEST(PlasticHolmquist, YieldsAtTheHugoniotElasticLimit) {
  PointDriver<Holmquist> point{alumina()};
  while (point.history[0] == 0) point.step(-1e-5, 0, 0);
  EXPECT_NEAR(-point.stress().tau[0], 2.79e9, 0.01 * 2.79e9);
  EXPECT_NEAR(-point.stress().mean(), 1.46e9, 0.01 * 1.46e9);
}

// eq:plastic-18, eq:plastic-19: at constant pressure the strength starts on the intact envelope,
// falls along a line in plastic strain and ends on the one of the crushed material.
TEST(PlasticHolmquist, EnvelopesAndTheWayBetween) {
  for (const double pressure : {0.05e9, 0.5e9, 2e9, 6e9}) {
    PointDriver<Holmquist> point{alumina()};
    const Holmquist& law = point.law;
    const double mean = -pressure / (3 * law.bulk), p = pressure / 1.46e9;
    point.step(mean, mean, mean);
    ASSERT_EQ(point.history[0], 0);
    const double yi = law.hel_stress * 0.93 * std::pow(p + 0.2 / 1.46, 0.6);
    const double yf = law.hel_stress * 0.31 * std::pow(p, 0.6);
    const double failure = std::max(1e-3, 0.005 * (p + 0.2 / 1.46));
    const double small = yi / (3 * law.shear) * 1e-3;
    for (int i = 0; i < 20000 && point.history[1] < 1; ++i) {
      point.step(small, -0.5 * small, -0.5 * small);
      if (point.history[0] == 0) continue;
      const double damage = std::min(1.0, point.history[0] / failure);
      ASSERT_NEAR(point.history[1], damage, 1e-9);
      // The softening line is steeper than the elastic one where little strain crushes: there
      // the material breaks in one step.
      if (3 * law.shear * failure < yi - yf) continue;
      ASSERT_NEAR(q_of(point.stress()), yi - damage * (yi - yf), 1e-6 * yi);
    }
    EXPECT_EQ(point.history[1], 1);
    point.step(0.05, -0.025, -0.025);
    EXPECT_NEAR(q_of(point.stress()), yf, 1e-6 * yf) << pressure;
    EXPECT_NEAR(point.stress().mean(), -pressure, 1e-6 * pressure);
  }
}

// Rate: both envelopes rise by the logarithm.
TEST(PlasticHolmquist, CrushedStrengthRisesWithRate) {
  Holmquist law = alumina();
  law.rate_strength = 0.01;
  PointDriver<Holmquist> point{law};
  const double mean = -1e9 / (3 * law.bulk), d = 1e-3, dt = 1e-7;
  point.step(mean, mean, mean);
  for (int i = 0; i < 300; ++i) point.step(d, -0.5 * d, -0.5 * d, dt);  // ep grows by d a step
  ASSERT_EQ(point.history[1], 1);
  const double q = law.hel_stress * 0.31 * std::pow(1 / 1.46, 0.6) * (1 + 0.01 * std::log(1e4));
  EXPECT_NEAR(q_of(point.stress()), q, 1e-6 * q);
}

// eq:plastic-20, eq:plastic-21: hydrostatic tension ends at T, then damage lets go.
TEST(PlasticHolmquist, TensionLetsGo) {
  PointDriver<Holmquist> point{alumina()};
  point.law.ductility_least = 0.01;
  const double limit = point.law.tension, d = 1e-6;
  double most = 0;
  for (int i = 0; i < 20000; ++i) {
    point.step(d, d, d);
    most = std::max(most, point.stress().mean());
    ASSERT_LE(point.stress().mean(), limit * (1 - point.history[1]) * (1 + 1e-9) + 1);
  }
  EXPECT_NEAR(most, limit, 1e-3 * limit);
  EXPECT_EQ(point.history[1], 1);
  EXPECT_NEAR(point.stress().mean(), 0, 1);
  EXPECT_NEAR(point.work, 0.5 * limit * 0.01, 0.01 * limit * 0.01);  // area below the line
  for (int i = 0; i < 40000; ++i) point.step(-d, -d, -d);
  EXPECT_LT(point.stress().mean(), -1e9);  // pressure is borne again
}

TEST(PlasticHolmquist, SimpleTensionIsWhereTheEnvelopeSaysSo) {
  const Holmquist law = alumina();
  const double q = law.uniaxial_tension();
  EXPECT_GT(q, 0);
  EXPECT_LT(q, 3 * law.tension);
  EXPECT_NEAR(q, law.strength(-q / 3, 1).intact, 1e-9 * q);
}

}  // namespace
