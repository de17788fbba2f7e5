#include "point/plastic_j2.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace breccia;

// eq:plastic-2, eq:plastic-3: simple tension with the lateral strain that keeps the lateral
// stress at zero; the axial stress is yield + H ep and the axial strain tau / E + ep.
TEST(PlasticJ2, SimpleTensionFollowsTheHardeningLine) {
  J2 law;
  law.bulk = 140e9;
  law.shear = 46e9;
  law.yield = 90e6;
  law.hardening = 292e6;
  const double young = 9 * law.bulk * law.shear / (3 * law.bulk + law.shear);
  double e[3] = {0, 0, 0}, history[kMaxHistory] = {};
  double work = 0, plastic_work = 0, before = 0;
  const int steps = 200;
  for (int i = 1; i <= steps; ++i) {
    const double ep = 0.2 * i / steps, tau = law.yield + law.hardening * ep;
    // Total strains of the closed form, minus the plastic ones so far, are the trial.
    const double old = history[0];
    double trial[3] = {tau / young + ep - old, 0, 0};
    const double nu = (3 * law.bulk - 2 * law.shear) / (2 * (3 * law.bulk + law.shear));
    trial[1] = trial[2] = -nu * tau / young - 0.5 * (ep - old);
    plastic_work += law.update(trial, history, 1e-6);
    for (int k = 0; k < 3; ++k) e[k] = trial[k];
    const PrincipalStress s = PrincipalStress::of(e, law.bulk, law.shear);
    EXPECT_NEAR(s.tau[0], tau, 1e-9 * tau);
    EXPECT_NEAR(s.tau[1], 0, 1e-9 * tau);
    EXPECT_NEAR(history[0], ep, 1e-12);
    before = ep;
  }
  work = law.yield * before + 0.5 * law.hardening * before * before;
  EXPECT_NEAR(plastic_work, work, 1e-9 * work);
}

}  // namespace
