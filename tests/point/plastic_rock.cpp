#include "material_paths.hpp"
#include "point/plastic_drucker_prager.hpp"
#include "point/plastic_mohr_coulomb.hpp"
#include "point/plastic_rate.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace {

using namespace breccia;
using Fit = DruckerPrager::Fit;

constexpr double kDegree = std::numbers::pi / 180;

MohrCoulomb pyramid(double c, double phi, double psi) {
  MohrCoulomb law;
  law.bulk = 40e9;
  law.shear = 24e9;
  law.sin_phi = std::sin(phi);
  law.cos_phi = std::cos(phi);
  law.sin_psi = std::sin(psi);
  law.cohesion = {c, c, 0};
  law.cut_off = phi > 0 ? c * std::cos(phi) / std::sin(phi) : 1e300;
  return law;
}

DruckerPrager cone(Fit fit, double c, double phi, double psi) {
  DruckerPrager law = DruckerPrager::fitted(fit, phi, psi);
  law.bulk = 40e9;
  law.shear = 24e9;
  law.cohesion = {c, c, 0};
  return law;
}

/// Largest axial pressure of a sample held by a lateral one.
template <class Law>
double triaxial_strength(const Law& law, double confinement, double sign = -1) {
  PointDriver<Law> point{law};
  const double start = -confinement / (3 * law.bulk);
  point.step(start, start, start);
  for (int i = 0; i < 60; ++i) point.step_held(sign * 2e-4, -confinement);
  EXPECT_NEAR(point.stress().tau[1], -confinement, 1e-6 * (confinement + 1e6));
  return -point.stress().tau[0];
}

// V-029: c = 20 MPa, phi = 40 degrees; c = 26.84 MPa, phi = 51 degrees (Westerly granite). The
// reference values are printed with three decimals of a MPa.
TEST(PlasticRock, StrengthOfTriaxialCompression) {
  for (const double psi : {0.0, 10 * kDegree, 40 * kDegree}) {
    const MohrCoulomb mc = pyramid(20e6, 40 * kDegree, psi);
    const double ucs = 2 * 20e6 * std::tan(65 * kDegree), n = std::pow(std::tan(65 * kDegree), 2);
    EXPECT_NEAR(ucs, 85.780e6, 500);
    EXPECT_NEAR(triaxial_strength(mc, 0), ucs, 1e-6 * ucs);
    EXPECT_NEAR(triaxial_strength(mc, 10e6), ucs + 10e6 * n, 1e-6 * ucs);
    EXPECT_NEAR(triaxial_strength(mc, 10e6), 131.769e6, 1000);
    const DruckerPrager dp = cone(Fit::compression, 20e6, 40 * kDegree, psi);
    EXPECT_NEAR(dp.friction, 0.314875 * 3, 3e-6);  // the reference is for I1 = 3 sm
    EXPECT_NEAR(dp.strength(0.0), 22.5152e6, 50);
    EXPECT_NEAR(triaxial_strength(dp, 0), ucs, 1e-6 * ucs);
    EXPECT_NEAR(triaxial_strength(dp, 10e6), ucs + 10e6 * n, 1e-6 * ucs);
  }
  const MohrCoulomb westerly = pyramid(26.84e6, 51 * kDegree, 20 * kDegree);
  EXPECT_NEAR(triaxial_strength(westerly, 0), 151.588e6, 1000);
  EXPECT_NEAR(triaxial_strength(westerly, 10e6), 231.332e6, 1000);
}

// Extension at a lateral pressure p: the axial pressure falls to (p - ucs) / tan^2. The inner cone
// meets it, the outer one is stronger.
TEST(PlasticRock, StrengthOfTriaxialExtension) {
  const double n = std::pow(std::tan(60 * kDegree), 2), ucs = 2 * 5e6 * std::sqrt(n), p = 60e6;
  const double wanted = (p - ucs) / n;
  EXPECT_NEAR(triaxial_strength(pyramid(5e6, 30 * kDegree, 5 * kDegree), p, 1), wanted, 1e-6 * p);
  EXPECT_NEAR(triaxial_strength(cone(Fit::extension, 5e6, 30 * kDegree, 0), p, 1), wanted,
              1e-6 * p);
  EXPECT_LT(triaxial_strength(cone(Fit::compression, 5e6, 30 * kDegree, 0), p, 1), wanted - 1e6);
}

// eq:plastic-12, plane strain: with associated flow the cone and the pyramid fail together.
TEST(PlasticRock, PlaneStrainFit) {
  const double c = 5e6, phi = 30 * kDegree;
  PointDriver<DruckerPrager> point{cone(Fit::plane_strain, c, phi, phi)};
  for (int i = 0; i < 4000; ++i) {  // s1 held at 0, s2 by no strain: halving on one component
    double low = -1e-3, high = 1e-3;
    for (int k = 0; k < 60; ++k) {
      const double middle = 0.5 * (low + high);
      PointDriver<DruckerPrager> trial = point;
      trial.step(-1e-5, middle, 0);
      (trial.stress().tau[1] < 0 ? low : high) = middle;
    }
    point.step(-1e-5, high, 0);
  }
  const double ucs = 2 * c * std::tan(60 * kDegree);
  EXPECT_NEAR(-point.stress().tau[0], ucs, 1e-4 * ucs);  // the out-of-plane stress settles slowly
}

