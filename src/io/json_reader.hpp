#pragma once

#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace breccia {

/// A value of a JSON text, as report.json and job.json hold them. Numbers are doubles; null is a
/// number without a value, as JsonWriter writes it.
class Json {
 public:
  using Array = std::vector<Json>;
  using Object = std::map<std::string, Json, std::less<>>;

  Json();  ///< null
  explicit Json(bool value) : value_(value) {}
  explicit Json(double value) : value_(value) {}
  explicit Json(std::string value) : value_(std::move(value)) {}
  explicit Json(Array value) : value_(std::move(value)) {}
  explicit Json(Object value) : value_(std::move(value)) {}

  /// The member of an object, or null where there is none or this is no object.
  [[nodiscard]] const Json& operator[](std::string_view name) const;
  /// Elements; empty where this is no array.
  [[nodiscard]] const Array& array() const;
  /// Members in the order of their names; empty where this is no object.
  [[nodiscard]] const Object& object() const;
  [[nodiscard]] double number() const;     ///< not-a-number where this is no number
  [[nodiscard]] std::string text() const;  ///< empty where this is no text
  [[nodiscard]] bool flag() const;         ///< false where this is no flag

 private:
  std::variant<bool, double, std::string, Array, Object> value_;
};

/// Reads a JSON text. \throws Error with `name` as place when it is not JSON.
Json parse_json(std::string_view text, const std::string& name);

/// Reads a JSON file. \throws Error when it cannot be read or is not JSON.
Json read_json(const std::string& path);

}  // namespace breccia
