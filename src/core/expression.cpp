#include "core/expression.hpp"

#include "core/expression_value.hpp"
#include "core/text.hpp"
#include "core/unit.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace breccia {

struct ExpressionNode {
  enum class Kind { number, name, negate, binary, call } kind = Kind::number;
  double number = 0;
  std::string word;  ///< name or function
  char op = 0;
  std::size_t column = 0;
  std::vector<std::shared_ptr<const ExpressionNode>> inner;
};

namespace {

using Node = ExpressionNode;
using NodePointer = std::shared_ptr<const Node>;

[[noreturn]] void fail(const std::string& text, std::size_t at, const std::string& cause,
                       const std::string& remedy = {}) {
  throw Error("", cause + " (column " + std::to_string(at + 1) + " of \"" + text + "\")", remedy);
}

/// Recursive descent: sum := product (+|- product)*, product := power (*|/ power)*,
/// power := atom [^ power] where a leading minus binds weaker than ^, as in mathematics.
class Parser {
 public:
  explicit Parser(const std::string& text) : text_(text) {}

  NodePointer parse() {
    if (trimmed(text_).empty()) throw Error("", "the expression is empty");
    NodePointer root = sum();
    if (skip_blanks(), at_ < text_.size()) {
      fail(text_, at_, std::string("'") + text_[at_] + "' is not expected here");
    }
    return root;
  }

