// What every inelastic law must keep, whatever the trial state.
#include "point/plastic_laws.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using namespace breccia;

constexpr double kBulk = 40e9, kShear = 24e9;

/// By how much a state lies outside the elastic domain, Pa: written down anew, not the laws' own.
double excess(const J2& l, const PrincipalStress& s, const double* h) {
  return std::sqrt(3.0) * s.root_j2() - l.yield - l.hardening * h[0];
}

double excess(const DruckerPrager& l, const PrincipalStress& s, const double* h) {
  const double b = l.per_cohesion * l.cohesion.at(h[0]);
  return std::max(
      {s.root_j2() + l.friction * s.mean() - b, s.mean() - l.cut_off, s.mean() - b / l.friction});
}

double excess(const MohrCoulomb& l, const PrincipalStress& s, const double* h) {
  const double high = std::max({s.tau[0], s.tau[1], s.tau[2]});
  const double low = std::min({s.tau[0], s.tau[1], s.tau[2]});
  return std::max(high - low + (high + low) * l.sin_phi - 2 * l.cohesion.at(h[0]) * l.cos_phi,
                  high - l.cut_off);
}

double excess(const Holmquist& l, const PrincipalStress& s, const double* h) {
  const double p = -s.mean() / l.hel_pressure, t = l.tension / l.hel_pressure;
  const double yi = l.intact * std::pow(std::max(0.0, p + t), l.intact_power);
  const double yf = std::min(yi, l.fractured * std::pow(std::max(0.0, p), l.fractured_power));
  return std::max(std::sqrt(3.0) * s.root_j2() - l.hel_stress * (yi - h[1] * (yi - yf)),
                  s.mean() - l.tension * (1 - h[1]));
}

double excess(const JohnsonCook& l, const PrincipalStress& s, const double* h) {
  const double soft = 1 - std::pow(std::min(1.0, h[1] / l.melting), l.softening);
  return std::sqrt(3.0) * s.root_j2() - (l.yield + l.hardening * std::pow(h[0], l.exponent)) * soft;
}

template <class Law>
struct Sample;

template <>
struct Sample<J2> {
  static J2 law() {
    J2 l;
    l.yield = 30e6;
    l.hardening = 500e6;
    return l;
  }
};
template <>
struct Sample<JohnsonCook> {
  static JohnsonCook law() {
    JohnsonCook l;
    l.yield = 30e6;
    l.hardening = 200e6;
    l.exponent = 0.4;
    l.melting = 1000;
    l.heat = 0.0;
    return l;
  }
};
template <>
struct Sample<DruckerPrager> {
  static DruckerPrager law() {
    DruckerPrager l = DruckerPrager::fitted(DruckerPrager::Fit::compression, 0.6, 0.2);
    l.cohesion = {20e6, 2e6, 0.02};
    l.cut_off = 8e6;
    return l;
  }
};
template <>
struct Sample<MohrCoulomb> {
  static MohrCoulomb law() {
    MohrCoulomb l;
    l.sin_phi = std::sin(0.6);
    l.cos_phi = std::cos(0.6);
    l.sin_psi = std::sin(0.2);
    l.cohesion = {20e6, 20e6, 0};
    l.cut_off = 8e6;
    return l;
  }
};
template <>
struct Sample<Holmquist> {
  static Holmquist law() {
    Holmquist l;
    l.hel_stress = 2e9;
    l.hel_pressure = 1.46e9;
    l.intact = 0.93;
    l.intact_power = 0.6;
    l.fractured = 0.31;
    l.fractured_power = 0.6;
    l.tension = 0.2e9;
    l.ductility = 0.005;
    l.ductility_power = 1;
    return l;
  }
};

template <class Law>
class PlasticLaws : public testing::Test {};
using Kinds = testing::Types<J2, JohnsonCook, DruckerPrager, MohrCoulomb, Holmquist>;
TYPED_TEST_SUITE(PlasticLaws, Kinds);

/// Trial states of many sizes and of every kind of triaxiality, histories not at their start.
template <class Law>
struct Trials {
  std::mt19937 random{7};
  Law law = Sample<Law>::law();
  double e[3], history[kMaxHistory];

  double number(double low, double high) {
    return low + (high - low) * std::uniform_real_distribution<double>()(random);
  }
  void draw() {
    const double size = std::pow(10.0, number(-4.5, -1));
    const double mean = size * number(-1, 1) * (number(0, 1) < 0.5 ? 1 : 0.1);
    for (double& x : e) x = mean + size * number(-1, 1) * number(0, 1);
    if (number(0, 1) < 0.1) e[1] = e[0];  // on an edge
    for (double& h : history) h = 0;
    history[0] = number(0, 0.03);
    if constexpr (std::is_same_v<Law, Holmquist>) history[1] = number(0, 1);
    if constexpr (std::is_same_v<Law, JohnsonCook>) {
      history[1] = number(0, 900);
      history[2] = law.hardened(history[0]).value * law.thermal(history[1]) - law.yield;
    }
  }
};

