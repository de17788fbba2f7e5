#include "batch/sampling.hpp"
#include "core/error.hpp"
#include "harness/failures.hpp"
#include "io/scene_reader.hpp"
#include "scene/schema_rules.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace breccia {
namespace {

using testing::HasSubstr;

Distribution distribution(const std::string& parameters) {
  Schema schema;
  declare_batch_keys(schema);
  const Settings scene = schema.resolve(
      read_scene_text("[batch]\n[[batch.uncertain]]\nkey = \"a.b\"\n" + parameters, "sweep"));
  return Distribution(scene.at("batch").list("uncertain").front());
}

struct Moments {
  double mean = 0, deviation = 0;
};

Moments moments(const Distribution& d, const std::vector<double>& shares) {
  Moments m;
  const auto n = static_cast<double>(shares.size());
  for (const double share : shares) m.mean += d.quantile(share) / n;
  for (const double share : shares)
    m.deviation += (d.quantile(share) - m.mean) * (d.quantile(share) - m.mean) / n;
  m.deviation = std::sqrt(m.deviation);
  return m;
}

/// Middles of equal shares: with so many of them sums are integrals.
std::vector<double> middles(std::size_t n) {
  std::vector<double> shares(n);
  for (std::size_t i = 0; i < n; ++i)
    shares[i] = (static_cast<double>(i) + 0.5) / static_cast<double>(n);
  return shares;
}

TEST(BatchSampling, NormalHasItsQuantiles) {
  const Distribution d =
      distribution("distribution = \"normal\"\nmean = \"10 MPa\"\nstd_deviation = \"2 MPa\"");
  EXPECT_NEAR(d.quantile(0.5), 10e6, 1e-3);
  EXPECT_NEAR(d.quantile(0.8413447460685429), 12e6, 1e-3);  // one deviation above
  EXPECT_NEAR(d.quantile(0.0013498980316301), 4e6, 1e-3);   // three below
  EXPECT_EQ(d.unit_text(), "Pa");
}

TEST(BatchSampling, MeansAndDeviationsAreThoseGiven) {
  const auto shares = middles(20000);
  for (const char* kind : {"normal", "lognormal"}) {
    const Moments m = moments(
        distribution(std::string("distribution = \"") + kind + "\"\nmean = 10\nstd_deviation = 3"),
        shares);
    EXPECT_NEAR(m.mean, 10, 1e-3) << kind;
    EXPECT_NEAR(m.deviation, 3, 1e-2) << kind;
  }
  const Moments uniform =
      moments(distribution("distribution = \"uniform\"\nlower_bound = 2\nupper_bound = 8"), shares);
  EXPECT_NEAR(uniform.mean, 5, 1e-9);
  EXPECT_NEAR(uniform.deviation, 6 / std::sqrt(12.0), 1e-6);
  const Moments weibull =
      moments(distribution("distribution = \"weibull\"\nscale = 7\nshape = 2"), shares);
  EXPECT_NEAR(weibull.mean, 7 * std::tgamma(1.5), 1e-3);
  const Distribution log =
      distribution("distribution = \"loguniform\"\nlower_bound = 1\nupper_bound = 100");
  EXPECT_NEAR(log.quantile(0.5), 10, 1e-12);
}

TEST(BatchSampling, BoundsCutWithoutHeaping) {
  for (const char* kind : {"distribution = \"normal\"\nmean = 10\nstd_deviation = 3\n",
                           "distribution = \"lognormal\"\nmean = 10\nstd_deviation = 3\n",
                           "distribution = \"weibull\"\nscale = 10\nshape = 3\n"}) {
    const Distribution d = distribution(std::string(kind) + "lower_bound = 9\nupper_bound = 12");
    EXPECT_NEAR(d.quantile(1e-12), 9, 1e-6) << kind;
    EXPECT_NEAR(d.quantile(1 - 1e-12), 12, 1e-6) << kind;
    EXPECT_LT(d.quantile(0.1), d.quantile(0.2)) << kind;
  }
}

TEST(BatchSampling, ParametersMustFit) {
  EXPECT_THAT(error_text([] {
                distribution("distribution = \"normal\"\nmean = \"1 m\"\nstd_deviation = 1");
              }),
              HasSubstr("is a pure number, mean is a length"));
  EXPECT_THAT(error_text([] {
                distribution("distribution = \"loguniform\"\nlower_bound = 0\nupper_bound = 1");
              }),
              HasSubstr("lower_bound: 0 is not above 0"));
}

TEST(BatchSampling, ASampleDoesNotDependOnTheirNumber) {
  const auto few = Sampling{10, 3, false}.shares(0), many = Sampling{1000, 3, false}.shares(0);
  EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
  EXPECT_NE(many, (Sampling{1000, 4, false}.shares(0)));
  EXPECT_NE(many, (Sampling{1000, 3, false}.shares(1)));
  EXPECT_NEAR(std::accumulate(many.begin(), many.end(), 0.0) / 1000, 0.5, 0.03);
}

TEST(BatchSampling, AHypercubeHasOneSampleInEveryShare) {
  constexpr std::size_t n = 50;
  const Sampling sampling{n, 1, true};
  const auto first = sampling.shares(0), second = sampling.shares(1);
  std::vector<std::size_t> cells;
  for (const double share : first) cells.push_back(static_cast<std::size_t>(share * n));
  EXPECT_FALSE(std::is_sorted(cells.begin(), cells.end()));
  std::sort(cells.begin(), cells.end());
  for (std::size_t i = 0; i < n; ++i) EXPECT_EQ(cells[i], i);
  EXPECT_NE(first, second);
  EXPECT_EQ(first, sampling.shares(0));
}

}  // namespace
}  // namespace breccia
