#pragma once
#include "core/error.hpp"
#include "core/place.hpp"
#include "core/unit.hpp"

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace breccia {

using Components = std::vector<std::optional<double>>;  ///< nullopt: the component is free
using Points = std::vector<std::vector<double>>;
using Lines = std::vector<Points>;
using SettingValue =
    std::variant<bool, std::int64_t, double, std::string, std::vector<double>,
                 std::vector<std::int64_t>, std::vector<std::string>, Components, Points, Lines>;

/// A section of a resolved scene: every key with its value in SI and where it came from.
///
/// Made by Schema::resolve, so that a reader never meets a missing required key, a wrong kind or a
/// value out of range. Asking for a key that the schema does not have is std::logic_error.
class Settings {
 public:
  enum class Origin { scene, option, fallback };
  enum class Kind { single, named, list };

  struct Value {
    std::string key;
    SettingValue value;
    Dimension dimension;
    Place place;
    Origin origin = Origin::scene;
    std::string written;  ///< as the user wrote it, where that differs from SI
  };
  struct Group {
    std::string word;  ///< "body", "material", "mesh"
    Kind kind = Kind::single;
    std::vector<Settings> members;
  };

  Settings() = default;
  Settings(std::string path, std::string name, Place place)
      : path_(std::move(path)), name_(std::move(name)), place_(std::move(place)) {}

  /// "body.disc", "material.granite", "run"; empty for the whole scene.
  [[nodiscard]] const std::string& path() const { return path_; }
  /// "granite" for [material.granite]; for a list its key `name`, else its index.
  [[nodiscard]] const std::string& name() const { return name_; }

  /// True for a key with a value (given or default) and for an inner section that exists.
  /// Dots lead into inner sections: `body.has("mesh.size")`.
  [[nodiscard]] bool has(std::string_view path) const;
  /// True when the user wrote the key or section (in the scene or with --set).
  [[nodiscard]] bool given(std::string_view path) const;

  // Dots lead into inner sections here too: `material.number("elastic.young")`.
  [[nodiscard]] bool flag(std::string_view key) const;
  [[nodiscard]] std::int64_t integer(std::string_view key) const;
  [[nodiscard]] double number(std::string_view key) const;
  [[nodiscard]] const std::string& text(std::string_view key) const;
  [[nodiscard]] const std::vector<double>& vector(std::string_view key) const;
  [[nodiscard]] const std::vector<std::int64_t>& integers(std::string_view key) const;
  [[nodiscard]] const std::vector<std::string>& texts(std::string_view key) const;
  [[nodiscard]] const Components& components(std::string_view key) const;
  [[nodiscard]] const Points& points(std::string_view key) const;
  [[nodiscard]] const Lines& lines(std::string_view key) const;
  [[nodiscard]] std::optional<double> maybe_number(std::string_view key) const;
  [[nodiscard]] std::string text_or(std::string_view key, std::string otherwise) const;

  /// A single inner section: `scene.at("run")`, `body.at("mesh")`; dots lead deeper.
  [[nodiscard]] const Settings& at(std::string_view path) const;
  /// Members of a named section in scene order: `scene.children("material")`.
  [[nodiscard]] const std::vector<Settings>& children(std::string_view word) const;
  /// Elements of a list in scene order: `scene.list("body")`.
  [[nodiscard]] const std::vector<Settings>& list(std::string_view word) const;
  /// The member of that name, or nullptr: `scene.find("material", "granite")`.
  [[nodiscard]] const Settings* find(std::string_view word, std::string_view name) const;

  /// "scene.toml:41" of a key, or of the section itself where the key is empty or a default.
  [[nodiscard]] std::string place(std::string_view key = {}) const;
  /// An error about a key, ready to throw: "scene.toml:41: body.disc.material: cause".
  [[nodiscard]] Error error(std::string_view key, const std::string& cause,
                            const std::string& remedy = {}) const;

  /// The scene with every key, in SI; read again it gives the same settings.
  void write_resolved(std::ostream& out) const;

  // For Schema::resolve, which builds the tree.
  void add(Value value) { values_.push_back(std::move(value)); }
  Group& group(std::string_view word, Kind kind);
  [[nodiscard]] const std::vector<Value>& values() const { return values_; }
  [[nodiscard]] const std::vector<Group>& groups() const { return groups_; }

 private:
  [[nodiscard]] const Value* value(std::string_view key) const;
  [[nodiscard]] const Group* find_group(std::string_view word) const;
  template <class T>
  [[nodiscard]] const T& get(std::string_view key, const char* kind) const;

  std::string path_, name_;
  Place place_;
  std::vector<Value> values_;
  std::vector<Group> groups_;
};

}  // namespace breccia