// Both laws, flow in triaxial compression: volume grows by sin(psi) of the shear strain
// (pyramid), by Abar dg (cone).
TEST(PlasticRock, DilationIsThatOfTheAngle) {
  for (const double psi : {0.0, 15.0, 40.0}) {
    MohrCoulomb law = pyramid(20e6, 40 * kDegree, psi * kDegree);
    double e[3] = {0.0012, -0.001, -0.003}, history[kMaxHistory] = {};  // one plane acts
    double before[3] = {e[0], e[1], e[2]};
    law.update(e, history, 1e-6);
    const double volume = before[0] + before[1] + before[2] - e[0] - e[1] - e[2];
    const double shear = (before[0] - e[0]) - (before[2] - e[2]);
    EXPECT_GT(shear, 1e-4);
    EXPECT_NEAR(volume / shear, law.sin_psi, 1e-9);
    EXPECT_NEAR(before[1] - e[1], 0, 1e-15);
    const DruckerPrager dp = cone(Fit::compression, 20e6, 40 * kDegree, psi * kDegree);
    double d[3] = {before[0], before[1], before[2]}, h[kMaxHistory] = {};
    const double j2_before = PrincipalStress::of(d, dp.bulk, dp.shear).root_j2();
    dp.update(d, h, 1e-6);
    const double dg = (j2_before - PrincipalStress::of(d, dp.bulk, dp.shear).root_j2()) / dp.shear;
    EXPECT_NEAR(before[0] + before[1] + before[2] - d[0] - d[1] - d[2], dp.dilation * dg, 1e-14);
    EXPECT_NEAR(h[0], dp.strain_per_step() * dg, 1e-14);
  }
}

// The multipliers of A-1.7c: Phi / a on a plane, [[a, b], [b, a]] on an edge.
TEST(PlasticRock, PyramidHasTheConstantsOfItsPlanesAndEdges) {
  const double phi = 35 * kDegree, psi = 10 * kDegree;
  const MohrCoulomb law = pyramid(10e6, phi, psi);
  const double K = law.bulk, G = law.shear, sp = law.sin_phi, ss = law.sin_psi;
  const double a = 4 * G * (1 + sp * ss / 3) + 4 * K * sp * ss;
  PrincipalStress trial{{-5e6, -40e6, -120e6}};
  double e[3], history[kMaxHistory] = {};
  trial.to_strain(K, G, e);
  law.update(e, history, 1e-6);
  const double k = 2 * 10e6 * std::cos(phi);
  const auto phi_of = [&](double x, double y) { return x - y + (x + y) * sp - k; };
  const double dg = phi_of(-5e6, -120e6) / a;
  PrincipalStress s = PrincipalStress::of(e, K, G);
  EXPECT_NEAR(s.tau[0], -5e6 - (2 * G * (1 + ss / 3) + 2 * K * ss) * dg, 1e-3);
  EXPECT_NEAR(s.tau[1], -40e6 + (4 * G / 3 - 2 * K) * ss * dg, 1e-3);
  EXPECT_NEAR(s.tau[2], -120e6 + (2 * G * (1 - ss / 3) - 2 * K * ss) * dg, 1e-3);

  trial = {{-5e6, -118e6, -120e6}};  // s2 near s3: the edge of triaxial compression
  trial.to_strain(K, G, e);
  history[0] = 0;
  law.update(e, history, 1e-6);
  s = PrincipalStress::of(e, K, G);
  const double b = 2 * G * (1 + sp + ss - sp * ss / 3) + 4 * K * sp * ss;
  const double fa = phi_of(-5e6, -120e6), fb = phi_of(-5e6, -118e6);
  const double da = (a * fa - b * fb) / (a * a - b * b), db = (a * fb - b * fa) / (a * a - b * b);
  EXPECT_GT(da, 0);
  EXPECT_GT(db, 0);
  EXPECT_NEAR(s.tau[0], -5e6 - (2 * G * (1 + ss / 3) + 2 * K * ss) * (da + db), 1e-3);
  EXPECT_NEAR(s.tau[1], s.tau[2], 1e-3);
}

