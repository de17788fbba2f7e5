// From what was written to what it means: every key known, of its kind, in its range.
#include "core/key_value.hpp"
#include "core/schema.hpp"
#include "core/text.hpp"

#include <algorithm>
#include <filesystem>

namespace breccia {

namespace {

using Kind = Config::Kind;

std::vector<std::string> names_in(const Config& scene, const std::string& section) {
  std::vector<std::string> names;
  const Config* found = scene.find(section);
  if (found == nullptr) return names;
  if (found->is(Kind::table)) {
    for (const auto& entry : found->table()) names.push_back(entry.first);
  } else if (found->is(Kind::array)) {
    for (const auto& element : found->array()) {
      const Config* name = element.find("name");
      if (name != nullptr && name->is(Kind::text)) names.push_back(name->text());
    }
  }
  return names;
}

class Resolver {
 public:
  Resolver(const Schema& schema, const Config& scene) : schema_(schema), scene_(scene) {
    const Config* run = scene.find("run");
    const Config* dimension = run == nullptr ? nullptr : run->find("dimension");
    const bool said = dimension != nullptr && dimension->is(Kind::integer);
    if (said && (dimension->integer() == 2 || dimension->integer() == 3)) {
      dimensions_ = static_cast<int>(dimension->integer());
    }
  }

  Settings run(Problems& problems) {
    problems_ = &problems;
    Settings root("", "", scene_.place());
    table(*schema_.find(""), scene_, root);
    return root;
  }

 private:
  static std::string joined(const std::string& path, const std::string& word) {
    return path.empty() ? word : path + "." + word;
  }

  void table(const Section& section, const Config& raw, Settings& out) {
    check_known(section, raw, out.path());
    check_alternatives(section, raw, out.path());
    for (const auto& key : section.keys) value(section, key, raw, out);
    for (const Section* inner : schema_.inside(section)) group(*inner, raw, out);
  }

  void value(const Section& section, const Key& key, const Config& raw, Settings& out) {
    const std::string path = joined(out.path(), key.name);
    const Config* given = raw.find(key.name);
    const bool absent_here = key.only_in != 0 && dimensions_ != 0 && key.only_in != dimensions_;
    if (absent_here) {
      if (given != nullptr) wrong_dimension(given->place(), path, key.only_in);
      return;
    }
    if (given == nullptr && !key.default_value) {
      if (key.required) missing(section, key, raw, path);
      return;
    }
    try {
      Settings::Value v = read_key_value(key, given ? *given : *key.default_value, dimensions_);
      check_reference(key, v);
      if (key.file) make_absolute(v);
      out.add(std::move(v));
    } catch (const Error& e) {
      const std::string cause = path + ": " + e.cause();
      const std::string more = e.remedy().empty() ? "" : e.remedy() + "\n";
      problems_->add(e.place(), cause, more + section.page(key.name));
    }
  }

  void missing(const Section& section, const Key& key, const Config& raw, const std::string& path) {
    std::string remedy =
        key.example_text().empty() ? "" : "for example: " + key.example_text() + "\n";
    problems_->add(raw.place().text(), path + ": is missing (" + key.kind_text() + ")",
                   remedy + section.page(key.name));
  }

  void wrong_dimension(const Place& place, const std::string& path, int only_in) {
    problems_->add(place.text(), path + ": is for " + (only_in == 2 ? "two" : "three") +
                                     " dimensions; this scene has run.dimension = " +
                                     std::to_string(dimensions_));
  }

  /// So that the resolved scene in the output folder still finds its files.
  void make_absolute(Settings::Value& v) const {
    auto& path = std::get<std::string>(v.value);
    if (std::filesystem::path(path).is_absolute()) return;
    v.written = "\"" + path + "\"";
    const auto folder = std::filesystem::path(scene_.place().file).parent_path();
    path = std::filesystem::absolute(folder / path).lexically_normal().string();
  }

  /// \throws Error unless the scene has a section of that name.
  void refer(const std::string& section, const std::string& word, const Place& place) const {
    const auto names = names_in(scene_, section);
    if (std::find(names.begin(), names.end(), word) != names.end()) return;
    throw Error(place.text(),
                "no " + section + " '" + word + "' in this scene." + did_you_mean(word, names),
                names.empty() ? "the scene has no " + section : section + " names: " + join(names));
  }

