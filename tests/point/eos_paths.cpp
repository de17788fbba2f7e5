// Equations of state along paths: shocks, isentropes, crushing.
#include "eos_samples.hpp"

#include <gtest/gtest.h>

namespace {

using namespace breccia;
using namespace breccia::eos_samples;

/// Shock velocity at a particle velocity: the conservation laws of Rankine and Hugoniot with the
/// equation of state, by halving.
double shock_velocity(const Eos& eos, double u) {
  double low = u * 1.001, high = 50e3;
  for (int i = 0; i < 200; ++i) {
    const double speed = 0.5 * (low + high), rho = eos.rho0 * speed / (speed - u);
    (eos.pressure(rho, 0.5 * u * u) > eos.rho0 * speed * u ? low : high) = speed;
  }
  return low;
}

// V-031; the table has six digits.
TEST(EosPaths, TillotsonHugoniot) {
  const struct {
    Eos eos;
    double u, speed, gpa;
  } rows[] = {{aluminium(), 500, 6016.25, 8.12194},   {aluminium(), 1000, 6753.49, 18.2344},
              {aluminium(), 2500, 8870.61, 59.8766},  {aluminium(), 5000, 12126.5, 163.708},
              {aluminium(), 10000, 18283.0, 493.641}, {granite(), 500, 3325.36, 4.45599},
              {granite(), 1000, 4073.74, 10.9176},    {granite(), 2500, 6374.25, 42.7075},
              {granite(), 5000, 10232.3, 137.113},    {granite(), 10000, 17518.7, 469.501},
              {iron(), 1000, 5501.17, 42.9091},       {iron(), 2500, 7717.24, 150.486},
              {iron(), 5000, 11306.2, 440.944}};
  for (const auto& row : rows) {
    const double speed = shock_velocity(row.eos, row.u);
    EXPECT_NEAR(speed, row.speed, 1e-5 * row.speed) << row.u;
    EXPECT_NEAR(row.eos.rho0 * speed * row.u, row.gpa * 1e9, 1e-5 * row.gpa * 1e9) << row.u;
  }
}

// Copper and basalt: the linear relations they are made from, whatever Gamma is.
TEST(EosPaths, MieGruneisenHugoniot) {
  for (const double u : {100.0, 500.0, 1000.0, 2000.0}) {
    EXPECT_NEAR(shock_velocity(copper(), u), 3940 + 1.489 * u, 1e-6 * 3940) << u;
    EXPECT_NEAR(shock_velocity(basalt(), u), 2600 + 1.62 * u, 1e-6 * 2600) << u;
  }
  // Marsh 1980: 8.930 (3.940 + 1.489) km/s 1 km/s = 48.48 GPa.
  EXPECT_NEAR(8930 * shock_velocity(copper(), 1000) * 1000, 48.48e9, 0.01e9);
}

/// Energy after compression by a share and back in other steps, against many small ones.
double after_cycle(const Eos& eos, double most, int up, int down) {
  EosState s = eos.start();
  for (int i = 1; i <= up; ++i) {
    const double x = static_cast<double>(i) / up;
    eos.advance(s, eos.rho0 * (1 + most * x * x), 0);
  }
  for (int i = down - 1; i >= 0; --i) eos.advance(s, eos.rho0 * (1 + most * i / down), 0);
  return s.e;
}

// eq:eos-5: a cycle without heat gives the energy back; the error falls with the square of the
// step.
TEST(EosPaths, CyclesCloseToSecondOrder) {
  for (const Eos& eos : {linear(), copper(), aluminium(), air(), tnt()}) {
    const double scale = eos.energy0 + 0.5 * 0.04 * eos.modulus0 / eos.rho0;
    const double coarse = after_cycle(eos, 0.2, 20, 33) - eos.energy0;
    const double fine = after_cycle(eos, 0.2, 40, 66) - eos.energy0;
    EXPECT_LT(std::abs(coarse), 1e-3 * scale);
    EXPECT_NEAR(coarse / fine, 4, 0.2);
  }
}

// The isentrope of an ideal gas, p ~ rho^gamma, and heat at constant volume.
TEST(EosPaths, IdealGasOnItsIsentrope) {
  const Eos eos = air();
  double errors[2];
  for (int level = 0; level < 2; ++level) {
    EosState s = eos.start();
    const int steps = 100 << level;
    for (int i = 1; i <= steps; ++i) eos.advance(s, 1.2 * (1 + static_cast<double>(i) / steps), 0);
    errors[level] = std::abs(s.p - 1e5 * std::pow(2, 1.4));
  }
  EXPECT_LT(errors[0], 10);
  EXPECT_NEAR(errors[0] / errors[1], 4, 0.1);
  EosState s = eos.start();
  eos.advance(s, 1.2, 1000);
  EXPECT_NEAR(s.e, eos.energy0 + 1000, 1e-9);
  EXPECT_NEAR(s.p, 0.4 * 1.2 * s.e, 1e-9);
}

// The books of every step close to round-off, across every branch and limit.
TEST(EosPaths, EveryStepBalances) {
  std::vector<Eos> list = all();
  list.push_back(copper());
  list.back().mie_gruneisen.spall = 5e8;
  for (const Eos& eos : list) {
    EosState s = eos.start();
    for (int i = 0; i < 3000; ++i) {
      const EosState old = s;
      const double rho = eos.rho0 * (1 + 0.4 * std::sin(0.01 * i)), work = i % 7 == 0 ? 2e4 : 0;
      eos.advance(s, rho, work);
      const double gone = 0.5 * (old.p + s.p) * (1 / rho - 1 / old.rho);
      ASSERT_NEAR(s.e, old.e + work - gone, 1e-12 * (std::abs(s.e) + std::abs(gone) + 1e3));
      ASSERT_NEAR(s.p, eos.pressure(s.rho, s.e, s.alpha), 1e-12 * (std::abs(s.p) + 1e6));
      ASSERT_EQ(s.rho, rho);
    }
  }
}

// S-24: aluminium shocked to vapour, released to a thousandth of its density.
TEST(EosPaths, TillotsonReleasesToVapour) {
  const Eos eos = aluminium();
  int vapours = 0;
  for (const double e : {2e6, 6e6, 2e7, 5e7, 2e9}) {
    EosState s = eos.start();
    s.rho = 1.5 * eos.rho0;
    s.e = e;
    s.p = eos.pressure(s.rho, s.e);
    while (s.rho > 1e-3 * eos.rho0) {
      const double old = s.p;
      eos.advance(s, s.rho * 0.995, 0);
      ASSERT_TRUE(std::isfinite(s.p) && std::isfinite(s.e));
      ASSERT_GT(eos.bulk_modulus(s.rho, s.e), 0);
      ASSERT_LT(std::abs(s.p - old), 0.05 * (std::abs(old) + 75.2e9)) << s.rho;
    }
    EXPECT_GE(s.p, 0);
    if (e > 1e7) {
      EXPECT_GT(s.p, 0);
    }
    if (s.e > eos.tillotson.e_cv) {
      EXPECT_NEAR(s.p, 0.5 * s.rho * s.e, 0.02 * s.p);
      ++vapours;
    }
  }
  EXPECT_GE(vapours, 1);
}

// eq:eos-12, eq:eos-13: loading follows the crush curve, unloading keeps the distension, and at
// p_c no pore is left: the pressure is that of the solid.
TEST(EosPaths, PoresCrush) {
  const Eos eos = tuff();
  const Pores& c = eos.pores;
  EosState s = eos.start();
  EXPECT_NEAR(s.p, 0, 1e-3);
  double alpha = s.alpha;
  bool unloaded = false;
  for (int i = 0; i < 4000 && s.alpha > 1; ++i) {
    eos.advance(s, s.rho * 1.0001, 0);
    ASSERT_LE(s.alpha, alpha);
    alpha = s.alpha;
    if (s.p > c.begin * 1.001 && alpha > 1) {
      const double share = (c.end - s.p) / (c.end - c.begin);
      ASSERT_NEAR(alpha, 1 + 0.25 * share * share, 1e-10);
    }
    if (s.p > 0.5e9 && !unloaded) {
      unloaded = true;
      const EosState top = s;
      for (int k = 0; k < 40; ++k) eos.advance(s, s.rho * 0.9999, 0);
      EXPECT_EQ(s.alpha, top.alpha);
      EXPECT_LT(s.p, top.p);
      for (int k = 0; k < 40; ++k) eos.advance(s, s.rho / 0.9999, 0);
      EXPECT_NEAR(s.p, top.p, 1e-9 * top.p);
    }
  }
  EXPECT_TRUE(unloaded);
  EXPECT_EQ(s.alpha, 1);
  EXPECT_GE(s.p, c.end * (1 - 1e-3));
  EXPECT_NEAR(s.p, eos.mie_gruneisen.at(s.rho, s.e).p, 1);
}

// Work lost in a cycle of crushing is the area of the curve: it stays as heat.
TEST(EosPaths, CrushingHeats) {
  const Eos eos = tuff();
  EosState s = eos.start();
  double work = 0;
  const auto go = [&](double rho) {
    const EosState old = s;
    eos.advance(s, rho, 0);
    work -= 0.5 * (old.p + s.p) * (1 / rho - 1 / old.rho);
  };
  for (int i = 0; i < 2500; ++i) go(s.rho * 1.0001);
  for (int i = 0; i < 100000 && s.p > 0; ++i) go(s.rho * 0.99999);
  EXPECT_NEAR(s.e, work, 1e-9 * work);
  // Crushed at p, a volume 1/rho0 - alpha/(alpha0 rho0) is lost: at least p_e, at most p_c of it.
  const double lost = 1 / eos.rho0 - 1 / s.rho;
  EXPECT_GT(s.e, 20e6 * lost);
  EXPECT_LT(s.e, 1.5e9 * lost);
}

}  // namespace
