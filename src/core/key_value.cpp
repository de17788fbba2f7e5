#include "core/key_value.hpp"

#include "core/expression.hpp"
#include "core/text.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include <stdexcept>

namespace breccia {

namespace {

using Kind = Config::Kind;

class Reader {
 public:
  Reader(const Key& key, int dimensions) : key_(key), dimensions_(dimensions) {}

  SettingValue read(const Config& raw) const {
    switch (key_.type) {
      case KeyType::flag:
        return flag(raw);
      case KeyType::integer:
        return integer(raw);
      case KeyType::number:
        return number(raw);
      case KeyType::text:
        return text(raw);
      case KeyType::choice:
        return choice(raw);
      case KeyType::formula:
        return formula(raw);
      case KeyType::vector:
        return vector(raw);
      case KeyType::rotation:
        return rotation(raw);
      case KeyType::numbers:
        return numbers(raw, 1);
      case KeyType::integers:
        return integers(raw);
      case KeyType::texts:
        return texts(raw);
      case KeyType::values:
        return values(raw);
      case KeyType::pairs:
        return pairs(raw);
      case KeyType::table:
        return table(raw);
      case KeyType::points:
        return points(raw, 1);
      case KeyType::lines:
        return lines(raw);
    }
    throw std::logic_error("a key of no type");
  }

 private:
  [[noreturn]] static void fail(const Config& raw, const std::string& cause,
                                const std::string& remedy = {}) {
    throw Error(raw.place().text(), cause, remedy);
  }
  [[noreturn]] void wrong_kind(const Config& raw, const std::string& wanted) const {
    const std::string example = key_.example_text();
    fail(raw, "expects " + wanted + ", not " + raw.describe(),
         example.empty() ? "" : "for example: " + example);
  }

  bool flag(const Config& raw) const {
    if (!raw.is(Kind::boolean)) wrong_kind(raw, "true or false");
    return raw.boolean();
  }

  std::int64_t integer(const Config& raw) const {
    if (!raw.is(Kind::integer)) wrong_kind(raw, "an integer");
    check_range(raw, static_cast<double>(raw.integer()));
    return raw.integer();
  }

  double number(const Config& raw) const {
    const double value = quantity(raw, key_.dimension);
    check_range(raw, value);
    return value;
  }

  double quantity(const Config& raw, Dimension wanted) const {
    if (raw.is(Kind::integer)) return static_cast<double>(raw.integer());
    if (raw.is(Kind::real)) {
      if (!std::isfinite(raw.real())) fail(raw, number_text(raw.real()) + " is not finite");
      return raw.real();
    }
    const std::string noun = with_article(friendly(wanted));
    if (!raw.is(Kind::text)) wrong_kind(raw, noun);
    Quantity q;
    try {
      q = parse_quantity(raw.text());
    } catch (const Error& e) {
      fail(raw, e.cause(), "wanted: " + noun + (e.remedy().empty() ? "" : "\n" + e.remedy()));
    }
    if (!q.has_unit && wanted != unit::none) {
      fail(raw, "\"" + raw.text() + "\" has no unit; " + noun + ", is wanted",
           "a number without quotes is taken in " + si_unit(wanted));
    }
    if (q.dimension != wanted) {
      fail(raw, "\"" + raw.text() + "\" is " + with_article(dimension_name(q.dimension)) + "; " +
                    noun + ", is wanted");
    }
    return q.value;
  }

  void check_range(const Config& raw, double value) const {
    if (key_.range.admits(value)) return;
    const std::string unit = key_.unit_text();
    const std::string in_si = number_text(value) + (unit.empty() ? "" : " " + unit);
    const std::string given = raw.is(Kind::text) ? "\"" + raw.text() + "\" (" + in_si + ")" : in_si;
    fail(raw, given + " is out of range; allowed: " + key_.range.text(key_.dimension));
  }

  std::string text(const Config& raw) const {
    if (!raw.is(Kind::text)) wrong_kind(raw, "a text in quotes");
    const std::string& word = raw.text();
    if (trimmed(word).empty()) fail(raw, "the text is empty");
    const auto in_name = [](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
    };
    const bool starts_well = std::isdigit(static_cast<unsigned char>(word.front())) == 0;
    if (key_.identifier && !(starts_well && std::all_of(word.begin(), word.end(), in_name))) {
      fail(raw, "\"" + word + "\" cannot be used in expressions",
           "letters, digits and _ only, a letter first: it is spoken of as " + key_.name +
               " in [[check]]");
    }
    return word;
  }

  std::string choice(const Config& raw) const {
    if (!raw.is(Kind::text)) wrong_kind(raw, "one of " + join(key_.choices));
    const auto& words = key_.choices;
    if (std::find(words.begin(), words.end(), raw.text()) == words.end()) {
      fail(raw, "\"" + raw.text() + "\" is not known." + did_you_mean(raw.text(), words),
           "choices: " + join(words));
    }
    return raw.text();
  }

  std::string formula(const Config& raw) const {
    if (raw.is(Kind::integer)) return std::to_string(raw.integer());
    if (raw.is(Kind::real)) {
      if (!std::isfinite(raw.real())) fail(raw, number_text(raw.real()) + " is not finite");
      return number_text(raw.real());
    }
    if (!raw.is(Kind::text)) wrong_kind(raw, "an expression in quotes, or a number");
    try {
      const Expression parsed(raw.text());
    } catch (const Error& e) {
      fail(raw, e.cause(), e.remedy());
    }
    return raw.text();
  }

