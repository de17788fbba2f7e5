#include "core/expression_value.hpp"

#include "core/text.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace breccia {

namespace {

using Series = std::vector<double>;
using Arguments = std::vector<ExpressionValue>;
using Unary = double (*)(double);

[[noreturn]] void fail(const std::string& cause, const std::string& remedy = {}) {
  throw Error("", cause, remedy);
}

const Series& series_of(const std::string& name, const Arguments& a, const Series& time) {
  if (!a[0].is_series) {
    fail("the first argument of " + name + "() must be a series",
         "a series is a sensor, such as load.y, or time");
  }
  if (a[0].series.size() != time.size() || time.empty()) {
    fail("the series in " + name + "() has " + std::to_string(a[0].series.size()) + " values for " +
         std::to_string(time.size()) + " times");
  }
  return a[0].series;
}

double scalar_of(const std::string& name, const Arguments& a, std::size_t i) {
  if (a[i].is_series) {
    fail("argument " + std::to_string(i + 1) + " of " + name + "() must be a number, not a series");
  }
  return a[i].scalar;
}

ExpressionValue each(const ExpressionValue& a, const std::function<double(double)>& f) {
  if (!a.is_series) return f(a.scalar);
  Series out(a.series.size());
  std::transform(a.series.begin(), a.series.end(), out.begin(), f);
  return out;
}

ExpressionValue pairwise(const ExpressionValue& a, const ExpressionValue& b,
                         const std::function<double(double, double)>& f) {
  if (!a.is_series && !b.is_series) return f(a.scalar, b.scalar);
  if (a.is_series && b.is_series && a.series.size() != b.series.size()) {
    fail("two series of different lengths: " + std::to_string(a.series.size()) + " and " +
         std::to_string(b.series.size()));
  }
  Series out(a.is_series ? a.series.size() : b.series.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = f(a.is_series ? a.series[i] : a.scalar, b.is_series ? b.series[i] : b.scalar);
  }
  return out;
}

/// Linear between the samples. \throws Error outside of them.
double value_at(const Series& s, const Series& time, double t) {
  const double reach = 1e-9 * (time.back() - time.front());  // a last row written a round-off early
  if (t < time.front() - reach || t > time.back() + reach) {
    fail("time " + number_text(t) + " s is outside of the run, " + number_text(time.front()) +
         " s to " + number_text(time.back()) + " s");
  }
  const auto after = std::lower_bound(time.begin(), time.end(), t) - time.begin();
  const auto i = static_cast<std::size_t>(after);
  if (i == 0) return s.front();
  if (i == time.size()) return s.back();
  const double w = (t - time[i - 1]) / (time[i] - time[i - 1]);
  return (1 - w) * s[i - 1] + w * s[i];
}

double arrival(const Series& s, const Series& time, double threshold) {
  for (std::size_t i = 0; i < s.size(); ++i) {
    const double now = std::abs(s[i]);
    if (now < threshold) continue;
    if (i == 0) return time[0];
    const double before = std::abs(s[i - 1]);
    return time[i - 1] + (threshold - before) / (now - before) * (time[i] - time[i - 1]);
  }
  fail("the series never reaches " + number_text(threshold) + " in arrival()");
}

double integral(const Series& s, const Series& time) {
  double sum = 0;
  for (std::size_t i = 1; i < s.size(); ++i) {
    sum += 0.5 * (s[i] + s[i - 1]) * (time[i] - time[i - 1]);
  }
  return sum;
}

double mean(const Series& s, const Series& time) {
  const double length = time.back() - time.front();
  return length > 0 ? integral(s, time) / length : s.front();
}

double mean_between(const Series& s, const Series& time, double from, double to) {
  if (!(to > from)) fail("mean() from " + number_text(from) + " s to " + number_text(to) + " s");
  Series inside{value_at(s, time, from)}, at{from};
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (time[i] <= from || time[i] >= to) continue;
    inside.push_back(s[i]);
    at.push_back(time[i]);
  }
  inside.push_back(value_at(s, time, to));
  at.push_back(to);
  return integral(inside, at) / (to - from);
}

/// Line of least squares through the samples of the interval.
double slope(const Series& s, const Series& time, double from, double to) {
  double n = 0, mean_t = 0, mean_s = 0;
  const auto inside = [&](std::size_t i) { return time[i] >= from && time[i] <= to; };
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (!inside(i)) continue;
    n += 1;
    mean_t += time[i];
    mean_s += s[i];
  }
  if (n < 2) {
    fail("fewer than two samples between " + number_text(from) + " s and " + number_text(to) +
             " s in slope()",
         "make output.history shorter or the interval longer");
  }
  mean_t /= n;
  mean_s /= n;
  double st = 0, tt = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (!inside(i)) continue;
    st += (time[i] - mean_t) * (s[i] - mean_s);
    tt += (time[i] - mean_t) * (time[i] - mean_t);
  }
  return st / tt;
}

