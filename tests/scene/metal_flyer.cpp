// V-086: a copper plate hits one twice as thick: elastic precursor, plastic front, plateau, spall.
#include "impact_samples.hpp"

#include <gtest/gtest.h>

namespace {

using namespace breccia;

constexpr double kDensity = 8930, kSound = 3940, kSlope = 1.489;  // Marsh 1980
constexpr double kShear = 47e9, kYield = 120e6, kStrength = 1.3e9;
constexpr double kThickness = 10e-3, kSpeed = 500;

TEST(MetalFlyerSlow, PrecursorPlateauAndSpall) {
  const double bulk = kDensity * kSound * kSound;
  const double poisson = (3 * bulk - 2 * kShear) / (2 * (3 * bulk + kShear));
  const double elastic = std::sqrt((bulk + 4 * kShear / 3) / kDensity);
  const std::string material = fmt::format(
      "[material.m]\ndensity = {}\nelastic = {{ young = {}, poisson = {} }}\nj2 = {{ yield = {} "
      "}}\n"
      "eos = {{ mie_gruneisen = {{ c0 = {}, s = {}, gruneisen = 1.99 }} }}\n",
      kDensity, 2 * kShear * (1 + poisson), poisson, kYield, kSound, kSlope);
  // A ductile metal spends some 10 kJ/m2; fronts of some elements ask for about as much.
  const std::string fracture = fmt::format(
      "[fracture.m]\ntensile_strength = {}\ncohesion = {}\nenergy_tension = 4e4\n"
      "energy_shear = 1e8\n",
      kStrength, 20 * kStrength);
  const Trace t = run_plates(plates(kThickness, 200, kSpeed, material + fracture), 10.5e-6);

  // The limit of elastic uniaxial strain, doubled by the free surface.
  const double limit = kYield * (1 - poisson) / (1 - 2 * poisson);
  const double foot = 2 * limit / (kDensity * elastic);
  const double first = 2 * kThickness / elastic;
  const double second = 2 * kThickness / (kSound + kSlope * kSpeed / 2);
  const double seen = t.mean(first + 0.35 * (second - first), first + 0.7 * (second - first));
  EXPECT_NEAR(seen, foot, 0.05 * foot);
  EXPECT_NEAR(t.arrival(foot / 2), first, 0.01 * first);
  EXPECT_NEAR(t.arrival(kSpeed / 2), second, 0.01 * second);
  const double plateau = t.mean(second + 0.3e-6, second + 2e-6);
  EXPECT_NEAR(plateau, kSpeed, 0.005 * kSpeed);

  ASSERT_FALSE(t.plane.empty());
  // The sign of the crack runs at the elastic speed into a release that runs at that of the bulk:
  // 2 / (1/c_b + 1/c_d) instead of c_b (G. V. Stepanov 1976).
  const double fall = plateau - t.least(second + 2e-6, 10.5e-6);
  const double strength = kDensity * fall / (1 / kSound + 1 / elastic);
  EXPECT_NEAR(strength, kStrength, 0.05 * kStrength);
  std::printf(
      "foot %+.2f %%, precursor %+.2f %%, plastic front %+.2f %%, plateau %+.3f %%, strength %+.2f "
      "%%"
      " (with the speed of the bulk %+.2f %%), %zu planes\n",
      100 * (seen / foot - 1), 100 * (t.arrival(foot / 2) / first - 1),
      100 * (t.arrival(kSpeed / 2) / second - 1), 100 * (plateau / kSpeed - 1),
      100 * (strength / kStrength - 1), 100 * (kDensity * kSound * fall / 2 / kStrength - 1),
      t.plane.size());
}

}  // namespace
