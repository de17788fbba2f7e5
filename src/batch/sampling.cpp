#include "batch/sampling.hpp"

#include "core/error.hpp"
#include "core/random.hpp"
#include "core/text.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace breccia {

namespace {

double normal_share(double z) {
  return 0.5 * std::erfc(-z / std::sqrt(2.0));
}

/// The inverse by halving: a few thousand of them are drawn, and it has no constants to get wrong.
double normal_quantile(double share) {
  double low = -40, high = 40;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (normal_share(middle) < share ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

struct Parameters {
  std::vector<std::string> needed, possible;
};

const Parameters& parameters_of(const std::string& kind) {
  static const std::vector<std::string> bounds{"lower_bound", "upper_bound"};
  static const std::map<std::string, Parameters> all = {
      {"uniform", {bounds, {}}},
      {"loguniform", {bounds, {}}},
      {"normal", {{"mean", "std_deviation"}, bounds}},
      {"lognormal", {{"mean", "std_deviation"}, bounds}},
      {"weibull", {{"scale", "shape"}, bounds}},
  };
  return all.at(kind);
}

bool holds(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

void check_parameters(const Settings& section, const std::string& kind) {
  const Parameters& wanted = parameters_of(kind);
  const std::string remedy = "the " + kind + " distribution has " + join(wanted.needed, " and ");
  for (const std::string& key : wanted.needed)
    if (!section.has(key)) throw section.error("", key + " is missing", remedy);
  for (const char* key :
       {"lower_bound", "upper_bound", "mean", "std_deviation", "scale", "shape"}) {
    if (section.has(key) && !holds(wanted.needed, key) && !holds(wanted.possible, key))
      throw section.error(key, "does not belong to the " + kind + " distribution", remedy);
  }
}

}  // namespace

std::vector<double> Sampling::shares(std::uint32_t key) const {
  constexpr double half = 0x1.0p-54;  // neither 0 nor 1
  const Random random{seed, key};
  std::vector<double> shares(samples);
  for (std::size_t s = 0; s < samples; ++s) shares[s] = random.uniform(s) + half;
  if (!hypercube) return shares;
  std::vector<std::size_t> order(samples);
  std::iota(order.begin(), order.end(), 0);
  constexpr std::uint32_t shuffle = 1;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(random.bits(a, shuffle), a) < std::pair(random.bits(b, shuffle), b);
  });
  for (std::size_t cell = 0; cell < samples; ++cell) {
    double& share = shares[order[cell]];
    share = (static_cast<double>(cell) + share) / static_cast<double>(samples);
  }
  return shares;
}

Distribution::Distribution(const Settings& section) : kind_(section.text("distribution")) {
  check_parameters(section, kind_);
  read_parameters(section);
  read_bounds(section);
}

double Distribution::quantity(const Settings& section, const char* key) {
  Quantity q;
  try {
    q = parse_quantity(section.text(key));
  } catch (const Error& e) {
    throw section.error(key, e.cause(), e.remedy());
  }
  if (unit_key_.empty()) {
    unit_key_ = key;
    dimension_ = q.dimension;
  }
  if (q.dimension == dimension_) return q.value;
  throw section.error(key, "\"" + section.text(key) + "\" is " +
                               with_article(dimension_name(q.dimension)) + ", " + unit_key_ +
                               " is " + with_article(dimension_name(dimension_)));
}

void Distribution::read_parameters(const Settings& section) {
  const auto positive = [&](const char* key, double value) {
    if (!(value > 0)) throw section.error(key, number_text(value) + " is not above 0");
    return value;
  };
  const bool logarithmic = kind_ == "loguniform" || kind_ == "lognormal";
  if (kind_ == "uniform" || kind_ == "loguniform") {
    first_ = quantity(section, "lower_bound");
    second_ = quantity(section, "upper_bound");
    if (logarithmic) first_ = std::log(positive("lower_bound", first_));
    if (logarithmic) second_ = std::log(positive("upper_bound", second_));
    if (!(first_ < second_))
      throw section.error("upper_bound", "is not above lower_bound", "exchange the bounds");
  } else if (kind_ == "weibull") {
    first_ = positive("scale", quantity(section, "scale"));
    second_ = section.number("shape");
  } else {
    first_ = quantity(section, "mean");
    second_ = positive("std_deviation", quantity(section, "std_deviation"));
    if (logarithmic) {
      const double ratio = second_ / positive("mean", first_);
      second_ = std::sqrt(std::log1p(ratio * ratio));
      first_ = std::log(first_) - 0.5 * second_ * second_;
    }
  }
}

void Distribution::read_bounds(const Settings& section) {
  if (kind_ == "uniform" || kind_ == "loguniform") return;
  if (section.has("lower_bound")) low_ = share_below(quantity(section, "lower_bound"));
  if (section.has("upper_bound")) high_ = share_below(quantity(section, "upper_bound"));
  constexpr double least = 1e-9;
  if (high_ - low_ > least) return;
  throw section.error(section.has("upper_bound") ? "upper_bound" : "lower_bound",
                      "the bounds leave nothing of the distribution",
                      "let them hold some of the values that the " +
                          join(parameters_of(kind_).needed, " and the ") + " make likely");
}

double Distribution::share_below(double value) const {
  if (kind_ == "normal") return normal_share((value - first_) / second_);
  if (value <= 0) return 0;
  if (kind_ == "lognormal") return normal_share((std::log(value) - first_) / second_);
  return -std::expm1(-std::pow(value / first_, second_));
}

double Distribution::uncut_quantile(double share) const {
  if (kind_ == "uniform") return first_ + share * (second_ - first_);
  if (kind_ == "loguniform") return std::exp(first_ + share * (second_ - first_));
  if (kind_ == "weibull") return first_ * std::pow(-std::log1p(-share), 1 / second_);
  const double value = first_ + second_ * normal_quantile(share);
  return kind_ == "lognormal" ? std::exp(value) : value;
}

double Distribution::quantile(double share) const {
  return uncut_quantile(low_ + share * (high_ - low_));
}

std::string Distribution::unit_text() const {
  return dimension_ == unit::none ? "" : si_unit(dimension_);
}

}  // namespace breccia
