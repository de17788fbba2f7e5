// Packs of doubles and the series that laws sum over them: each lane must be what one double is,
// whatever its neighbours are.
#include "base/pack.hpp"

#include "base/series.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace breccia {
namespace {

using R = HostPack;
constexpr int kLanes = lanes<R>();

/// Runs `check` with every number of first lanes holding `a` and the others `b`.
template <class Check>
void with_split_packs(double a, double b, const Check& check) {
  for (int k = 0; k <= kLanes; ++k) {
    SCOPED_TRACE(k);
    check(fill<R>([&](int l) { return l < k ? a : b; }), k);
  }
}

TEST(Pack, ComparisonsSeeEveryLane) {
  with_split_packs(2.0, 1.0, [](const R& x, int twos) {
    EXPECT_EQ(any(R(1.5) < x), twos > 0);
    EXPECT_EQ(any(x < R(1.5)), twos < kLanes);
    EXPECT_EQ(any(x <= R(1.0)), twos < kLanes);
    EXPECT_EQ(any(!(x <= R(1.0))), twos > 0);
    EXPECT_FALSE(any(x < R(1.0)));
    EXPECT_FALSE(any(R(2.0) < x));
  });
  with_split_packs(std::nan(""), 1.0, [](const R& x, int nans) {
    EXPECT_EQ(any(!(x <= R(9.0))), nans > 0);
    EXPECT_EQ(any(!(R(0.0) < x)), nans > 0);
  });
}

TEST(Pack, StoresWhatItLoads) {
  double from[kLanes], to[kLanes];
  for (int l = 0; l < kLanes; ++l) from[l] = 1.5 * l;
  store(load<R>(from), to);
  for (int l = 0; l < kLanes; ++l) EXPECT_EQ(to[l], from[l]);
  store(map_lanes(load<R>(from), [](double x) { return x + 1; }), to);
  for (int l = 0; l < kLanes; ++l) EXPECT_EQ(to[l], from[l] + 1);
}

template <class F, class G>
void check_lanes(double a, double b, const F& packed, const G& exact, double allowed) {
  with_split_packs(a, b, [&](const R& x, int k) {
    double y[kLanes];
    store(packed(x), y);
    for (int l = 0; l < kLanes; ++l) {
      const double expected = exact(l < k ? a : b);
      EXPECT_NEAR(y[l], expected, allowed * std::abs(expected)) << a << ' ' << b << " lane " << l;
    }
  });
}

TEST(Pack, ElementaryFunctions) {
  for (const double a : {0.3, 4.0, 1e6}) {
    check_lanes(
        a, 2.0, [](const R& x) { return square_root(x); }, [](double x) { return std::sqrt(x); },
        0);
    check_lanes(
        -a, 2.0, [](const R& x) { return absolute(x); }, [](double x) { return std::abs(x); }, 0);
    check_lanes(
        a, -a, [](const R& x) { return maximum(x, R(1.0)); },
        [](double x) { return std::max(x, 1.0); }, 0);
    check_lanes(
        a, -a, [](const R& x) { return minimum(x, R(1.0)); },
        [](double x) { return std::min(x, 1.0); }, 0);
  }
}

// On both sides of the reach of the series, in all lanes and in some.
TEST(Series, LogarithmIsExactInEveryLane) {
  for (const double j : {0.05, 0.5, 0.7, 0.76, 0.9, 1.0 + 1e-9, 1.2, 1.32, 1.4, 3.0, 50.0})
    check_lanes(
        j, 1.01, [](const R& x) { return log_near_one(x); }, [](double x) { return std::log(x); },
        2e-15);
}

TEST(Series, InverseTangentIsExactInEveryLane) {
  for (const double y : {1e-12, 1e-3, 0.0199, 0.0201, 0.1, 0.5, 0.9, 0.999})
    check_lanes(
        y, 1e-4, [](const R& x) { return atanh_ratio(x); },
        [](double x) { return std::atanh(std::sqrt(x)) / std::sqrt(x); }, 2e-15);
}

// What shares a register with an element changes with the number of ranks; its bits must not.
TEST(Series, NeighboursChangeNoBit) {
  const auto same = [](double a, double b, const auto& f) {
    check_lanes(
        a, b, f,
        [&f](double x) {
          double lane[kLanes];
          store(f(R(x)), lane);
          return lane[0];
        },
        0);
  };
  for (const double far : {0.3, 0.9, 5.0}) {
    same(1.003, far, [](const R& x) { return log_near_one(x); });
    same(0.003, far, [](const R& x) { return log_of_one_plus(x); });
    same(1e-5, 0.1 * far, [](const R& x) { return atanh_ratio(x); });
    same(1e-5, 0.1 * far, [](const R& x) { return atanh_ratio_slope(x); });
  }
}

TEST(Series, OfOneDoubleIsTheSame) {
  for (const double y : {1e-6, 0.0199, 0.0201, 0.9})
    EXPECT_NEAR(atanh_ratio(y), std::atanh(std::sqrt(y)) / std::sqrt(y), 2e-15);
  for (const double j : {0.2, 0.99, 1.3, 4.0})
    EXPECT_NEAR(log_near_one(j), std::log(j), 2e-15 * std::abs(std::log(j)));
}

}  // namespace
}  // namespace breccia
