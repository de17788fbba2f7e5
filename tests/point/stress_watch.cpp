// The prefilter of the insertion check: a bound on the onset measure over all planes.
#include "point/stress_watch.hpp"

#include "harness/tensors.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace breccia {
namespace {

constexpr double kTensile = 8e6, kCohesion = 24e6, kAlpha = 0.9;
const double kFriction = std::tan(0.8);

/// What the watch takes the onset to be at most: the factor of the strengths that leaves no room.
template <int D>
double reach(const Sym<D>& sigma) {
  const StressWatch<D> watch(1 / (kAlpha * kTensile), 1 / (kAlpha * kCohesion), kFriction);
  double low = -100, high = 100;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    (watch.room(sigma, middle) > 0 ? high : low) = middle;
  }
  return high;
}

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
    const double sampled = largest_over_planes(s), bound = reach(s);
    EXPECT_GE(bound, sampled - 1e-12) << id;
    EXPECT_LE(bound, sampled + 1e-4 * (1 + std::abs(sampled))) << id;  // 2000 directions
  }
}

TEST(StressWatch, InSpaceIsNeverBelowAnyFace) {
  for (std::uint64_t id = 0; id < 300; ++id) {
    const Sym<3> s = random_stress<3>(id);
    EXPECT_GE(reach(s), largest_over_planes(s)) << id;
  }
}

// Uniaxial tension is where the bound in space is reached: an intact body must not be hot below
// its strength.
TEST(StressWatch, InSpaceIsExactInUniaxialTension) {
  const Sym<3> s = spectral(random_rotation<3>(Random{1, 1}, 5), Vec<3>{{kAlpha * kTensile, 0, 0}});
  EXPECT_NEAR(reach(s), 1, 1e-12);
}

TEST(StressWatch, AverageOfTwoElementsIsBelowTheLarger) {
  for (std::uint64_t id = 0; id < 300; ++id) {
    const Sym<3> a = random_stress<3>(2 * id), b = random_stress<3>(2 * id + 1);
    EXPECT_LE(reach((a + b) * 0.5), std::max(reach(a), reach(b)) + 1e-12);
  }
}

// The Kirchhoff stress is J times the Cauchy stress that the bound is about.
TEST(StressWatch, JudgesTheCauchyStress) {
  const StressWatch<2> watch(1 / kTensile, 1 / kCohesion, kFriction);
  const Sym<2> s{{kTensile * (1 - 1e-9), 0, 0}}, over{{kTensile * (1 + 1e-9), 0, 0}};
  for (const double jacobian : {0.5, 1.0, 1.5}) {
    EXPECT_GT(watch.room(s * jacobian, jacobian), 0);
    EXPECT_LT(watch.room(over * jacobian, jacobian), 0);
  }
}

// What is passed over without a closer look has room; what is well below any strength is passed.
template <int D>
void check_far() {
  const StressWatch<D> watch(1 / (kAlpha * kTensile), 1 / (kAlpha * kCohesion), kFriction);
  int far = 0;
  for (std::uint64_t id = 0; id < 2000; ++id) {
    const Sym<D> s = random_stress<D>(id) * (0.1 + 0.001 * static_cast<double>(id % 500));
    EXPECT_TRUE(watch.is_far(s * 0.05, 1.0));
    if (!watch.is_far(s, 1.0)) continue;
    EXPECT_GT(watch.room(s, 1.0), 0);
    ++far;
  }
  EXPECT_GT(far, 200);
}

TEST(StressWatch, PassesOnlyOverWhatHasRoom) {
  check_far<2>();
  check_far<3>();
}

TEST(StressWatch, IsOffWithoutAStrength) {
  EXPECT_FALSE(StressWatch<2>{}.on);
  EXPECT_FALSE(StressWatch<3>(0, 0, 0).on);
  EXPECT_TRUE(StressWatch<3>(1, 1, 0).on);
}

}  // namespace
}  // namespace breccia
