#pragma once
#include "core/place.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace breccia {

/// A scene as it was written: a tree of raw values, each with its place. Built by io/scene_reader;
/// the schema gives it meaning.
class Config {
 public:
  using Array = std::vector<Config>;
  using Entry = std::pair<std::string, Config>;
  using Table = std::vector<Entry>;  ///< in scene order
  enum class Kind { boolean, integer, real, text, array, table };

  Config() : value_(Table{}) {}
  Config(bool value, Place place) : value_(value), place_(std::move(place)) {}
  Config(std::int64_t value, Place place) : value_(value), place_(std::move(place)) {}
  Config(double value, Place place) : value_(value), place_(std::move(place)) {}
  Config(std::string value, Place place) : value_(std::move(value)), place_(std::move(place)) {}
  Config(Array value, Place place) : value_(std::move(value)), place_(std::move(place)) {}
  Config(Table value, Place place) : value_(std::move(value)), place_(std::move(place)) {}

  [[nodiscard]] Kind kind() const { return static_cast<Kind>(value_.index()); }
  [[nodiscard]] bool is(Kind kind) const { return this->kind() == kind; }
  [[nodiscard]] const Place& place() const { return place_; }

  // Each demands the right kind (std::bad_variant_access otherwise).
  [[nodiscard]] bool boolean() const { return std::get<bool>(value_); }
  [[nodiscard]] std::int64_t integer() const { return std::get<std::int64_t>(value_); }
  [[nodiscard]] double real() const { return std::get<double>(value_); }
  [[nodiscard]] const std::string& text() const { return std::get<std::string>(value_); }
  [[nodiscard]] const Array& array() const { return std::get<Array>(value_); }
  [[nodiscard]] const Table& table() const { return std::get<Table>(value_); }
  [[nodiscard]] Array& array() { return std::get<Array>(value_); }
  [[nodiscard]] Table& table() { return std::get<Table>(value_); }

  /// The entry of a table, or nullptr when there is none or this is no table.
  [[nodiscard]] const Config* find(std::string_view key) const;
  [[nodiscard]] Config* find(std::string_view key);

  /// Replaces the value at a path such as `body.disc.mesh.size` or `body.0.mesh.size`.
  /// List elements are named by their index or by their key `name`; parts with dots or blanks are
  /// quoted (`boundary."upper platen".ramp`); missing tables on the way are made.
  /// \throws Error (place "--set") when the path meets a value, or a list element is not there.
  void set(std::string_view path, Config value);

  /// The value as it stands in a scene: `"2 mm"`, `3`, `[1, 2]`, `{ young = 3 }`.
  [[nodiscard]] std::string written() const;

  /// "a list", "the text "x"", "the number 3": for messages.
  [[nodiscard]] std::string describe() const;

 private:
  std::variant<bool, std::int64_t, double, std::string, Array, Table> value_;
  Place place_;
};

/// Parts of a dotted path of keys; quoted parts may hold dots and blanks.
/// \throws Error (place "--set") when a part is empty or a quote is open.
std::vector<std::string> key_path(std::string_view path);

}  // namespace breccia