 private:
  void skip_blanks() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }
  bool take(char c) {
    skip_blanks();
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  char take_any(std::string_view set) {
    skip_blanks();
    if (at_ >= text_.size() || set.find(text_[at_]) == std::string_view::npos) return 0;
    return text_[at_++];
  }

  static NodePointer binary(char op, NodePointer a, NodePointer b, std::size_t column) {
    Node node{Node::Kind::binary, 0, {}, op, column, {std::move(a), std::move(b)}};
    return std::make_shared<const Node>(std::move(node));
  }

  NodePointer sum() {
    if (++depth_ > 200) fail(text_, at_, "the expression is nested too deeply");
    NodePointer left = product();
    for (char op = take_any("+-"); op != 0; op = take_any("+-")) {
      const std::size_t column = at_ - 1;
      left = binary(op, left, product(), column);
    }
    --depth_;
    return left;
  }

  NodePointer product() {
    NodePointer left = signed_power();
    for (char op = take_any("*/"); op != 0; op = take_any("*/")) {
      const std::size_t column = at_ - 1;
      left = binary(op, left, signed_power(), column);
    }
    return left;
  }

  NodePointer signed_power() {
    bool negative = false;
    for (char op = take_any("+-"); op != 0; op = take_any("+-")) negative ^= op == '-';
    NodePointer value = power();
    if (!negative) return value;
    return std::make_shared<const Node>(Node{Node::Kind::negate, 0, {}, 0, at_, {value}});
  }

  NodePointer power() {
    NodePointer base = atom();
    if (!take('^')) return base;
    const std::size_t column = at_ - 1;
    if (++depth_ > 200) fail(text_, at_, "the expression is nested too deeply");
    NodePointer result = binary('^', base, signed_power(), column);
    --depth_;
    return result;
  }

  NodePointer atom() {
    skip_blanks();
    if (at_ >= text_.size()) fail(text_, at_, "the expression ends where a value is wanted");
    if (take('(')) {
      NodePointer inner = sum();
      if (!take(')')) fail(text_, at_, "a ')' is missing");
      return inner;
    }
    const char c = text_[at_];
    if (std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.') return number();
    if (is_letter(c)) return name_or_call();
    fail(text_, at_, std::string("'") + c + "' is not expected here");
  }

  static bool is_letter(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
  }
  static bool is_unit_letter(char c) {
    const auto u = static_cast<unsigned char>(c);
    return std::isalpha(u) != 0 || c == '%' || u >= 0x80;
  }

  NodePointer number() {
    const std::size_t column = at_;
    double value = 0;
    const auto read = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (read.ec != std::errc()) fail(text_, at_, "this is not a number");
    at_ = static_cast<std::size_t>(read.ptr - text_.data());
    const std::size_t end = at_;
    skip_blanks();
    if (at_ < text_.size() && is_unit_letter(text_[at_])) {
      const std::string unit = unit_text();
      try {
        // The number goes along, because "7 mm" is rounded once that way.
        value = parse_quantity(text_.substr(column, end - column) + " " + unit).value;
      } catch (const Error& e) {
        fail(text_, end, e.cause(), e.remedy());
      }
    }
    return std::make_shared<const Node>(Node{Node::Kind::number, value, {}, 0, column, {}});
  }

  /// The longest unit that begins here. A '/' or '.' continues it only without blanks and before
  /// another unit: "5 m/s" is a velocity, "5 m / load" a quotient.
  std::string unit_text() {
    std::size_t end = unit_factor(at_);
    while (end < text_.size() && (text_[end] == '/' || text_[end] == '.')) {
      const std::size_t next = unit_factor(end + 1);
      if (next == end + 1 || !is_unit(text_.substr(end + 1, next - end - 1))) break;
      end = next;
    }
    std::string unit = text_.substr(at_, end - at_);
    at_ = end;
    return unit;
  }

  [[nodiscard]] std::size_t unit_factor(std::size_t from) const {
    std::size_t end = from;
    while (end < text_.size() && is_unit_letter(text_[end])) ++end;
    if (end == from) return from;
    std::size_t digits = end;
    if (digits < text_.size() && text_[digits] == '^') ++digits;
    if (digits < text_.size() && text_[digits] == '-') ++digits;
    const std::size_t first = digits;
    while (digits < text_.size() && std::isdigit(static_cast<unsigned char>(text_[digits])) != 0) {
      ++digits;
    }
    const bool minus_alone = first > end && text_[end] == '-';  // "3 m-2": a difference
    return digits > first && !minus_alone ? digits : end;
  }

  NodePointer name_or_call() {
    const std::size_t column = at_;
    while (at_ < text_.size() &&
           (is_letter(text_[at_]) || std::isdigit(static_cast<unsigned char>(text_[at_])) != 0 ||
            text_[at_] == '.')) {
      ++at_;
    }
    std::string word = text_.substr(column, at_ - column);
    if (take('(')) return call(std::move(word), column);
    if (word == "pi") {
      constexpr double pi = 3.14159265358979323846;
      return std::make_shared<const Node>(Node{Node::Kind::number, pi, {}, 0, column, {}});
    }
    return std::make_shared<const Node>(Node{Node::Kind::name, 0, std::move(word), 0, column, {}});
  }

  NodePointer call(std::string word, std::size_t column) {
    if (!is_function(word)) {
      fail(text_, column, "no function '" + word + "'." + did_you_mean(word, function_names()),
           "functions: " + join(function_names()));
    }
    Node node{Node::Kind::call, 0, word, 0, column, {}};
    if (!take(')')) {
      do {
        node.inner.push_back(sum());
      } while (take(','));
      if (!take(')')) fail(text_, at_, "a ')' is missing");
    }
    if (!takes(word, node.inner.size())) {
      fail(text_, column, word + "() takes " + arguments_text(word));
    }
    return std::make_shared<const Node>(std::move(node));
  }

  const std::string& text_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

ExpressionValue look_up(const Node& node, const Quantities& q, const std::string& text) {
  if (node.word == "time") return q.time;
  if (q.find) {
    if (auto value = q.find(node.word)) return *std::move(value);
  }
  auto known = q.names;
  known.emplace_back("time");
  fail(text, node.column, "no quantity '" + node.word + "'." + did_you_mean(node.word, known),
       "known: " + join(known));
}

ExpressionValue evaluated(const Node& node, const Quantities& q, const std::string& text) {
  switch (node.kind) {
    case Node::Kind::number:
      return node.number;
    case Node::Kind::name:
      return look_up(node, q, text);
    case Node::Kind::negate:
      return combine('*', -1.0, evaluated(*node.inner[0], q, text));
    default:
      break;
  }
  std::vector<ExpressionValue> arguments;
  for (const auto& inner : node.inner) arguments.push_back(evaluated(*inner, q, text));
  try {
    if (node.kind == Node::Kind::binary) return combine(node.op, arguments[0], arguments[1]);
    return call(node.word, arguments, q.time);
  } catch (const Error& e) {
    fail(text, node.column, e.cause(), e.remedy());
  }
}

void collect(const Node& node, std::vector<std::string>& names) {
  const bool fresh = std::find(names.begin(), names.end(), node.word) == names.end();
  if (node.kind == Node::Kind::name && fresh) names.push_back(node.word);
  for (const auto& inner : node.inner) collect(*inner, names);
}

}  // namespace

Expression::Expression(std::string text) : text_(std::move(text)), root_(Parser(text_).parse()) {}

double Expression::evaluate(const Quantities& quantities) const {
  const ExpressionValue result = evaluated(*root_, quantities, text_);
  if (result.is_series) {
    throw Error("", "\"" + text_ + "\" is a series, not a number",
                "take peak(), min(), max(), mean(), initial(), final() or at() of it");
  }
  if (!std::isfinite(result.scalar)) {
    throw Error("", "\"" + text_ + "\" is not finite (" + number_text(result.scalar) + ")");
  }
  return result.scalar;
}

std::vector<double> Expression::series(const Quantities& quantities) const {
  ExpressionValue result = evaluated(*root_, quantities, text_);
  if (result.is_series) return std::move(result.series);
  throw Error("", "\"" + text_ + "\" is a number, not a series", "name a column of history.csv");
}

std::vector<std::string> Expression::names() const {
  std::vector<std::string> names;
  collect(*root_, names);
  return names;
}

}  // namespace breccia
