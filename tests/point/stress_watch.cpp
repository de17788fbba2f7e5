// The prefilter of the insertion check: a bound on the onset measure over all planes.
#include "point/stress_watch.hpp"

#include "harness/tensors.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace breccia {
namespace {

constexpr double kTensile = 8e6, kCohesion = 24e6, kAlpha = 0.9;
const double kFriction = std::tan(0.8);
const StressWatch kWatch{1 / (kAlpha * kTensile), 1 / (kAlpha * kCohesion), kFriction};

/// Onset measure on the plane of unit normal n over alpha (ALGORITHMS ).
template <int D>
double onset(const Sym<D>& sigma, const Vec<D>& n) {
  const Vec<D> t = sigma * n;
  const double normal = dot(t, n), shear = std::sqrt(std::max(0.0, norm2(t) - normal * normal));
  return std::max(normal / kTensile, (shear + kFriction * normal) / kCohesion) / kAlpha;
}

template <int D>
Sym<D> random_stress(std::uint64_t id) {
  const Random random{3, 8};
  Sym<D> s;
  for (int c = 0; c < Sym<D>::size; ++c)
    s.s[c] = 10e6 * random.normal(id, static_cast<unsigned>(c));
  return s;
}

double largest_over_planes(const Sym<2>& sigma) {
  double most = -1e300;
  for (int k = 0; k < 2000; ++k) {
    const double a = 3.14159265358979 * k / 2000;
    most = std::max(most, onset<2>(sigma, {{std::cos(a), std::sin(a)}}));
  }
  return most;
}

double largest_over_planes(const Sym<3>& sigma) {
  double most = -1e300;
  for (int k = 0; k < 4000; ++k) {  // points of a spiral on the half sphere
    const double z = (k + 0.5) / 4000, r = std::sqrt(1 - z * z), a = 2.399963229728653 * k;
    most = std::max(most, onset<3>(sigma, {{r * std::cos(a), r * std::sin(a), z}}));
  }
  return most;
}

TEST(StressWatch, InThePlaneIsTheLargestOnsetOfAllFaces) {
  for (std::uint64_t id = 0; id < 300; ++id) {
    const Sym<2> s = random_stress<2>(id);
    const double sampled = largest_over_planes(s), reach = kWatch.reach(s);
    EXPECT_GE(reach, sampled - 1e-12) << id;
    EXPECT_LE(reach, sampled + 1e-4 * (1 + std::abs(sampled))) << id;  // 2000 directions
  }
}

TEST(StressWatch, InSpaceIsNeverBelowAnyFace) {
  for (std::uint64_t id = 0; id < 300; ++id) {
    const Sym<3> s = random_stress<3>(id);
    EXPECT_GE(kWatch.reach(s), largest_over_planes(s)) << id;
  }
}

// Uniaxial tension is where the bound in space is reached: an intact body must not be hot below
// its strength.
TEST(StressWatch, InSpaceIsExactInUniaxialTension) {
  const Sym<3> s = spectral(random_rotation<3>(Random{1, 1}, 5), Vec<3>{{kAlpha * kTensile, 0, 0}});
  EXPECT_NEAR(kWatch.reach(s), 1, 1e-12);
}

TEST(StressWatch, AverageOfTwoElementsIsBelowTheLarger) {
  for (std::uint64_t id = 0; id < 300; ++id) {
    const Sym<3> a = random_stress<3>(2 * id), b = random_stress<3>(2 * id + 1);
    EXPECT_LE(kWatch.reach((a + b) * 0.5), std::max(kWatch.reach(a), kWatch.reach(b)) + 1e-12);
  }
}

TEST(StressWatch, IsOffWithoutAStrength) {
  EXPECT_FALSE(StressWatch{}.on());
  EXPECT_TRUE(kWatch.on());
}

}  // namespace
}  // namespace breccia
