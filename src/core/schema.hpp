#pragma once
#include "core/config.hpp"
#include "core/error.hpp"
#include "core/settings.hpp"
#include "core/unit.hpp"

#include <cstdint>
#include <deque>
#include <functional>
#include <iosfwd>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace breccia {

/// What a key holds. The Settings accessor of each kind is in brackets.
enum class KeyType {
  flag,      ///< true or false [flag]
  integer,   ///< [integer]
  number,    ///< quantity with unit [number]
  text,      ///< [text]
  choice,    ///< one word of a list [text]
  formula,   ///< expression, text or number; syntax is checked [text]
  vector,    ///< quantities, as many as the scene has dimensions [vector, or components]
  rotation,  ///< one quantity in 2D, three in 3D [vector]
  numbers,   ///< list of quantities of any length [vector]
  integers,  ///< list of integers [integers]
  texts,     ///< list of words [texts]
  values,    ///< list of anything a key may hold, each as --set takes it [texts]
  pairs,     ///< inline table of names with quantities, each as "name = value" [texts]
  table,     ///< rows [a, b] of two dimensions, the first one increasing [points]
  points,    ///< list of positions [points]
  lines      ///< list of lists of positions [lines]
};

/// Interval of allowed values, in SI.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool open_low = false, open_high = false;

  friend bool operator==(const Range&, const Range&) = default;
  [[nodiscard]] bool admits(double value) const;
  [[nodiscard]] bool limited() const;
  /// "above 0 Pa", "from 0 to 0.5", "at least 1"; angles in degrees.
  [[nodiscard]] std::string text(Dimension dimension) const;
};

/// One row of the table of keys.
struct Key {
  std::string name;
  KeyType type = KeyType::number;
  Dimension dimension;        ///< of each number; of the second column of a table
  Dimension first_dimension;  ///< of the first column of a table
  Range range;                ///< of each number; of the second column of a table
  bool required = false;
  bool unique = false;      ///< no two elements of the list share this value
  bool identifier = false;  ///< letters, digits and _ only: the word is used in expressions
  bool file = false;        ///< a path from the scene's folder; made absolute
  int only_in = 0;          ///< 2 or 3: exists only in that many dimensions; 0: always
  std::string free_word;    ///< a component may be this word
  std::string refers_to;    ///< section whose names are allowed here, such as "material"
  std::vector<std::string> choices;
  std::optional<Config> default_value;
  std::string doc, example;

  [[nodiscard]] std::string kind_text() const;     ///< "pressure", "position (a list)", ...
  [[nodiscard]] std::string unit_text() const;     ///< "Pa"; empty where there is none
  [[nodiscard]] std::string example_text() const;  ///< `density = "2650 kg/m3"`
  [[nodiscard]] std::string default_text() const;  ///< as written in a scene; empty: none
};

/// One section of a scene. Patterns: "run" (single), "material.*" (named), "body[]" (list),
/// "body[].mesh" (inside another).
struct Section {
  enum class Kind { single, named, list };
  std::string pattern;  ///< "" is the top of the scene
  std::string parent;   ///< pattern of the section it stands in
  std::string local;    ///< its own word: "material", "body", "mesh"
  Kind kind = Kind::single;
  std::string doc, effect;
  std::string names_refer_to;  ///< of a named section: names must be those of this section
  bool required = false;
  bool always = false;  ///< exists with its defaults when the scene does not name it
  int only_in = 0;
  std::vector<std::vector<std::string>> exactly_one, at_most_one;
  std::deque<Key> keys;

  [[nodiscard]] const Key* key(std::string_view name) const;
  [[nodiscard]] std::string title() const;   ///< "[material.NAME]", "[[body]]", "body.mesh"
  [[nodiscard]] std::string path() const;    ///< "material", "body.mesh": for `breccia help`
  [[nodiscard]] std::string anchor() const;  ///< of its heading in docs/input.md
  /// "docs/input.md#run (or: breccia help run.duration)".
  [[nodiscard]] std::string page(std::string_view key = {}) const;
};

