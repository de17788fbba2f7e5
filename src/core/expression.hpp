#pragma once
#include "core/error.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace breccia {

/// A number, or a series of numbers over the shared time column.
struct ExpressionValue {
  bool is_series = false;
  double scalar = 0;
  std::vector<double> series;

  ExpressionValue() = default;
  ExpressionValue(double value) : scalar(value) {}  // NOLINT: a number is a value
  ExpressionValue(std::vector<double> values) : is_series(true), series(std::move(values)) {}
};

/// What an expression may speak of.
struct Quantities {
  std::vector<double> time;  ///< [s] column shared by all series, increasing
  /// Value of a dotted name ("load.y", "energy.kinetic"), or nothing when there is none.
  std::function<std::optional<ExpressionValue>(const std::string& name)> find;
  std::vector<std::string> names;  ///< all known names, for messages
};

struct ExpressionNode;

/// A formula over the results of a run, as in [[check]] value = "2 * peak(abs(load.y)) / (pi * 50
/// mm)".
///
/// Numbers may carry a unit and are converted to SI. Operators + - * / ^ and parentheses, constant
/// pi, functions of numbers or series (element by element): sqrt abs sin cos tan asin acos atan exp
/// log min max; of a series: peak (largest magnitude), min, max, mean (over time) or
/// mean(s, t0, t1), initial, final, at(s, t), arrival(s, threshold), slope(s, t0, t1), integral,
/// time_of_peak.
class Expression {
 public:
  /// \throws Error with an empty place; the cause names the column.
  explicit Expression(std::string text);

  /// \throws Error when a name is unknown (nearest named), the result is a series or not finite.
  [[nodiscard]] double evaluate(const Quantities& quantities) const;

  /// The same where a series is wanted. \throws Error when the result is a number.
  [[nodiscard]] std::vector<double> series(const Quantities& quantities) const;

  /// Dotted names that the formula asks for, each once, in order.
  [[nodiscard]] std::vector<std::string> names() const;
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::shared_ptr<const ExpressionNode> root_;
};

}  // namespace breccia