TYPED_TEST(PlasticLaws, ReturnInsideAndDissipate) {
  Trials<TypeParam> t;
  t.law.bulk = kBulk;
  t.law.shear = kShear;
  int returned = 0;
  for (int i = 0; i < 10000; ++i) {
    t.draw();
    const PrincipalStress trial = PrincipalStress::of(t.e, kBulk, kShear);
    const double f = excess(t.law, trial, t.history);
    const double bound = t.law.beyond(trial.mean(), trial.root_j2(), t.history);
    const double size = std::abs(trial.mean()) + trial.root_j2() + 1e6;
    if (f > 1e-9 * size) {
      ASSERT_GT(bound, 0) << i;
    }
    const double before[3] = {t.e[0], t.e[1], t.e[2]}, ep = t.history[0];
    const double work = t.law.update(t.e, t.history, 1e-6);
    if (f < -1e-9 * size) {
      for (int k = 0; k < 3; ++k) ASSERT_EQ(t.e[k], before[k]) << i;
      ASSERT_EQ(work, 0);
    }
    ASSERT_GE(work, 0) << i;
    ASSERT_GE(t.history[0], ep);
    const PrincipalStress s = PrincipalStress::of(t.e, kBulk, kShear);
    double spent = 0, largest = 0;  // by the stress at the end; the law may not hide a loss
    for (int k = 0; k < 3; ++k) {
      spent += s.tau[k] * (before[k] - t.e[k]);
      largest += std::abs(s.tau[k] * (before[k] - t.e[k]));
    }
    ASSERT_GE(spent, -1e-9 * largest - 1e-6) << i;  // J/m3; typical values are 1e4
    ASSERT_LE(excess(t.law, s, t.history), 1e-8 * 1e6 + 1e-9 * size) << i << " of " << f;
    if (f > 0) ++returned;
  }
  EXPECT_GT(returned, 2000);
  EXPECT_LT(returned, 9900);
}

// The order in which principal values come does not matter.
TYPED_TEST(PlasticLaws, PlacesAreKept) {
  Trials<TypeParam> t;
  t.law.bulk = kBulk;
  t.law.shear = kShear;
  for (int i = 0; i < 200; ++i) {
    t.draw();
    double turned[3] = {t.e[2], t.e[0], t.e[1]}, h[kMaxHistory];
    for (int k = 0; k < kMaxHistory; ++k) h[k] = t.history[k];
    t.law.update(t.e, t.history, 1e-6);
    t.law.update(turned, h, 1e-6);
    for (int k = 0; k < 3; ++k) ASSERT_NEAR(turned[k], t.e[(k + 2) % 3], 1e-14);
    ASSERT_NEAR(h[0], t.history[0], 1e-13);
  }
}

// Packs give the bound that plain numbers give.
TYPED_TEST(PlasticLaws, BoundsOfPacks) {
  Trials<TypeParam> t;
  t.law.bulk = kBulk;
  t.law.shear = kShear;
  for (int i = 0; i < 100; ++i) {
    double mean[lanes<Pack>()], root[lanes<Pack>()], h[kMaxHistory][lanes<Pack>()];
    double wanted[lanes<Pack>()], got[lanes<Pack>()];
    for (int l = 0; l < lanes<Pack>(); ++l) {
      t.draw();
      const PrincipalStress s = PrincipalStress::of(t.e, kBulk, kShear);
      mean[l] = s.mean();
      root[l] = s.root_j2();
      for (int k = 0; k < kMaxHistory; ++k) h[k][l] = t.history[k];
      wanted[l] = t.law.beyond(mean[l], root[l], t.history);
    }
    Pack history[kMaxHistory];
    for (int k = 0; k < kMaxHistory; ++k) history[k] = load<Pack>(h[k]);
    store(t.law.beyond(load<Pack>(mean), load<Pack>(root), history), got);
    for (int l = 0; l < lanes<Pack>(); ++l)
      ASSERT_NEAR(got[l], wanted[l], 1e-12 * (std::abs(wanted[l]) + 1e9));
  }
}

// Associated flow returns to the nearest admissible stress in the norm of the elastic energy.
template <class Law>
void expect_nearest(Law law) {
  law.bulk = kBulk;
  law.shear = kShear;
  Trials<Law> t;
  const auto distance = [](const double(&a)[3], const double(&b)[3]) {
    const double d[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]}, trace = d[0] + d[1] + d[2];
    return (kBulk / 2 - kShear / 3) * trace * trace +
           kShear * (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
  };
  for (int i = 0; i < 300; ++i) {
    t.draw();
    t.history[0] = 0;
    double trial[3] = {t.e[0], t.e[1], t.e[2]};
    law.update(t.e, t.history, 1e-6);
    const double mine = distance(trial, t.e), length = std::abs(t.e[0]) + std::abs(t.e[2]) + 1e-5;
    for (int k = 0; k < 100; ++k) {
      double other[3];
      const double reach = length * std::pow(10.0, t.number(-5, 0));
      for (int j = 0; j < 3; ++j) other[j] = t.e[j] + reach * t.number(-1, 1);
      if (excess(law, PrincipalStress::of(other, kBulk, kShear), t.history) > 0) continue;
      ASSERT_GE(distance(trial, other), mine * (1 - 1e-9));
    }
  }
}

TEST(PlasticLaws, AssociatedFlowFindsTheNearestStress) {
  MohrCoulomb mc = Sample<MohrCoulomb>::law();
  mc.sin_psi = mc.sin_phi;
  expect_nearest(mc);
  mc.cut_off = mc.cohesion.first * mc.cos_phi / mc.sin_phi;
  expect_nearest(mc);
  mc.sin_phi = mc.sin_psi = 0;  // Tresca
  mc.cos_phi = 1;
  mc.cut_off = 1e300;
  expect_nearest(mc);
  DruckerPrager dp = Sample<DruckerPrager>::law();
  dp.dilation = dp.friction;
  dp.cohesion = {20e6, 20e6, 0};
  expect_nearest(dp);
}

}  // namespace