  void check_reference(const Key& key, const Settings::Value& v) const {
    if (key.refers_to.empty()) return;
    if (const auto* words = std::get_if<std::vector<std::string>>(&v.value)) {
      for (const auto& word : *words) refer(key.refers_to, word, v.place);
    } else {
      refer(key.refers_to, std::get<std::string>(v.value), v.place);
    }
  }

  // ---- sections

  void group(const Section& section, const Config& raw, Settings& out) {
    const Config* given = raw.find(section.local);
    const std::string path = joined(out.path(), section.local);
    if (section.only_in != 0 && dimensions_ != 0 && section.only_in != dimensions_) {
      if (given != nullptr) wrong_dimension(given->place(), path, section.only_in);
      return;
    }
    if (given == nullptr) return absent(section, raw, path, out);
    switch (section.kind) {
      case Section::Kind::single:
        return single(section, *given, path, out);
      case Section::Kind::named:
        return named(section, *given, path, out);
      case Section::Kind::list:
        return list(section, *given, path, out);
    }
  }

  void absent(const Section& section, const Config& raw, const std::string& path, Settings& out) {
    if (section.required) {
      const bool top = section.parent.empty();
      problems_->add(top ? raw.place().file : raw.place().text(),
                     path + (top ? ": the scene has no " + section.title() : ": is missing"),
                     section.page());
    }
    if (!section.always || section.kind != Section::Kind::single) return;
    const Place nowhere{"default", 0};
    const Config empty(Config::Table{}, section.required ? raw.place() : nowhere);
    Settings& inner = out.group(section.local, Settings::Kind::single)
                          .members.emplace_back(path, section.local, nowhere);
    if (!section.required) table(section, empty, inner);
  }

  bool is_table(const Section& section, const Config& raw, const std::string& path) {
    if (raw.is(Kind::table)) return true;
    problems_->add(raw.place().text(), path + ": is a section, not " + raw.describe(),
                   "write " + section.title() + "\n" + section.page());
    return false;
  }

  void single(const Section& section, const Config& raw, const std::string& path, Settings& out) {
    if (!is_table(section, raw, path)) return;
    auto& members = out.group(section.local, Settings::Kind::single).members;
    table(section, raw, members.emplace_back(path, section.local, raw.place()));
  }

  void named(const Section& section, const Config& raw, const std::string& path, Settings& out) {
    if (!is_table(section, raw, path)) return;
    auto& members = out.group(section.local, Settings::Kind::named).members;
    members.reserve(raw.table().size());  // the elements must not move while they are filled
    for (const auto& [name, body] : raw.table()) {
      const std::string full = joined(path, name);
      if (!body.is(Kind::table)) {
        const bool key = section.key(name) != nullptr;
        problems_->add(
            body.place().text(),
            full + (key ? ": stands outside a named section"
                        : ": is a section, not " + body.describe()),
            "write " + section.title() + " with a name of your own for NAME\n" + section.page());
        continue;
      }
      check_section_name(section, name, body.place(), full);
      table(section, body, members.emplace_back(full, name, body.place()));
    }
  }

  void check_section_name(const Section& section, const std::string& name, const Place& place,
                          const std::string& path) {
    if (section.names_refer_to.empty()) return;
    try {
      refer(section.names_refer_to, name, place);
    } catch (const Error& e) {
      problems_->add(e.place(), path + ": " + e.cause(), e.remedy() + "\n" + section.page());
    }
  }

  void list(const Section& section, const Config& raw, const std::string& path, Settings& out) {
    if (!raw.is(Kind::array)) {
      problems_->add(raw.place().text(), path + ": is a list of sections, not " + raw.describe(),
                     "write " + section.title() + "\n" + section.page());
      return;
    }
    auto& members = out.group(section.local, Settings::Kind::list).members;
    members.reserve(raw.array().size());
    for (const auto& element : raw.array()) {
      std::string name = std::to_string(members.size());
      const Config* said = section.key("name") != nullptr ? element.find("name") : nullptr;
      if (said != nullptr && said->is(Kind::text)) name = said->text();
      const std::string full = joined(path, name);
      Settings& member = members.emplace_back(full, name, element.place());
      if (is_table(section, element, full)) table(section, element, member);
    }
    if (section.required && members.empty()) {
      problems_->add(raw.place().text(), path + ": the list is empty", section.page());
    }
    for (const auto& key : section.keys) {
      if (key.unique) check_unique(key, section, members);
    }
  }

