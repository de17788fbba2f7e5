#include "point/plastic_j2.hpp"

#include "material_paths.hpp"
#include "point/plastic_johnson_cook.hpp"

#include <gtest/gtest.h>

namespace {

using namespace breccia;

const double kRoot3 = std::sqrt(3.0);

// OFHC copper: Johnson and Cook 1983, table 1 (A, B, n, C, m, melting at 1356 K).
JohnsonCook copper() {
  JohnsonCook law;
  law.bulk = 140e9;
  law.shear = 46e9;
  law.yield = 90e6;
  law.hardening = 292e6;
  law.exponent = 0.31;
  law.rate_law = RateFactor::johnson_cook;
  law.rate_strength = 0.025;
  law.rate_reference = 1;
  return law;
}

J2 line() {
  J2 law;
  law.bulk = 140e9;
  law.shear = 46e9;
  law.yield = 90e6;
  law.hardening = 292e6;
  return law;
}

// eq:plastic-2, eq:plastic-3. In simple tension the stress is yield + H ep and the strain is
// tau / E + ep, so that it is E H / (E + H) times the strain after yield.
TEST(PlasticJ2, SimpleTensionFollowsTheHardeningLine) {
  PointDriver<J2> point{line()};
  const J2& law = point.law;
  const double young = 9 * law.bulk * law.shear / (3 * law.bulk + law.shear);
  const int steps = 40;
  for (int i = 1; i <= steps; ++i) {
    point.step_held(0.02 / steps, 0);
    const double slope = young * law.hardening / (young + law.hardening);
    const double tau = law.yield + slope * (0.02 * i / steps - law.yield / young);
    if (i > 4) {
      EXPECT_NEAR(point.stress().tau[0], tau, 1e-6 * tau);
    }
    EXPECT_NEAR(point.stress().tau[1], 0, 1e-6 * tau);
  }
  const double ep = point.history[0];
  const double work = law.yield * ep + 0.5 * law.hardening * ep * ep;
  EXPECT_NEAR(point.work, work, 1e-9 * work);
  EXPECT_NEAR(point.plastic_volume(), 0, 1e-15);
}

// In torsion the shear stress is the yield stress over sqrt(3), the shear strain sqrt(3) ep.
TEST(PlasticJ2, Torsion) {
  PointDriver<J2> point{line()};
  for (int i = 0; i < 100; ++i) point.step(5e-4, -5e-4, 0);
  const double tau = point.stress().tau[0], ep = point.history[0];
  EXPECT_NEAR(tau, (point.law.yield + point.law.hardening * ep) / kRoot3, 1e-6 * tau);
  EXPECT_NEAR(0.1 - tau / point.law.shear, kRoot3 * ep, 1e-9);  // gamma = 2 * 0.05
}

// A pressure a thousand times the yield stress changes nothing.
TEST(PlasticJ2, PressureDoesNotMatter) {
  double a[3] = {0.01, -0.004, 0.002}, b[3] = {0.31, 0.296, 0.302}, h[kMaxHistory] = {};
  double g[kMaxHistory] = {};
  const double work = line().update(a, h, 1e-6);
  EXPECT_NEAR(line().update(b, g, 1e-6), work, 1e-10 * work);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(b[i] - 0.3, a[i], 1e-14);
}

// eq:plastic-4 to eq:plastic-6: torsion at a constant plastic strain rate.
TEST(PlasticJohnsonCook, TorsionAtConstantRate) {
  for (const double rate : {0.5, 10.0, 1e4}) {
    PointDriver<JohnsonCook> point{copper()};
    const double d_gamma = 1e-3, dt = d_gamma / (kRoot3 * rate);
    for (int i = 0; i < 400; ++i) point.step(d_gamma / 2, -d_gamma / 2, 0, dt);
    const double before = point.history[0];
    point.step(d_gamma / 2, -d_gamma / 2, 0, dt);
    const double ep = point.history[0], now = (ep - before) / dt;
    const double factor = now > 1 ? 1 + 0.025 * std::log(now) : 1;
    const double q = (90e6 + 292e6 * std::pow(ep, 0.31)) * factor;
    EXPECT_NEAR(kRoot3 * point.stress().tau[0], q, 1e-10 * q) << rate;
    EXPECT_NEAR(now, rate, 0.01 * rate);  // elastic strain takes a little
    EXPECT_NEAR(ep, 0.401 / kRoot3, 0.005);
  }
}

// Power hardening in simple tension, rate and heat off.
TEST(PlasticJohnsonCook, SimpleTensionWithPowerHardening) {
  PointDriver<JohnsonCook> point{copper()};
  point.law.rate_law = RateFactor::none;
  for (int i = 0; i < 50; ++i) {
    point.step_held(1e-3, 0);
    const double q = 90e6 + 292e6 * std::pow(point.history[0], 0.31);
    EXPECT_NEAR(point.stress().tau[0], q, 1e-6 * q);
    EXPECT_NEAR(point.history[2], q - 90e6, 1e-9 * q);
  }
}

// Perzyna: the stress above the static one is (rate / rate0)^C of it.
TEST(PlasticJohnsonCook, PerzynaOverstress) {
  PointDriver<JohnsonCook> point{copper()};
  point.law.hardening = 0;
  point.law.rate_law = RateFactor::perzyna;
  point.law.rate_strength = 0.25;
  point.law.rate_reference = 1e5;
  const double rate = 2e3, d_gamma = 1e-3, dt = d_gamma / (kRoot3 * rate);
  for (int i = 0; i < 200; ++i) point.step(d_gamma / 2, -d_gamma / 2, 0, dt);
  const double q = 90e6 * (1 + std::pow(rate / 1e5, 0.25));
  EXPECT_NEAR(kRoot3 * point.stress().tau[0], q, 1e-9 * q);
}

// eq:plastic-7. Without hardening and with m = 1, T* = 1 - exp(-k ep), k = S heat / melting: the
// strength decays to nothing. Temperature lags by a step, so the error halves with the step.
TEST(PlasticJohnsonCook, AdiabaticSoftening) {
  double errors[2];
  for (int level = 0; level < 2; ++level) {
    PointDriver<JohnsonCook> point{copper()};
    JohnsonCook& law = point.law;
    law.hardening = 0;
    law.rate_law = RateFactor::none;
    law.melting = 1063;
    law.heat = 0.9 / (8930 * 383.0) * 20;  // twenty times as much, to see it
    const int steps = level == 0 ? 2000 : 4000;
    for (int i = 0; i < steps; ++i) point.step(1.0 / steps, -1.0 / steps, 0);
    const double k = law.yield * law.heat / law.melting;
    const double share = std::exp(-k * point.history[0]);
    EXPECT_NEAR(point.history[1], law.melting * (1 - share), 1e-3 * law.melting);
    EXPECT_NEAR(point.history[1], law.heat * point.work, 1e-9);
    errors[level] = std::abs(point.history[1] - law.melting * (1 - share));
  }
  EXPECT_NEAR(errors[0] / errors[1], 2, 0.2);
}

// Molten: no deviator is left, and nothing is divided by its absence.
TEST(PlasticJohnsonCook, MoltenFlows) {
  JohnsonCook law = copper();
  law.melting = 1063;
  double e[3] = {0.01, -0.002, 0.001}, history[kMaxHistory] = {0.1, 2000, -90e6};
  EXPECT_GT(law.beyond(0.0, 1e3, history), 0);
  EXPECT_GE(law.update(e, history, 1e-6), 0);
  for (double x : e) EXPECT_NEAR(x, 0.003, 1e-15);
}

}  // namespace