  const Config::Array& list(const Config& raw, std::size_t least) const {
    if (!raw.is(Kind::array)) wrong_kind(raw, "a list");
    if (raw.array().size() < least) {
      fail(raw, "the list has " + std::to_string(raw.array().size()) + " elements; at least " +
                    std::to_string(least) + " are wanted");
    }
    return raw.array();
  }

  void check_length(const Config& raw, std::size_t length) const {
    const bool right = dimensions_ == 0 ? length == 2 || length == 3
                                        : length == static_cast<std::size_t>(dimensions_);
    if (right) return;
    fail(raw, "has " + std::to_string(length) + " components; " +
                  (dimensions_ == 0
                       ? std::string("2 or 3 are wanted")
                       : std::to_string(dimensions_) +
                             " are wanted (run.dimension = " + std::to_string(dimensions_) + ")"));
  }

  SettingValue vector(const Config& raw) const {
    if (key_.free_word.empty()) return position(raw);
    const auto& elements = list(raw, 0);
    check_length(raw, elements.size());
    Components components;
    for (const auto& element : elements) {
      const bool free = element.is(Kind::text) && element.text() == key_.free_word;
      components.push_back(free ? std::nullopt : std::optional<double>(number(element)));
    }
    const auto fixed = [](const auto& c) { return c.has_value(); };
    if (std::none_of(components.begin(), components.end(), fixed)) {
      fail(raw, "every component is \"" + key_.free_word + "\"; nothing is prescribed",
           "leave the key out");
    }
    return components;
  }

  std::vector<double> position(const Config& raw) const {
    auto values = numbers(raw, 0);
    check_length(raw, values.size());
    return values;
  }

  std::vector<double> rotation(const Config& raw) const {
    if (dimensions_ == 2 || (dimensions_ == 0 && !raw.is(Kind::array))) return {number(raw)};
    return position(raw);
  }

  std::vector<double> numbers(const Config& raw, std::size_t least) const {
    std::vector<double> values;
    for (const auto& element : list(raw, least)) values.push_back(number(element));
    return values;
  }

  std::vector<std::int64_t> integers(const Config& raw) const {
    std::vector<std::int64_t> values;
    for (const auto& element : list(raw, 1)) values.push_back(integer(element));
    return values;
  }

  std::vector<std::string> texts(const Config& raw) const {
    std::vector<std::string> words;
    std::set<std::string> seen;
    for (const auto& element : list(raw, 0)) {
      words.push_back(key_.choices.empty() ? text(element) : choice(element));
      if (!seen.insert(words.back()).second) {
        fail(element, "\"" + words.back() + "\" is named twice");
      }
    }
    return words;
  }

  /// As --set takes them: a text without its quotes, so that the resolved scene reads the same.
  std::vector<std::string> values(const Config& raw) const {
    std::vector<std::string> words;
    for (const auto& element : list(raw, 0)) {
      words.push_back(element.is(Kind::text) ? text(element) : element.written());
    }
    return words;
  }

  std::vector<std::string> pairs(const Config& raw) const {
    if (raw.is(Kind::array)) return texts(raw);  // as the resolved scene has them
    if (!raw.is(Kind::table)) wrong_kind(raw, "{ name = quantity, ... }");
    std::vector<std::string> words;
    for (const auto& [name, value] : raw.table()) {
      if (value.is(Kind::array) || value.is(Kind::table) || value.is(Kind::boolean)) {
        fail(value, name + " expects a number or a quantity in quotes, not " + value.describe());
      }
      words.push_back(name + " = " + (value.is(Kind::text) ? text(value) : value.written()));
    }
    return words;
  }

  Points points(const Config& raw, std::size_t least) const {
    Points values;
    for (const auto& element : list(raw, least)) values.push_back(position(element));
    return values;
  }

  Lines lines(const Config& raw) const {
    Lines values;
    for (const auto& element : list(raw, 1)) values.push_back(points(element, 2));
    return values;
  }

  Points table(const Config& raw) const {
    Points rows;
    for (const auto& row : list(raw, 2)) {
      if (!row.is(Kind::array) || row.array().size() != 2) {
        fail(row, "row " + std::to_string(rows.size() + 1) + " is not a pair [" +
                      dimension_name(key_.first_dimension) + ", " + dimension_name(key_.dimension) +
                      "]");
      }
      const double first = quantity(row.array()[0], key_.first_dimension);
      if (!rows.empty() && first <= rows.back()[0]) {
        fail(row,
             "row " + std::to_string(rows.size() + 1) + " begins with " + number_text(first) +
                 ", not after " + number_text(rows.back()[0]),
             "the first column increases from row to row");
      }
      rows.push_back({first, number(row.array()[1])});
    }
    return rows;
  }

  const Key& key_;
  int dimensions_;
};

}  // namespace

Settings::Value read_key_value(const Key& key, const Config& raw, int dimensions) {
  Settings::Value v;
  v.key = key.name;
  v.value = Reader(key, dimensions).read(raw);
  const bool mixed = key.type == KeyType::table && key.first_dimension != key.dimension;
  v.dimension = mixed ? unit::none : key.dimension;
  v.place = raw.place();
  if (v.place.file == "--set") v.origin = Settings::Origin::option;
  if (v.place.file == "default") v.origin = Settings::Origin::fallback;
  const bool converted = key.type == KeyType::number && raw.is(Config::Kind::text);
  if (converted) v.written = "\"" + raw.text() + "\"";
  return v;
}

}  // namespace breccia
