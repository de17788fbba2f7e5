#include "core/unit.hpp"

#include "core/error.hpp"
#include "core/text.hpp"

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

namespace breccia {

namespace {

constexpr double pi = 3.14159265358979323846;

/// Size in SI as factor * 10^tens: powers of ten stay exact, so that a number is rounded once and
/// "7 mm" is the double 0.007.
struct Scale {
  double factor = 1;
  int tens = 0;
  Dimension dimension;
};

struct Symbol {
  std::string_view name;
  double factor;
  int tens;
  Dimension dimension;
  bool takes_prefix;
};

constexpr std::array symbols{
    Symbol{"m", 1, 0, unit::length, true},
    Symbol{"g", 1, -3, unit::mass, true},
    Symbol{"t", 1, 3, unit::mass, true},
    Symbol{"s", 1, 0, unit::time, true},
    Symbol{"min", 60, 0, unit::time, false},
    Symbol{"h", 3600, 0, unit::time, false},
    Symbol{"K", 1, 0, unit::temperature, true},
    Symbol{"rad", 1, 0, unit::angle, true},
    Symbol{"deg", pi / 180, 0, unit::angle, false},
    Symbol{"N", 1, 0, unit::force, true},
    Symbol{"Pa", 1, 0, unit::pressure, true},
    Symbol{"bar", 1, 5, unit::pressure, true},
    Symbol{"J", 1, 0, unit::energy, true},
    Symbol{"W", 1, 0, unit::power, true},
    Symbol{"Hz", 1, 0, unit::frequency, true},
    Symbol{"rpm", 2 * pi / 60, 0, unit::angular_velocity, false},
    Symbol{"%", 1, -2, unit::none, false},
};

struct Prefix {
  std::string_view name;
  int tens;
};

constexpr std::array prefixes{
    Prefix{"p", -12}, Prefix{"n", -9}, Prefix{"u", -6}, Prefix{"\u00b5", -6}, Prefix{"\u03bc", -6},
    Prefix{"m", -3},  Prefix{"c", -2}, Prefix{"d", -1}, Prefix{"h", 2},       Prefix{"k", 3},
    Prefix{"M", 6},   Prefix{"G", 9},  Prefix{"T", 12},
};

/// number * factor * 10^tens; powers up to 10^22 are exact doubles.
double scaled(double number, const Scale& scale) {
  const double value = number * scale.factor;
  const double power = std::pow(10.0, std::abs(scale.tens));
  return scale.tens < 0 ? value / power : value * power;
}

std::optional<Scale> find_symbol(std::string_view word) {
  for (const auto& s : symbols) {
    if (word == s.name) return Scale{s.factor, s.tens, s.dimension};
  }
  for (const auto& p : prefixes) {
    if (word.size() <= p.name.size() || word.substr(0, p.name.size()) != p.name) continue;
    const auto rest = word.substr(p.name.size());
    for (const auto& s : symbols) {
      if (s.takes_prefix && rest == s.name) return Scale{s.factor, p.tens + s.tens, s.dimension};
    }
  }
  return std::nullopt;
}

std::string nearest_unit(std::string_view word) {
  std::string lower;
  for (const char c : word) lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  std::vector<std::string> common{"mm", "cm",  "km",  "um",  "ms", "us",  "kg", "kN",
                                  "MN", "kPa", "MPa", "GPa", "kJ", "kHz", "MHz"};
  for (const auto& s : symbols) common.emplace_back(s.name);
  for (const auto& name : common) {  // "mpa" and "MPA" are MPa, not mPa
    if (name.size() != lower.size()) continue;
    bool same = true;
    for (std::size_t i = 0; i < name.size(); ++i) {
      same = same && std::tolower(static_cast<unsigned char>(name[i])) == lower[i];
    }
    if (same) return name;
  }
  return nearest(word, common);
}

Dimension power(Dimension d, int n) {
  return {d.m * n, d.kg * n, d.s * n, d.K * n, d.rad * n};
}

/// Recursive descent over product := power (('.' | '*' | '/') power)*, power := atom ['^'] [int].
class UnitReader {
 public:
  explicit UnitReader(std::string_view text) : text_(text) {}

