#include "core/error.hpp"
#include "harness/failures.hpp"
#include "study/measures.hpp"

#include <cmath>

namespace breccia {
namespace {

using Numbers = std::vector<double>;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

TEST(StudyOrder, SizesFallWhicheverWayTheLadderIsWritten) {
  EXPECT_EQ(falling_sizes(Numbers{4, 2, 1}), (Numbers{4, 2, 1}));
  EXPECT_EQ(falling_sizes(Numbers{1, 2, 4}), (Numbers{1, 0.5, 0.25}));  // a stiffness
  EXPECT_TRUE(falling_sizes(Numbers{1, 4, 2}).empty());
  EXPECT_TRUE(falling_sizes(Numbers{2, 2, 1}).empty());
  EXPECT_TRUE(falling_sizes(Numbers{1, 0, -1}).empty());
  EXPECT_TRUE(falling_sizes(Numbers{none, none}).empty());  // words
}

TEST(StudyOrder, IsTheSlopeOfTheLastTwoRungs) {
  const Numbers sizes{1, 0.5, 0.1};
  EXPECT_NEAR(observed_order(sizes, Numbers{7, 0.25, 0.01}), 2, 1e-12);
  EXPECT_NEAR(observed_order(sizes, Numbers{7, 0.1, 0.2}), -0.430677, 1e-6);
  EXPECT_TRUE(std::isnan(observed_order(sizes, Numbers{7, 0.25, 0})));
  EXPECT_TRUE(std::isnan(observed_order(sizes, Numbers{7, none, 1})));
  EXPECT_TRUE(std::isnan(observed_order({}, Numbers{})));
}

TEST(StudyOrder, FittedOverAllRungsThatHaveAnError) {
  const Numbers sizes{1, 0.5, 0.25, 0.125};
  EXPECT_NEAR(fitted_order(sizes, Numbers{1, none, 0.125, 0.044194173824159216}), 1.5, 1e-12);
  EXPECT_TRUE(std::isnan(fitted_order(sizes, Numbers{1, none, none, 0})));
}

TEST(StudyRichardson, FindsLimitAndOrderForAnyRatios) {
  const auto f = [](double h) { return 3 - 0.7 * std::pow(h, 1.7); };
  const Numbers sizes{1, 0.4, 0.3, 0.1};
  const auto limit = richardson(sizes, Numbers{f(1), f(0.4), f(0.3), f(0.1)});
  ASSERT_TRUE(limit.has_value());
  EXPECT_NEAR(limit->value, 3, 1e-9);
  EXPECT_NEAR(limit->order, 1.7, 1e-9);
}

TEST(StudyRichardson, RefusesWhatDoesNotConverge) {
  const Numbers sizes{4, 2, 1};
  EXPECT_FALSE(richardson(sizes, Numbers{1, 2, 3}));       // equal steps: order 0
  EXPECT_FALSE(richardson(sizes, Numbers{1, 2, 4}));       // ever larger steps
  EXPECT_FALSE(richardson(sizes, Numbers{1, 2, 1.5}));     // to and fro
  EXPECT_FALSE(richardson(sizes, Numbers{1, 2, 2}));       // no last step
  EXPECT_FALSE(richardson(sizes, Numbers{1, none, 1.5}));  // a job that failed
  EXPECT_FALSE(richardson(Numbers{2, 1}, Numbers{1, 2}));
}

TEST(StudyFront, IsWhatNoOtherBeatsInBoth) {
  const Numbers costs{1, 2, 3, 3, 4, none, 5};
  const Numbers errors{9, 5, 5, 4, 4.5, 1, none};
  EXPECT_EQ(pareto_front(costs, errors),
            (std::vector<bool>{true, true, false, true, false, false, false}));
}

TEST(StudyFront, KeepsTwins) {
  EXPECT_EQ(pareto_front(Numbers{1, 1}, Numbers{2, 2}), (std::vector<bool>{true, true}));
}

TEST(StudyTargets, TheCheapestThatReachesThem) {
  const Numbers costs{1, 5, 3, 2}, errors{0.2, 0.001, 0.04, none};
  EXPECT_EQ(cheapest(costs, errors, 0.05), 2u);
  EXPECT_EQ(cheapest(costs, errors, 0.001), 1u);
  EXPECT_FALSE(cheapest(costs, errors, 0.0005));
  EXPECT_EQ(most_accurate(costs, errors), 1u);
  EXPECT_EQ(most_accurate(Numbers{2, 1}, Numbers{3, 3}), 1u);
  EXPECT_FALSE(most_accurate(Numbers{1}, Numbers{none}));
}

TEST(StudyTargets, MedianOfRepeats) {
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1, 2, 3}), 2.5);
  EXPECT_TRUE(std::isnan(median({})));
}

TEST(StudyCurves, DistanceIsTheRootOfTheMeanSquare) {
  const Curve right{{0, 1, 2}, {0, 0, 0}};
  EXPECT_NEAR(distance({{0, 2}, {0, 2}}, right), std::sqrt(4.0 / 3), 1e-12);  // y = x
  EXPECT_NEAR(distance({{0, 1, 2}, {0, 3, 0}}, {{0, 2}, {0, 0}}), std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(distance({{-1, 3}, {5, 5}}, right), 5, 1e-12);
  EXPECT_NEAR(size_of({{0, 1, 4}, {3, 3, 3}}), 3, 1e-12);
}

TEST(StudyCurves, MustReachOverTheTable) {
  const Curve right{{0, 1}, {0, 1}};
  EXPECT_THROW(distance({{0, 0.9}, {0, 1}}, right), Error);
  EXPECT_THROW(distance({{0.1, 1}, {0, 1}}, right), Error);
  EXPECT_NO_THROW(distance({{0, 1}, {0, 1}}, right));
}

}  // namespace
}  // namespace breccia
