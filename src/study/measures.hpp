#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace breccia {

/// Steps of a ladder as falling sizes: the values where they fall, one over them where they grow,
/// nothing where they do neither (words, or values in no order).
std::vector<double> falling_sizes(std::span<const double> values);

/// Order in which errors fall with the size over the last two rungs: log(e1 / e2) / log(h1 / h2).
/// Not-a-number where an error is zero or missing.
double observed_order(std::span<const double> sizes, std::span<const double> errors);

/// The slope of log(error) over log(size) by least squares over all rungs that have an error.
double fitted_order(std::span<const double> sizes, std::span<const double> errors);

/// What a ladder converges to, from its last three rungs: f(h) = value + c h^order.
struct Limit {
  double value = 0;
  double order = 0;
};

/// Richardson's estimate for any ratios of sizes, which fall. Nothing where the values do not
/// converge: fewer than three, equal, alternating, or an order outside 0.2 to 12.
std::optional<Limit> richardson(std::span<const double> sizes, std::span<const double> values);

/// Which points no other one beats in both; points with a missing number are none of them.
std::vector<bool> pareto_front(std::span<const double> costs, std::span<const double> errors);

/// The cheapest point with an error of at most `target`.
std::optional<std::size_t> cheapest(std::span<const double> costs, std::span<const double> errors,
                                    double target);

/// The point of the smallest error; the cheaper one of two.
std::optional<std::size_t> most_accurate(std::span<const double> costs,
                                         std::span<const double> errors);

double median(std::vector<double> values);

/// Points (x, y) of a curve; x grows.
struct Curve {
  std::vector<double> x, y;
};

/// Distance between a curve and the right one over the range of the right one, as the root of the
/// mean square (straight lines between the points of both). \throws Error where the curve does not
/// cover the range.
double distance(const Curve& curve, const Curve& right);

/// Root of the mean square of a curve over its own range.
double size_of(const Curve& curve);

}  // namespace breccia