std::size_t index_of_peak(const Series& s) {
  const auto less = [](double a, double b) { return std::abs(a) < std::abs(b); };
  return static_cast<std::size_t>(std::max_element(s.begin(), s.end(), less) - s.begin());
}

struct Pointwise {
  const char* name;
  Unary function;
};

constexpr Pointwise pointwise[] = {
    {"sqrt", [](double x) { return std::sqrt(x); }},
    {"abs", [](double x) { return std::abs(x); }},
    {"sin", [](double x) { return std::sin(x); }},
    {"cos", [](double x) { return std::cos(x); }},
    {"tan", [](double x) { return std::tan(x); }},
    {"asin", [](double x) { return std::asin(x); }},
    {"acos", [](double x) { return std::acos(x); }},
    {"atan", [](double x) { return std::atan(x); }},
    {"exp", [](double x) { return std::exp(x); }},
    {"log", [](double x) { return std::log(x); }},
};

struct OfSeries {
  const char* name;
  std::size_t arguments;
};

constexpr OfSeries of_series[] = {
    {"peak", 1},    {"mean", 1},  {"initial", 1},  {"final", 1},        {"at", 2},
    {"arrival", 2}, {"slope", 3}, {"integral", 1}, {"time_of_peak", 1},
};

ExpressionValue extreme(const std::string& name, const Arguments& a) {
  const bool smallest = name == "min";
  if (a.size() == 1) {
    if (!a[0].is_series || a[0].series.empty()) {
      fail(name + "() of one argument needs a series");
    }
    const auto [low, high] = std::minmax_element(a[0].series.begin(), a[0].series.end());
    return smallest ? *low : *high;
  }
  ExpressionValue result = a[0];
  for (std::size_t i = 1; i < a.size(); ++i) {
    result = pairwise(result, a[i], [smallest](double x, double y) {
      return smallest ? std::min(x, y) : std::max(x, y);
    });
  }
  return result;
}

ExpressionValue series_function(const std::string& name, const Arguments& a, const Series& time) {
  const Series& s = series_of(name, a, time);
  if (name == "peak") return std::abs(s[index_of_peak(s)]);
  if (name == "time_of_peak") return time[index_of_peak(s)];
  if (name == "mean" && a.size() == 1) return mean(s, time);
  if (name == "mean") return mean_between(s, time, scalar_of(name, a, 1), scalar_of(name, a, 2));
  if (name == "initial") return s.front();
  if (name == "final") return s.back();
  if (name == "integral") return integral(s, time);
  if (name == "at") return value_at(s, time, scalar_of(name, a, 1));
  if (name == "arrival") return arrival(s, time, scalar_of(name, a, 1));
  return slope(s, time, scalar_of(name, a, 1), scalar_of(name, a, 2));
}

std::size_t wanted_arguments(const std::string& name) {
  for (const auto& f : of_series) {
    if (name == f.name) return f.arguments;
  }
  return 1;
}

}  // namespace

ExpressionValue combine(char op, const ExpressionValue& a, const ExpressionValue& b) {
  switch (op) {
    case '+':
      return pairwise(a, b, [](double x, double y) { return x + y; });
    case '-':
      return pairwise(a, b, [](double x, double y) { return x - y; });
    case '*':
      return pairwise(a, b, [](double x, double y) { return x * y; });
    case '/':
      return pairwise(a, b, [](double x, double y) { return x / y; });
    default:
      return pairwise(a, b, [](double x, double y) { return std::pow(x, y); });
  }
}

std::vector<std::string> function_names() {
  std::vector<std::string> names{"min", "max"};
  for (const auto& f : pointwise) names.emplace_back(f.name);
  for (const auto& f : of_series) names.emplace_back(f.name);
  return names;
}

bool is_function(const std::string& name) {
  const auto names = function_names();
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool takes(const std::string& name, std::size_t arguments) {
  if (name == "min" || name == "max") return arguments >= 1;
  if (name == "mean") return arguments == 1 || arguments == 3;
  return arguments == wanted_arguments(name);
}

std::string arguments_text(const std::string& name) {
  if (name == "min" || name == "max") return "a series, or two numbers or more";
  if (name == "at") return "a series and a time";
  if (name == "arrival") return "a series and a threshold";
  if (name == "slope") return "a series and two times";
  if (name == "mean") return "a series, or a series and two times";
  return "one argument";
}

ExpressionValue call(const std::string& name, const Arguments& arguments, const Series& time) {
  if (name == "min" || name == "max") return extreme(name, arguments);
  for (const auto& f : pointwise) {
    if (name == f.name) return each(arguments[0], f.function);
  }
  return series_function(name, arguments, time);
}

}  // namespace breccia