  Scale read() {
    Scale q = product();
    if (at_ != text_.size()) fail("'" + std::string(text_.substr(at_)) + "' is not a unit");
    return q;
  }

 private:
  [[nodiscard]] bool more() const { return at_ < text_.size(); }
  [[noreturn]] static void fail(const std::string& cause, const std::string& remedy = {}) {
    throw Error("", cause, remedy);
  }

  Scale product() {
    Scale left = factor();
    while (more() && (text_[at_] == '.' || text_[at_] == '*' || text_[at_] == '/')) {
      const bool divide = text_[at_++] == '/';
      const Scale right = factor();
      left.factor = divide ? left.factor / right.factor : left.factor * right.factor;
      left.tens += divide ? -right.tens : right.tens;
      left.dimension = divide ? left.dimension / right.dimension : left.dimension * right.dimension;
    }
    return left;
  }

  Scale factor() {
    Scale base = atom();
    const bool caret = more() && text_[at_] == '^';
    if (caret) ++at_;
    int exponent = 1;
    const char* begin = text_.data() + at_;
    const auto read = std::from_chars(begin, text_.data() + text_.size(), exponent);
    if (read.ec == std::errc()) {
      at_ += static_cast<std::size_t>(read.ptr - begin);
    } else if (caret) {
      fail("the exponent after '^' in the unit '" + std::string(text_) + "' is no integer");
    } else {
      exponent = 1;
    }
    if (exponent == 0 || exponent > 9 || exponent < -9) {
      fail("the unit '" + std::string(text_) + "' has an exponent out of range");
    }
    return {std::pow(base.factor, exponent), base.tens * exponent, power(base.dimension, exponent)};
  }

  Scale atom() {
    if (more() && text_[at_] == '(') {
      ++at_;
      Scale inner = product();
      if (!more() || text_[at_] != ')') {
        fail("the unit '" + std::string(text_) + "' lacks a ')'");
      }
      ++at_;
      return inner;
    }
    if (more() && text_[at_] == '1') {  // as in "1/s"
      ++at_;
      return {};
    }
    const std::size_t begin = at_;
    while (more() && is_letter(text_[at_])) ++at_;
    const auto word = text_.substr(begin, at_ - begin);
    if (word.empty()) fail("the unit '" + std::string(text_) + "' is not complete");
    if (const auto found = find_symbol(word)) return *found;
    if (word == "degC" || word == "C" || word == "degF") {
      fail("temperatures are in K", "0 degrees Celsius are 273.15 K");
    }
    const std::string near = nearest_unit(word);
    fail("no unit '" + std::string(word) + "'." +
             (near.empty() ? std::string() : " Did you mean '" + near + "'?"),
         "units: m, g, t, s, min, h, K, rad, deg, N, Pa, bar, J, W, Hz, rpm, % with prefixes p n "
         "u m c d h k M G T, joined by . and /, with powers as in m2 or m^2");
  }

