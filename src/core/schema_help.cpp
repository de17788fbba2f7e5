// The table of keys as text: `breccia help` and docs/input.md.
#include "core/schema.hpp"
#include "core/text.hpp"

#include <algorithm>
#include <ostream>
#include <sstream>

namespace breccia {

namespace {

/// Whether `words` spell the pattern, where the name of a named section ("granite") or of a list
/// element may be left out, or must be when `strict`.
bool spells(const std::vector<std::string>& pattern, std::size_t p,
            const std::vector<std::string>& words, std::size_t w, bool strict) {
  if (p == pattern.size()) return w == words.size();
  if (pattern[p] == "*") {
    if (spells(pattern, p + 1, words, w, strict)) return true;
    return !strict && w < words.size() && spells(pattern, p + 1, words, w + 1, strict);
  }
  return w < words.size() && pattern[p] == words[w] && spells(pattern, p + 1, words, w + 1, strict);
}

/// "body[].mesh" as {"body", "*", "mesh"}.
std::vector<std::string> pattern_words(const std::string& pattern) {
  std::vector<std::string> words;
  for (auto& word : split(pattern, '.')) {
    const bool list = word.size() > 2 && word.compare(word.size() - 2, 2, "[]") == 0;
    words.push_back(list ? word.substr(0, word.size() - 2) : word);
    if (list) words.emplace_back("*");
  }
  return words;
}

/// "body[].mesh.size", "[[body]]", "[run]" as a person may type them.
std::vector<std::string> query_words(std::string_view path) {
  std::string plain;
  for (const char c : path) {
    if (c != '[' && c != ']' && c != '"') plain += c;
  }
  auto words = split(plain, '.');
  words.erase(std::remove(words.begin(), words.end(), "*"), words.end());
  return words;
}

std::string facts(const Key& key) {
  std::string text = "  kind     " + key.kind_text() + "\n";
  const std::string unit = key.unit_text();
  if (!unit.empty()) text += "  unit     " + unit + " (a number without quotes is taken in it)\n";
  if (key.range.limited()) text += "  range    " + key.range.text(key.dimension) + "\n";
  const std::string fallback = key.default_text();
  text += "  default  " +
          (!fallback.empty() ? fallback
           : key.required    ? "none, must be given"
                             : "none") +
          "\n";
  if (key.only_in != 0) text += "  only in  " + std::to_string(key.only_in) + "D\n";
  if (!key.free_word.empty()) text += "  also     a component may be \"" + key.free_word + "\"\n";
  if (!key.refers_to.empty()) text += "  names    one " + key.refers_to + " of the scene\n";
  if (!key.doc.empty()) text += "  meaning  " + key.doc + "\n";
  if (!key.example_text().empty()) text += "  example  " + key.example_text() + "\n";
  return text;
}

std::string key_line(const Key& key) {
  std::string line = "  " + key.name;
  line.resize(std::max<std::size_t>(line.size() + 1, 18), ' ');
  const std::string unit = key.unit_text();
  line += unit.empty() ? "" : "[" + unit + "] ";
  line += key.doc;
  if (key.required) line += " (required)";
  const std::string fallback = key.default_text();
  if (!fallback.empty()) line += " (default " + fallback + ")";
  return line + "\n";
}

std::string section_text(const Schema& schema, const Section& section) {
  std::string text = section.title() + "  " + section.doc + "\n";
  if (!section.effect.empty()) text += "  switches on: " + section.effect + "\n";
  for (const auto& key : section.keys) text += key_line(key);
  for (const Section* inner : schema.inside(section)) {
    text += "  " + inner->local + "  a section of its own: breccia help " + inner->path() + "\n";
  }
  for (const auto& words : section.exactly_one) text += "  exactly one of: " + join(words) + "\n";
  for (const auto& words : section.at_most_one) text += "  at most one of: " + join(words) + "\n";
  return text;
}

std::vector<std::string> all_paths(const Schema& schema) {
  std::vector<std::string> paths;
  for (const auto& s : schema.sections()) {
    if (!s.pattern.empty()) paths.push_back(s.path());
    for (const auto& k : s.keys)
      paths.push_back(s.pattern.empty() ? k.name : s.path() + "." + k.name);
  }
  return paths;
}

/// A bare word: all sections that have a key of that name.
std::string homes(const Schema& schema, const std::string& word) {
  std::string text;
  for (const auto& s : schema.sections()) {
    if (const Key* key = s.key(word)) {
      text += (text.empty() ? "" : "\n") + s.path() + (s.pattern.empty() ? "" : ".") + word +
              "  in " + s.title() + "\n" + facts(*key);
    }
  }
  return text;
}

/// "material.densty" could be a material of that name; a key nearly of that name is likelier meant.
bool nearly_a_key(const Section& section, const std::vector<std::string>& words) {
  const std::vector<std::string> front(words.begin(), words.end() - 1);
  std::vector<std::string> names;
  for (const auto& key : section.keys) names.push_back(key.name);
  return spells(pattern_words(section.pattern), 0, front, 0, true) &&
         !nearest(words.back(), names).empty();
}

std::string cell(std::string text) {
  std::string out;
  for (const char c : text) {
    if (c == '|') out += '\\';
    out += c;
  }
  return out;
}

void markdown_section(const Schema& schema, const Section& section, std::ostream& out) {
  out << "\n## " << (section.pattern.empty() ? "top" : "`" + section.title() + "`") << "\n\n"
      << section.doc << "\n";
  if (!section.effect.empty()) out << "\nSwitches on: " << section.effect << ".\n";
  if (section.only_in != 0) out << "\nOnly in " << section.only_in << "D.\n";
  if (!section.keys.empty()) {
    out << "\n| key | unit | kind | range | default | meaning |\n|---|---|---|---|---|---|\n";
  }
  for (const auto& key : section.keys) {
    const std::string range = key.range.limited() ? key.range.text(key.dimension) : "";
    const std::string fallback = key.default_text();
    std::string meaning = key.doc;
    if (key.only_in != 0) meaning += " Only in " + std::to_string(key.only_in) + "D.";
    if (!key.free_word.empty()) meaning += " A component may be \"" + key.free_word + "\".";
    if (!key.example.empty()) meaning += " Example: `" + key.example_text() + "`";
    out << "| `" << key.name << "` | " << key.unit_text() << " | " << cell(key.kind_text()) << " | "
        << range << " | "
        << (!fallback.empty() ? "`" + fallback + "`"
            : key.required    ? "required"
                              : "")
        << " | " << cell(meaning) << " |\n";
  }
  for (const auto& words : section.exactly_one) out << "\nExactly one of: " << join(words) << ".\n";
  for (const auto& words : section.at_most_one) out << "\nAt most one of: " << join(words) << ".\n";
  std::vector<std::string> inner;
  for (const Section* s : schema.inside(section)) {
    inner.push_back("[" + s->title() + "](#" + s->anchor() + ")");
  }
  if (!inner.empty() && !section.pattern.empty()) out << "\nInside: " << join(inner) << ".\n";
}

void markdown_tree(const Schema& schema, const Section& section, std::ostream& out) {
  markdown_section(schema, section, out);
  for (const Section* inner : schema.inside(section)) markdown_tree(schema, *inner, out);
}

}  // namespace

std::string Schema::help(std::string_view path) const {
  const auto words = query_words(path);
  for (const bool strict : {true, false}) {
    for (const auto& s : sections_) {
      if (words.empty()) break;
      const std::vector<std::string> front(words.begin(), words.end() - 1);
      const Key* key = s.key(words.back());
      const auto pattern = pattern_words(s.pattern);
      if (key != nullptr && spells(pattern, 0, front, 0, strict)) {
        const std::string full = s.path() + (s.pattern.empty() ? "" : ".") + key->name;
        return full + "\n" + facts(*key) + "  section  " + s.title() + "  " + s.doc + "\n";
      }
    }
    for (const auto& s : sections_) {
      if (s.pattern.empty() || !spells(pattern_words(s.pattern), 0, words, 0, strict)) continue;
      if (strict || !nearly_a_key(s, words)) {
        return section_text(*this, s);
      }
    }
  }
  if (words.size() == 1) {
    const std::string found = homes(*this, words[0]);
    if (!found.empty()) return found;
  }
  auto known = all_paths(*this);
  for (const auto& s : sections_) {
    for (const auto& k : s.keys) known.push_back(k.name);
  }
  throw Error(
      "help",
      "no key or section '" + std::string(path) + "'." + did_you_mean(join(words, "."), known),
      "breccia help lists all sections");
}

std::string Schema::overview() const {
  std::string text =
      "Sections of a scene; more by: breccia help SECTION or breccia help SECTION.KEY\n\n";
  for (const auto& s : sections_) {
    if (s.pattern.empty() || !s.parent.empty()) continue;
    std::string line = "  " + s.title();
    line.resize(std::max<std::size_t>(line.size() + 1, 20), ' ');
    text += line + s.doc + "\n";
  }
  text += "\nAt the top:\n";
  for (const auto& key : find("")->keys) text += key_line(key);
  return text;
}

void Schema::markdown(std::ostream& out) const {
  out << "# Scene keys\n\n"
         "Made by `breccia help --markdown` from the table of keys that also reads the scenes; do "
         "not "
         "edit.\n\n"
         "A scene is one TOML file. Quantities are texts with a unit (`\"60 GPa\"`) or plain "
         "numbers in "
         "SI.\nUnits: m g t s min h K rad deg N Pa bar J W Hz rpm %, prefixes p n u m c d h k M G "
         "T, "
         "joined by `.` and `/`,\nwith powers as in `kg/m3` or `m/s^2`.\n";
  markdown_tree(*this, *find(""), out);
}

}  // namespace breccia