  void check_unique(const Key& key, const Section& section, const std::vector<Settings>& members) {
    std::vector<std::string> seen;
    for (const auto& member : members) {
      if (!member.has(key.name)) continue;
      const std::string& word = member.text(key.name);
      if (std::find(seen.begin(), seen.end(), word) != seen.end()) {
        problems_->add(member.place(key.name),
                       section.path() + "." + key.name + ": \"" + word + "\" is used twice",
                       "each " + section.title() + " needs its own " + key.name);
      }
      seen.push_back(word);
    }
  }

  // ---- names

  void check_known(const Section& section, const Config& raw, const std::string& path) {
    std::vector<std::string> legal;
    for (const auto& key : section.keys) legal.push_back(key.name);
    for (const Section* inner : schema_.inside(section)) legal.push_back(inner->local);
    for (const auto& [name, body] : raw.table()) {
      if (std::find(legal.begin(), legal.end(), name) == legal.end()) {
        unknown(section, name, body.place(), joined(path, name), legal);
      }
    }
  }

  void unknown(const Section& section, const std::string& name, const Place& place,
               const std::string& path, const std::vector<std::string>& legal) {
    std::string cause = path + ": no such key.";
    const std::string near = nearest(name, legal);
    if (!near.empty()) {
      const Key* meant = section.key(near);
      const std::string unit = meant == nullptr ? "" : meant->unit_text();
      cause += " Did you mean '" + near + "'" + (unit.empty() ? "" : " [" + unit + "]") + "?";
    } else if (const Section* home = home_of(name)) {
      cause += " '" + name + "' belongs in " + home->title();
    }
    problems_->add(place.text(), cause, keys_here(section) + "\n" + section.page());
  }

  [[nodiscard]] const Section* home_of(const std::string& name) const {
    for (const auto& s : schema_.sections()) {
      if (s.key(name) != nullptr) return &s;
    }
    return nullptr;
  }

  [[nodiscard]] std::string keys_here(const Section& section) const {
    std::vector<std::string> words;
    for (const auto& key : section.keys) {
      const std::string unit = key.unit_text();
      words.push_back(key.name + (unit.empty() ? "" : " [" + unit + "]"));
    }
    for (const Section* inner : schema_.inside(section)) words.push_back(inner->local);
    std::sort(words.begin(), words.end());
    return "keys here: " + join(words);
  }

  void check_alternatives(const Section& section, const Config& raw, const std::string& path) {
    for (const auto& words : section.exactly_one) one_of(section, words, raw, path, true);
    for (const auto& words : section.at_most_one) one_of(section, words, raw, path, false);
  }

  void one_of(const Section& section, const std::vector<std::string>& words, const Config& raw,
              const std::string& path, bool needed) {
    std::vector<std::string> given;
    for (const auto& word : words) {
      if (raw.find(word) != nullptr) given.push_back(word);
    }
    if (given.size() > 1) {
      problems_->add(raw.find(given[1])->place().text(),
                     path + ": " + join(given, " and ") + " exclude each other",
                     "give one of: " + join(words) + "\n" + section.page());
    } else if (given.empty() && needed) {
      problems_->add(raw.place().text(), path + ": needs one of " + join(words), section.page());
    }
  }

  const Schema& schema_;
  const Config& scene_;
  Problems* problems_ = nullptr;
  int dimensions_ = 0;
};

}  // namespace

Settings Schema::resolve(const Config& scene) const {
  Problems problems;
  Settings settings = Resolver(*this, scene).run(problems);
  problems.raise();  // the rules below may rely on every key being right
  for (const auto& rule : checks_) rule(settings, problems);
  problems.raise();
  return settings;
}

}  // namespace breccia