  static bool is_letter(char c) {
    const auto u = static_cast<unsigned char>(c);
    return std::isalpha(u) != 0 || c == '%' || u >= 0x80;  // the last for the micro sign
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

struct NamedDimension {
  Dimension dimension;
  std::string_view name, si, example;
};

constexpr std::array named{
    NamedDimension{unit::none, "pure number", "1", "0.5"},
    NamedDimension{unit::length, "length", "m", "50 mm"},
    NamedDimension{unit::area, "area", "m2", "20 cm2"},
    NamedDimension{unit::volume, "volume", "m3", "2 m3"},
    NamedDimension{unit::mass, "mass", "kg", "3 kg"},
    NamedDimension{unit::time, "time", "s", "1.2 ms"},
    NamedDimension{unit::frequency, "frequency", "1/s", "50 kHz"},
    NamedDimension{unit::temperature, "temperature", "K", "300 K"},
    NamedDimension{unit::angle, "angle", "rad", "50 deg"},
    NamedDimension{unit::velocity, "velocity", "m/s", "0.1 m/s"},
    NamedDimension{unit::acceleration, "acceleration", "m/s2", "9.81 m/s2"},
    NamedDimension{unit::angular_velocity, "angular velocity", "rad/s", "10 rad/s"},
    NamedDimension{unit::density, "density", "kg/m3", "2650 kg/m3"},
    NamedDimension{unit::force, "force", "N", "10 kN"},
    NamedDimension{unit::energy, "energy", "J", "5 J"},
    NamedDimension{unit::power, "power", "W", "2 kW"},
    NamedDimension{unit::specific_energy, "energy per mass", "J/kg", "5 MJ/kg"},
    NamedDimension{unit::heat_capacity, "heat capacity per mass", "J/(kg.K)", "383 J/(kg.K)"},
    NamedDimension{unit::pressure, "pressure", "Pa", "60 GPa"},
    NamedDimension{unit::surface_energy, "energy per area", "J/m2", "50 J/m2"},
    NamedDimension{unit::interface_stiffness, "stiffness per area", "Pa/m", "10 GPa/m"},
    NamedDimension{unit::viscosity, "viscosity", "Pa.s", "1 mPa.s"},
    NamedDimension{unit::none / unit::length, "one per length", "1/m", "0.5 1/m"},
    NamedDimension{unit::interface_viscosity, "viscosity per length", "Pa.s/m", "1 kPa.s/m"},
};

const NamedDimension* find_name(Dimension dimension) {
  for (const auto& n : named) {
    if (n.dimension == dimension) return &n;
  }
  return nullptr;
}

}  // namespace

Quantity parse_unit(std::string_view text) {
  const Scale scale = UnitReader(trimmed(text)).read();
  return {scaled(1, scale), scale.dimension, true};
}

bool is_unit(std::string_view text) {
  try {
    parse_unit(text);
    return true;
  } catch (const Error&) {
    return false;
  }
}

Quantity parse_quantity(std::string_view text) {
  const std::string whole = trimmed(text);
  std::string_view rest = whole;
  if (!rest.empty() && rest.front() == '+') rest.remove_prefix(1);
  double number = 0;
  const auto read = std::from_chars(rest.data(), rest.data() + rest.size(), number);
  if (read.ec == std::errc::result_out_of_range) {
    throw Error("", "the number in \"" + whole + "\" is too large or too small for this machine");
  }
  if (read.ec != std::errc()) {
    throw Error("", "\"" + whole + "\" does not begin with a number");
  }
  if (!std::isfinite(number)) throw Error("", "\"" + whole + "\" is not a finite number");
  rest.remove_prefix(static_cast<std::size_t>(read.ptr - rest.data()));
  const std::string word = trimmed(rest);
  if (word.empty()) return {number, unit::none, false};
  try {
    const Scale scale = UnitReader(word).read();
    const double value = scaled(number, scale);
    if (!std::isfinite(value)) throw Error("", "is too large in SI units");
    return {value, scale.dimension, true};
  } catch (const Error& e) {
    throw Error("", "\"" + whole + "\": " + e.cause(), e.remedy());
  }
}

std::string si_unit(Dimension dimension) {
  if (const auto* known = find_name(dimension)) return std::string(known->si);
  std::string text;
  const auto factor = [&text](const char* symbol, int exponent) {
    if (exponent == 0) return;
    if (!text.empty()) text += ".";
    text += symbol;
    if (exponent != 1) text += "^" + std::to_string(exponent);
  };
  factor("kg", dimension.kg);
  factor("m", dimension.m);
  factor("s", dimension.s);
  factor("K", dimension.K);
  factor("rad", dimension.rad);
  return text;
}

std::string dimension_name(Dimension dimension) {
  const auto* known = find_name(dimension);
  return known != nullptr ? std::string(known->name) : "quantity in " + si_unit(dimension);
}

std::string friendly(Dimension dimension) {
  const auto* known = find_name(dimension);
  const std::string example =
      known != nullptr ? std::string(known->example) : "1 " + si_unit(dimension);
  if (dimension == unit::none) return "pure number, e.g. " + example;
  return dimension_name(dimension) + ", e.g. \"" + example + "\"";
}

std::string with_article(const std::string& noun) {
  const bool vowel =
      !noun.empty() && std::string_view("aeiou").find(noun.front()) != std::string::npos;
  return (vowel ? "an " : "a ") + noun;
}

}  // namespace breccia
