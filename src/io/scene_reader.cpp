#include "io/scene_reader.hpp"

#include "core/error.hpp"
#include "core/text.hpp"

#include <toml.hpp>

#include <algorithm>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

namespace breccia {

namespace {

/// std::map, because toml11's own table would lose the order of equal lines from run to run.
using Value = toml::basic_value<toml::discard_comments, std::map, std::vector>;

/// Order in which values were written; for an inner table, of the first thing in it.
using Written = std::pair<std::uint_least32_t, std::uint_least32_t>;

Written written_at(const Value& value) {
  const auto place = value.location();
  Written first{place.line(), place.column()};
  const auto earlier = [&first](const Value& inner) { first = std::min(first, written_at(inner)); };
  if (value.is_table()) {
    for (const auto& entry : value.as_table()) earlier(entry.second);
  } else if (value.is_array()) {
    for (const auto& element : value.as_array()) earlier(element);
  }
  return first;
}

class Converter {
 public:
  Converter(std::string file, bool has_lines) : file_(std::move(file)), has_lines_(has_lines) {}

  Config convert(const Value& value) const {
    const Place place{file_, has_lines_ ? static_cast<int>(written_at(value).first) : 0};
    switch (value.type()) {
      case toml::value_t::boolean:
        return {value.as_boolean(), place};
      case toml::value_t::integer:
        return {checked(static_cast<std::int64_t>(value.as_integer()), place), place};
      case toml::value_t::floating:
        return {checked(static_cast<double>(value.as_floating()), place), place};
      case toml::value_t::string:
        return {value.as_string().str, place};
      case toml::value_t::array:
        return array(value, place);
      case toml::value_t::table:
        return table(value, place);
      default:
        break;
    }
    throw Error(place.text(), "dates and times have no meaning in a scene",
                "put a text in quotes: \"...\"");
  }

 private:
  /// toml11 gives the largest number there is for one that is larger still.
  template <class T>
  static T checked(T number, const Place& place) {
    if (number != std::numeric_limits<T>::max()) return number;
    throw Error(place.text(), "the number is too large for this machine");
  }

  Config array(const Value& value, const Place& place) const {
    Config::Array elements;
    for (const auto& element : value.as_array()) elements.push_back(convert(element));
    return {std::move(elements), place};
  }

  Config table(const Value& value, const Place& place) const {
    std::vector<std::pair<Written, const std::pair<const std::string, Value>*>> order;
    for (const auto& entry : value.as_table()) {
      order.emplace_back(written_at(entry.second), &entry);
    }
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    Config::Table entries;
    for (const auto& [at, entry] : order)
      entries.emplace_back(entry->first, convert(entry->second));
    return {std::move(entries), place};
  }

  std::string file_;
  bool has_lines_;
};

/// toml11 explains in many lines, with machine paths of its own; the first line and the marks under
/// the text are what a user needs.
Error syntax_error(const std::string& file, const toml::exception& e) {
  const auto line = static_cast<int>(e.location().line());
  std::string cause, detail;
  std::istringstream text(e.what());
  for (std::string row; std::getline(text, row);) {
    if (cause.empty()) {
      const auto colon = row.find(": ");
      cause = colon == std::string::npos ? row : row.substr(colon + 2);
    } else if (row.find("-->") == std::string::npos) {
      detail += (detail.empty() ? "" : "\n") + row;
    }
  }
  if (cause.rfind("[error] ", 0) == 0) cause.erase(0, 8);
  if (cause.rfind("toml::", 0) == 0 && cause.find(": ") != std::string::npos) {
    cause.erase(0, cause.find(": ") + 2);
  }
  if (detail.find("expected newline") != std::string::npos) {
    detail += "\na quantity with a unit, and any other text, is written in quotes: \"3 mm\"";
  }
  return {Place{file, line}.text(), "this is not TOML: " + cause, detail};
}

Value parse(const std::string& text, const std::string& name) {
  std::istringstream stream(text);
  return toml::parse<toml::discard_comments, std::map, std::vector>(stream, name);
}

/// "2" and "[1, 2]" are TOML; "2 ms" and "strain" are texts whose quotes the shell has eaten.
Config option_value(const std::string& text) {
  const Converter converter("--set", false);
  try {
    const Value value = parse("value = " + text + "\n", "--set");
    const auto& table = value.as_table();
    if (table.size() == 1) return converter.convert(table.at("value"));
  } catch (const toml::exception&) {  // a bare word
  }
  return {text, Place{"--set", 0}};
}

void apply_option(Config& scene, const std::string& option) {
  const auto equals = option.find('=');
  const std::string key = trimmed(option.substr(0, equals));
  const std::string value = equals == std::string::npos ? "" : trimmed(option.substr(equals + 1));
  if (key.empty() || value.empty()) {
    throw Error("--set", "'" + option + "' is not key=value",
                "for example: --set run.duration=2ms  or  --set body.disc.mesh.size=\"1 mm\"");
  }
  scene.set(key, option_value(value));
}

}  // namespace

std::filesystem::path find_scene_file(const std::filesystem::path& named) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (fs::is_directory(named, ignored)) {
    const fs::path inside = named / "scene.toml";
    if (fs::is_regular_file(inside, ignored)) return inside;
    throw Error(named.string(), "the folder holds no scene.toml", "name the scene file itself");
  }
  if (fs::is_regular_file(named, ignored)) return named;
  const fs::path with_ending = named.string() + ".toml";
  if (fs::is_regular_file(with_ending, ignored)) {
    throw Error(named.string(), "no such scene. Did you mean '" + with_ending.string() + "'?");
  }
  throw Error(named.string(), "no such scene", "name a TOML file, or a folder with a scene.toml");
}

Config read_scene(const std::filesystem::path& file, const std::vector<std::string>& options) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  if (stream) text << stream.rdbuf();
  if (!stream || stream.bad()) {
    throw Error(file.string(), "the scene cannot be read", "check that the file is readable");
  }
  return read_scene_text(text.str(), file.string(), options);
}

Config read_scene_text(const std::string& text, const std::string& name,
                       const std::vector<std::string>& options) {
  if (text.find('\0') != std::string::npos) {
    throw Error(name, "this is not a text file");
  }
  Config scene;
  if (trimmed(text).empty()) {  // toml11 refuses an empty stream
    scene = Config(Config::Table{}, Place{name, 0});
  } else {
    try {
      scene = Converter(name, true).convert(parse(text, name));
    } catch (const toml::exception& e) {
      throw syntax_error(name, e);
    } catch (const std::runtime_error& e) {
      if (dynamic_cast<const Error*>(&e) != nullptr) throw;
      throw Error(name, std::string("this is not TOML: ") + e.what());
    }
  }
  for (const auto& option : options) apply_option(scene, option);
  return scene;
}

}  // namespace breccia
