#include "core/schema.hpp"

#include "core/text.hpp"

#include <cctype>
#include <cmath>
#include <stdexcept>

namespace breccia {

namespace {

/// "body[].shape.disc" stands in "body[].shape"; "material.*" stands at the top.
Section made_from(const std::string& pattern) {
  Section s;
  s.pattern = pattern;
  std::string rest = pattern;
  const auto ends_with = [&rest](std::string_view end) {
    return rest.size() > end.size() && rest.compare(rest.size() - end.size(), end.size(), end) == 0;
  };
  if (ends_with(".*")) {
    s.kind = Section::Kind::named;
    rest.resize(rest.size() - 2);
  } else if (ends_with("[]")) {
    s.kind = Section::Kind::list;
    rest.resize(rest.size() - 2);
  }
  const auto dot = rest.rfind('.');
  s.parent = dot == std::string::npos ? "" : rest.substr(0, dot);
  s.local = dot == std::string::npos ? rest : rest.substr(dot + 1);
  return s;
}

std::string replaced(std::string text, std::string_view what, std::string_view with) {
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size())) {
    text.replace(at, what.size(), with);
  }
  return text;
}

std::string limit_text(double value, Dimension dimension) {
  if (dimension == unit::angle) {
    const double degrees = value * 180 / 3.14159265358979323846;
    return number_text(std::round(1e4 * degrees) / 1e4) + " deg";
  }
  const std::string si = si_unit(dimension);
  return number_text(value) + (si == "1" ? "" : " " + si);
}

}  // namespace

bool Range::admits(double value) const {
  return (open_low ? value > low : value >= low) && (open_high ? value < high : value <= high);
}

bool Range::limited() const {
  return *this != Range{};
}

std::string Range::text(Dimension dimension) const {
  const bool from = low != Range{}.low, to = high != Range{}.high;
  const std::string lower = limit_text(low, dimension), upper = limit_text(high, dimension);
  if (low == high) return "only " + lower;
  if (from && to && !open_low && !open_high) return "from " + lower + " to " + upper;
  const std::string first = open_low ? "above " + lower : "at least " + lower;
  const std::string second = open_high ? "below " + upper : "at most " + upper;
  if (from && to) return first + " and " + second;
  return from ? first : to ? second : "any";
}

std::string Key::kind_text() const {
  const std::string what = dimension == unit::none ? "number" : dimension_name(dimension);
  switch (type) {
    case KeyType::flag:
      return "true or false";
    case KeyType::integer:
      return "integer";
    case KeyType::number:
      return dimension_name(dimension);
    case KeyType::text:
      return "text";
    case KeyType::choice:
      return "one of " + join(choices);
    case KeyType::formula:
      return "expression";
    case KeyType::vector:
      return what + ", one per dimension";
    case KeyType::rotation:
      return what + " (2D), three of them (3D)";
    case KeyType::numbers:
      return "list of " + what;
    case KeyType::integers:
      return "list of integers";
    case KeyType::texts:
      return "list of texts";
    case KeyType::values:
      return "list of values";
    case KeyType::pairs:
      return "{ name = quantity, ... }";
    case KeyType::table:
      return "rows [" + dimension_name(first_dimension) + ", " + what + "]";
    case KeyType::points:
      return "list of positions";
    case KeyType::lines:
      return "list of lists of positions";
  }
  throw std::logic_error("a key of no type");
}

std::string Key::unit_text() const {
  if (type == KeyType::table) return si_unit(first_dimension) + ", " + si_unit(dimension);
  return dimension == unit::none ? std::string() : si_unit(dimension);
}

std::string Key::example_text() const {
  if (example.empty()) return default_value ? name + " = " + default_value->written() : "";
  const bool list = std::string_view("[{\"").find(example.front()) != std::string_view::npos;
  if (list || type == KeyType::flag) return name + " = " + example;
  const bool plain = example.find_first_not_of("0123456789.e+-") == std::string::npos;
  return name + " = " + (plain ? example : "\"" + example + "\"");
}

std::string Key::default_text() const {
  return default_value ? default_value->written() : "";
}

const Key* Section::key(std::string_view name) const {
  for (const auto& k : keys) {
    if (k.name == name) return &k;
  }
  return nullptr;
}

std::string Section::path() const {
  return replaced(replaced(pattern, ".*", ""), "[]", "");
}

std::string Section::title() const {
  if (pattern.empty()) return "top";
  const std::string words = replaced(replaced(pattern, ".*", ".NAME"), "[]", "");
  if (!parent.empty()) return words;
  return kind == Kind::list ? "[[" + words + "]]" : "[" + words + "]";
}

std::string Section::anchor() const {
  std::string slug;  // as web hosts make it from a heading
  for (const char c : title()) {
    const auto u = static_cast<unsigned char>(c);
    if (std::isalnum(u) != 0 || c == '_') slug += static_cast<char>(std::tolower(u));
  }
  return slug;
}

std::string Section::page(std::string_view key) const {
  std::string word = path();
  if (!key.empty()) word += (word.empty() ? "" : ".") + std::string(key);
  return "docs/input.md#" + anchor() + "  (or: breccia help" + (word.empty() ? "" : " ") + word +
         ")";
}

Schema::Schema() {
  sections_.emplace_back();
}

SectionBuilder Schema::section(std::string pattern) {
  for (auto& s : sections_) {
    if (s.pattern == pattern) return SectionBuilder(s);
  }
  Section made = made_from(pattern);
  if (!made.parent.empty()) section(made.parent);
  return SectionBuilder(sections_.emplace_back(std::move(made)));
}

const Section* Schema::find(std::string_view pattern) const {
  for (const auto& s : sections_) {
    if (s.pattern == pattern) return &s;
  }
  return nullptr;
}

std::vector<const Section*> Schema::inside(const Section& section) const {
  std::vector<const Section*> inner;
  for (const auto& s : sections_) {
    if (!s.pattern.empty() && s.parent == section.pattern) inner.push_back(&s);
  }
  return inner;
}

std::vector<const Section*> Schema::effects() const {
  std::vector<const Section*> found;
  for (const auto& s : sections_) {
    if (!s.effect.empty()) found.push_back(&s);
  }
  return found;
}

}  // namespace breccia