// Apex: hydrostatic tension ends at c cot(phi), or at the cut-off, whatever the dilation.
TEST(PlasticRock, ApexAndCutOff) {
  for (const double psi : {0.0, 30 * kDegree}) {
    MohrCoulomb mc = pyramid(10e6, 30 * kDegree, psi);
    DruckerPrager dp = cone(Fit::compression, 10e6, 30 * kDegree, psi);
    const double apex = 10e6 / std::tan(30 * kDegree);
    for (const double cut : {1e300, 4e6}) {
      mc.cut_off = std::min(apex, cut);
      dp.cut_off = cut;
      const double limit = std::min(apex, cut);
      double e[3] = {1e-3, 1.1e-3, 0.9e-3}, history[kMaxHistory] = {};
      double d[3] = {1e-3, 1.0001e-3, 0.9999e-3}, h[kMaxHistory] = {};
      EXPECT_GT(mc.update(e, history, 1e-6), 0);
      EXPECT_GT(dp.update(d, h, 1e-6), 0);
      for (double t : PrincipalStress::of(e, mc.bulk, mc.shear).tau) EXPECT_NEAR(t, limit, 0.1);
      EXPECT_NEAR(PrincipalStress::of(d, dp.bulk, dp.shear).mean(), limit, 0.1);
      EXPECT_GT(history[0], 0);
      EXPECT_GT(h[0], 0);
    }
  }
}

// Rankine: simple tension ends at the cut-off.
TEST(PlasticRock, SimpleTension) {
  MohrCoulomb mc = pyramid(20e6, 40 * kDegree, 0);
  EXPECT_NEAR(mc.uniaxial_tension(), 2 * 20e6 * mc.cos_phi / (1 + mc.sin_phi), 1);
  EXPECT_NEAR(-triaxial_strength(mc, 0, 1), mc.uniaxial_tension(), 100);
  mc.cut_off = 5e6;
  EXPECT_EQ(mc.uniaxial_tension(), 5e6);
  EXPECT_NEAR(-triaxial_strength(mc, 0, 1), 5e6, 5);
  DruckerPrager dp = cone(Fit::compression, 20e6, 40 * kDegree, 0);
  EXPECT_NEAR(-triaxial_strength(dp, 0, 1), dp.uniaxial_tension(), 100);
  dp.cut_off = 2e6;
  EXPECT_NEAR(-triaxial_strength(dp, 0, 1), 6e6, 10);
}

// eq:plastic-8: the strength follows the line to its end, on cone and pyramid; the stress is on the
// surface that the plastic strain says.
TEST(PlasticRock, CohesionSoftens) {
  DruckerPrager dp = cone(Fit::compression, 20e6, 40 * kDegree, 10 * kDegree);
  MohrCoulomb mc = pyramid(20e6, 40 * kDegree, 10 * kDegree);
  dp.cohesion = mc.cohesion = {20e6, 4e6, 0.01};
  PointDriver<DruckerPrager> a{dp};
  PointDriver<MohrCoulomb> b{mc};
  for (int i = 0; i < 200; ++i) {
    a.step_held(-1e-4, 0);
    b.step_held(-1e-4, 0);
    if (i < 40) continue;
    const PrincipalStress s = a.stress();
    EXPECT_NEAR(s.root_j2() + dp.friction * s.mean(), dp.strength(a.history[0]), 20);
    const double ucs = 2 * mc.cohesion.at(b.history[0]) * std::tan(65 * kDegree);
    EXPECT_NEAR(-b.stress().tau[0], ucs, 1e-6 * ucs + 100);
  }
  EXPECT_GT(a.history[0], 0.01);
  EXPECT_NEAR(-b.stress().tau[0], 2 * 4e6 * std::tan(65 * kDegree), 100);
}

// eq:plastic-16, eq:plastic-17: the filter reaches 1 - 0.95^n of a constant rate in n steps, and
// the strength rises by the power of the rate.
TEST(PlasticRock, StrengthRisesWithTheFilteredRate) {
  RateDependent<MohrCoulomb> law;
  static_cast<MohrCoulomb&>(law) = pyramid(20e6, 40 * kDegree, 0);
  law.rate_reference = 1;
  law.rate_exponent = 0.3;
  double e[3] = {0, 0, 0}, history[kMaxHistory] = {};
  for (int i = 0; i < 20; ++i) {
    e[0] -= 1e-7;
    law.update(e, history, 1e-9);
  }
  EXPECT_NEAR(history[2], 100 * (1 - std::pow(0.95, 20)), 1e-6);
  EXPECT_EQ(history[0], 0);
  PointDriver<RateDependent<MohrCoulomb>> point{law};
  for (int i = 0; i < 400; ++i) point.step_held(-2e-5, 0, 2e-7);
  const double ucs = 2 * 20e6 * std::tan(65 * kDegree);
  const double factor = std::pow(point.history[2], 0.3);
  EXPECT_NEAR(-point.stress().tau[0], ucs * factor, 1e-4 * ucs * factor);
  EXPECT_GT(factor, 3);
  EXPECT_EQ(law.factor(0.5), 1);
  law.filter_time = 1e-6;  // a thousand steps
  double f[3] = {0, 0, 0}, slow[kMaxHistory] = {};
  f[0] = -1e-7;
  law.update(f, slow, 1e-9);
  EXPECT_NEAR(slow[2], 0.1, 1e-12);
}

}  // namespace