/// Handle with which code describes a key; every call returns the handle again.
class KeyBuilder {
 public:
  explicit KeyBuilder(Key& key) : key_(&key) {}
  KeyBuilder above(double low);
  KeyBuilder at_least(double low);
  KeyBuilder below(double high);
  KeyBuilder at_most(double high);
  KeyBuilder between(double low, double high);  ///< both included
  KeyBuilder required();
  KeyBuilder by_default(const char* value);  ///< as written in a scene: "1 m", "strain"
  KeyBuilder by_default(double value);       ///< SI
  KeyBuilder by_default(int value);
  KeyBuilder by_default(bool value);
  KeyBuilder by_default(const std::vector<std::string>& words);
  KeyBuilder doc(std::string text);
  KeyBuilder example(std::string text);  ///< "2650 kg/m3": a value as written in a scene
  KeyBuilder unique();
  KeyBuilder identifier();
  KeyBuilder names_file();
  KeyBuilder only_in(int dimension);
  KeyBuilder components_may_be(std::string word);
  KeyBuilder names_one_of(std::string section);

 private:
  Key* key_;
};

/// Handle with which code describes a section and its keys.
class SectionBuilder {
 public:
  explicit SectionBuilder(Section& section) : section_(&section) {}
  SectionBuilder doc(std::string text);
  SectionBuilder effect(std::string name);  ///< the section switches this effect on
  SectionBuilder required();
  SectionBuilder always();
  SectionBuilder only_in(int dimension);
  SectionBuilder names_refer_to(std::string section);             ///< for "fracture.*" and the like
  SectionBuilder exactly_one_of(std::vector<std::string> names);  ///< keys or inner sections
  SectionBuilder at_most_one_of(std::vector<std::string> names);

  KeyBuilder flag(std::string name);
  KeyBuilder integer(std::string name);
  KeyBuilder number(std::string name, Dimension dimension);
  KeyBuilder text(std::string name);
  KeyBuilder choice(std::string name, std::vector<std::string> words);
  KeyBuilder formula(std::string name);
  KeyBuilder vector(std::string name, Dimension dimension);
  KeyBuilder rotation(std::string name, Dimension dimension);
  KeyBuilder numbers(std::string name, Dimension dimension);
  KeyBuilder integers(std::string name);
  KeyBuilder texts(std::string name);
  KeyBuilder values(std::string name);
  KeyBuilder pairs(std::string name);
  KeyBuilder table(std::string name, Dimension first, Dimension second);
  KeyBuilder points(std::string name, Dimension dimension);
  KeyBuilder lines(std::string name, Dimension dimension);

 private:
  KeyBuilder add(std::string name, KeyType type, Dimension dimension);
  Section* section_;
};

/// The one table of keys: it reads scenes, answers `breccia help` and writes docs/input.md.
class Schema {
 public:
  using Check = std::function<void(const Settings& scene, Problems& problems)>;

  Schema();

  /// Opens a section, or the one of that pattern again so that several modules add to it.
  SectionBuilder section(std::string pattern);

  /// The top of the scene: title and the like.
  SectionBuilder top() { return section(""); }

  /// A rule about several keys; runs after each key has been found right on its own.
  void check(Check rule) { checks_.push_back(std::move(rule)); }

  /// Settles every key of a scene. \throws Error that lists everything wrong with it.
  [[nodiscard]] Settings resolve(const Config& scene) const;

  /// What `breccia help PATH` prints; sections and keys. \throws Error naming the nearest key.
  [[nodiscard]] std::string help(std::string_view path) const;

  /// All sections, one line each.
  [[nodiscard]] std::string overview() const;

  /// docs/input.md.
  void markdown(std::ostream& out) const;

  /// Patterns and effects of the sections that switch an effect on, in declaration order.
  [[nodiscard]] std::vector<const Section*> effects() const;

  [[nodiscard]] const std::deque<Section>& sections() const { return sections_; }
  [[nodiscard]] const Section* find(std::string_view pattern) const;
  [[nodiscard]] std::vector<const Section*> inside(const Section& section) const;

 private:
  std::deque<Section> sections_;
  std::vector<Check> checks_;
};

}  // namespace breccia
