#include "study/measures.hpp"

#include "core/error.hpp"
#include "core/text.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace breccia {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Mean square over x of what is linear between points.
double mean_square(const Curve& c) {
  double sum = 0;
  for (std::size_t i = 1; i < c.x.size(); ++i) {
    const double a = c.y[i - 1], b = c.y[i];
    sum += (c.x[i] - c.x[i - 1]) * (a * a + a * b + b * b) / 3;
  }
  return sum / (c.x.back() - c.x.front());
}

double value_at(const Curve& c, double x) {
  const auto after = std::lower_bound(c.x.begin(), c.x.end(), x);
  if (after == c.x.begin()) return c.y.front();
  if (after == c.x.end()) return c.y.back();
  const auto i = static_cast<std::size_t>(after - c.x.begin());
  const double share = (x - c.x[i - 1]) / (c.x[i] - c.x[i - 1]);
  return c.y[i - 1] + share * (c.y[i] - c.y[i - 1]);
}

/// (f3 - f2) / (f2 - f1) of f = h^p with h3 / h1 = a, h2 / h1 = b; it grows with p.
double ratio_of(double a, double b, double p) {
  return (std::pow(a, p) - std::pow(b, p)) / (std::pow(b, p) - 1);
}

}  // namespace

std::vector<double> falling_sizes(std::span<const double> values) {
  const auto all = [&](const std::function<bool(double, double)>& in_order) {
    for (std::size_t i = 0; i < values.size(); ++i)
      if (!(values[i] > 0) || (i > 0 && !in_order(values[i - 1], values[i]))) return false;
    return true;
  };
  std::vector<double> sizes(values.begin(), values.end());
  if (all(std::greater<>())) return sizes;
  if (!all(std::less<>())) return {};
  for (double& size : sizes) size = 1 / size;
  return sizes;
}

double observed_order(std::span<const double> sizes, std::span<const double> errors) {
  const std::size_t n = errors.size();
  if (n < 2 || sizes.size() != n) return none;
  const double coarse = errors[n - 2], fine = errors[n - 1];
  if (!(coarse > 0) || !(fine > 0)) return none;
  return std::log(coarse / fine) / std::log(sizes[n - 2] / sizes[n - 1]);
}

double fitted_order(std::span<const double> sizes, std::span<const double> errors) {
  if (sizes.size() != errors.size()) return none;
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    if (!(errors[i] > 0) || !std::isfinite(errors[i])) continue;
    const double u = std::log(sizes[i]), v = std::log(errors[i]);
    n += 1, x += u, y += v, xx += u * u, xy += u * v;
  }
  return n < 2 ? none : (n * xy - x * y) / (n * xx - x * x);
}

std::optional<Limit> richardson(std::span<const double> sizes, std::span<const double> values) {
  constexpr double lowest = 0.2, highest = 12;
  const std::size_t n = values.size();
  if (n < 3 || sizes.size() != n) return std::nullopt;
  const double f1 = values[n - 1], f2 = values[n - 2], f3 = values[n - 3];
  const double a = sizes[n - 3] / sizes[n - 1], b = sizes[n - 2] / sizes[n - 1];
  const double seen = (f3 - f2) / (f2 - f1);
  if (!std::isfinite(seen)) return std::nullopt;
  if (seen < ratio_of(a, b, lowest) || seen > ratio_of(a, b, highest)) return std::nullopt;
  double low = lowest, high = highest;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (ratio_of(a, b, middle) < seen ? low : high) = middle;
  }
  const double order = 0.5 * (low + high);
  return Limit{f1 + (f1 - f2) / (std::pow(b, order) - 1), order};
}

std::vector<bool> pareto_front(std::span<const double> costs, std::span<const double> errors) {
  const auto beats = [&](std::size_t a, std::size_t b) {
    const bool as_good = costs[a] <= costs[b] && errors[a] <= errors[b];
    return as_good && (costs[a] < costs[b] || errors[a] < errors[b]);
  };
  std::vector<bool> front(costs.size());
  for (std::size_t i = 0; i < costs.size(); ++i) {
    front[i] = std::isfinite(costs[i]) && std::isfinite(errors[i]);
    for (std::size_t j = 0; j < costs.size(); ++j)
      if (beats(j, i)) front[i] = false;
  }
  return front;
}

std::optional<std::size_t> cheapest(std::span<const double> costs, std::span<const double> errors,
                                    double target) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    if (!std::isfinite(costs[i]) || !(errors[i] <= target)) continue;
    if (!best || costs[i] < costs[*best]) best = i;
  }
  return best;
}

std::optional<std::size_t> most_accurate(std::span<const double> costs,
                                         std::span<const double> errors) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    if (!std::isfinite(costs[i]) || !std::isfinite(errors[i])) continue;
    const bool better = !best || errors[i] < errors[*best] ||
                        (errors[i] == errors[*best] && costs[i] < costs[*best]);
    if (better) best = i;
  }
  return best;
}

double median(std::vector<double> values) {
  if (values.empty()) return none;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

double distance(const Curve& curve, const Curve& right) {
  const double slack = 1e-9 * (right.x.back() - right.x.front());
  if (curve.x.empty() || right.x.front() < curve.x.front() - slack ||
      right.x.back() > curve.x.back() + slack) {
    throw Error("",
                "the curve does not reach over the range of its table, " +
                    number_text(right.x.front()) + " to " + number_text(right.x.back()),
                "let the run last longer, or shorten the table");
  }
  Curve difference;
  difference.x = right.x;
  for (const double x : curve.x)
    if (x > right.x.front() && x < right.x.back()) difference.x.push_back(x);
  std::sort(difference.x.begin(), difference.x.end());
  for (const double x : difference.x)
    difference.y.push_back(value_at(curve, x) - value_at(right, x));
  return std::sqrt(mean_square(difference));
}

double size_of(const Curve& curve) {
  return std::sqrt(mean_square(curve));
}

}  // namespace breccia
