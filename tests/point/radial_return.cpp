// Laws that return radially: without principal axes the same as with them.
#include "point/radial_return.hpp"

#include "point/plastic_laws.hpp"
#include "point/principal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace breccia {
namespace {

/// Lets the law return a strain given by its principal values, with axes and without.
template <class Law>
void check_law(Law law, double size) {
  law.bulk = 40e9;
  law.shear = 25e9;
  static_assert(kIsRadial<Law>);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-size, size);
  int flowed = 0;
  for (int i = 0; i < 200; ++i) {
    const double trial[3] = {any(random), any(random), any(random)};
    double strain[3] = {trial[0], trial[1], trial[2]};
    double history[kMaxHistory] = {}, same[kMaxHistory] = {};
    const double work = law.update(strain, history, 1e-6);
    const double trace = trial[0] + trial[1] + trial[2];
    double squared = 0;
    for (const double e : trial) squared += (e - trace / 3) * (e - trace / 3);
    const RadialReturn back = RadialReturn::of(law, trace, squared, same, 1e-6);
    EXPECT_NEAR(back.work, work, 1e-9 * std::abs(work) + 1e-6);
    for (int k = 0; k < 3; ++k) {
      const double e = trace / 3 + back.growth / 3 + back.factor * (trial[k] - trace / 3);
      EXPECT_NEAR(e, strain[k], 1e-12 * size);
    }
    for (int k = 0; k < Law::kHistory; ++k)
      EXPECT_NEAR(same[k], history[k], 1e-9 * std::abs(history[k]) + 1e-15);
    if (back.factor != 1 || back.growth != 0) ++flowed;
  }
  EXPECT_GT(flowed, 20);
}

TEST(RadialReturn, NeedsNoAxes) {
  J2 metal;
  metal.yield = 100e6;
  metal.hardening = 1e9;
  check_law(metal, 0.01);
  RateDependent<DruckerPrager> quick;
  DruckerPrager rock;
  rock.friction = 0.4;
  rock.dilation = 0.2;
  rock.per_cohesion = 1.2;
  rock.cohesion = {10e6, 5e6, 0.01};
  rock.cut_off = 3e6;
  check_law(rock, 0.002);
  static_cast<DruckerPrager&>(quick) = rock;
  check_law(quick, 0.002);
}

// The form for packs is the law.
TEST(RadialReturn, TheClosedFormIsTheLaw) {
  for (const double hardening : {-5e9, 0.0, 2e9}) {
    J2 metal;
    metal.bulk = 40e9;
    metal.shear = 25e9;
    metal.yield = 100e6;
    metal.hardening = hardening;
    for (const double ep : {0.0, 0.015, 0.03})
      for (const double squared : {0.0, 1e-7, 4e-6, 1e-4}) {
        double history[kMaxHistory] = {ep}, same[kMaxHistory] = {ep}, work = 0;
        const RadialReturn law = RadialReturn::of(metal, 0.001, squared, history, 0);
        const double factor = metal.radial(squared, same, work);
        if (squared > 0) {
          EXPECT_NEAR(factor, law.factor, 1e-14);
        }
        EXPECT_NEAR(work, law.work, 1e-13 * (law.work + metal.shear * squared));
        EXPECT_NEAR(same[0], history[0], 1e-15);
      }
  }
}

TEST(RadialReturn, TheSmallExponentialIsTheExponential) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int i = 0; i < 50; ++i) {
    Sym<3> a;
    for (double& x : a.s) x = any(random);
    a *= kSmallExponent / std::sqrt(contract(a, a));
    Principal<3> p = principal_of(a);
    for (double& value : p.value) value = std::exp(value);
    const Sym<3> exact = p.with(p.value), series = small_exponential(a);
    for (int k = 0; k < 6; ++k) EXPECT_NEAR(series.s[k], exact.s[k], 2e-15);
  }
  EXPECT_NEAR(small_exponential(-0.04), std::exp(-0.04), 3e-16);
}

}  // namespace
}  // namespace breccia
