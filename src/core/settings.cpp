#include "core/settings.hpp"

#include <stdexcept>

namespace breccia {

namespace {

/// Asking for what the schema does not declare, or as another kind: a mistake in the code.
[[noreturn]] void misuse(const Settings& section, std::string_view key, const std::string& what) {
  throw std::logic_error("settings: '" + section.path() + "' has no " + what + " '" +
                         std::string(key) + "'");
}

/// Splits "mesh.size" at its first dot; `rest` is empty when there is none.
std::pair<std::string_view, std::string_view> first_part(std::string_view path) {
  const auto dot = path.find('.');
  if (dot == std::string_view::npos) return {path, {}};
  return {path.substr(0, dot), path.substr(dot + 1)};
}

}  // namespace

const Settings::Value* Settings::value(std::string_view key) const {
  for (const auto& v : values_) {
    if (v.key == key) return &v;
  }
  const auto dot = key.rfind('.');
  if (dot == std::string_view::npos || !has(key.substr(0, dot))) return nullptr;
  return at(key.substr(0, dot)).value(key.substr(dot + 1));
}

const Settings::Group* Settings::find_group(std::string_view word) const {
  for (const auto& g : groups_) {
    if (g.word == word) return &g;
  }
  return nullptr;
}

Settings::Group& Settings::group(std::string_view word, Kind kind) {
  for (auto& g : groups_) {
    if (g.word == word) return g;
  }
  return groups_.emplace_back(Group{std::string(word), kind, {}});
}

bool Settings::has(std::string_view path) const {
  const auto [word, rest] = first_part(path);
  const Group* g = find_group(word);
  if (rest.empty()) return value(word) != nullptr || (g != nullptr && !g->members.empty());
  if (g == nullptr || g->members.empty()) return false;
  if (g->kind == Kind::single) return g->members.front().has(rest);
  const auto [name, deeper] = first_part(rest);
  const Settings* member = find(word, name);
  return member != nullptr && (deeper.empty() || member->has(deeper));
}

bool Settings::given(std::string_view path) const {
  const auto [word, rest] = first_part(path);
  const Group* g = find_group(word);
  if (!rest.empty()) {
    if (g == nullptr || g->kind != Kind::single || g->members.empty()) return has(path);
    return g->members.front().given(rest);
  }
  if (const Value* v = value(word)) return v->origin != Origin::fallback;
  return g != nullptr && !g->members.empty() && g->members.front().place_.file != "default";
}

template <class T>
const T& Settings::get(std::string_view key, const char* kind) const {
  const Value* v = value(key);
  const T* held = v == nullptr ? nullptr : std::get_if<T>(&v->value);
  if (held == nullptr) misuse(*this, key, kind);
  return *held;
}

bool Settings::flag(std::string_view key) const {
  return get<bool>(key, "flag");
}
std::int64_t Settings::integer(std::string_view key) const {
  return get<std::int64_t>(key, "integer");
}
double Settings::number(std::string_view key) const {
  return get<double>(key, "number");
}
const std::string& Settings::text(std::string_view key) const {
  return get<std::string>(key, "text");
}
const std::vector<double>& Settings::vector(std::string_view key) const {
  return get<std::vector<double>>(key, "vector");
}
const std::vector<std::int64_t>& Settings::integers(std::string_view key) const {
  return get<std::vector<std::int64_t>>(key, "integers");
}
const std::vector<std::string>& Settings::texts(std::string_view key) const {
  return get<std::vector<std::string>>(key, "texts");
}
const Components& Settings::components(std::string_view key) const {
  return get<Components>(key, "components");
}
const Points& Settings::points(std::string_view key) const {
  return get<Points>(key, "points");
}
const Lines& Settings::lines(std::string_view key) const {
  return get<Lines>(key, "lines");
}

std::optional<double> Settings::maybe_number(std::string_view key) const {
  return has(key) ? std::optional<double>(number(key)) : std::nullopt;
}

std::string Settings::text_or(std::string_view key, std::string otherwise) const {
  return has(key) ? text(key) : std::move(otherwise);
}

const Settings& Settings::at(std::string_view path) const {
  const auto [word, rest] = first_part(path);
  const Group* g = find_group(word);
  if (g == nullptr || g->members.empty()) misuse(*this, path, "section");
  if (g->kind == Kind::single)
    return rest.empty() ? g->members.front() : g->members.front().at(rest);
  const auto [name, deeper] = first_part(rest);
  const Settings* member = find(word, name);
  if (member == nullptr) misuse(*this, path, "section");
  return deeper.empty() ? *member : member->at(deeper);
}

const std::vector<Settings>& Settings::children(std::string_view word) const {
  static const std::vector<Settings> nobody;
  const Group* g = find_group(word);
  return g == nullptr ? nobody : g->members;
}

const std::vector<Settings>& Settings::list(std::string_view word) const {
  return children(word);
}

const Settings* Settings::find(std::string_view word, std::string_view name) const {
  for (const auto& member : children(word)) {
    if (member.name_ == name) return &member;
  }
  return nullptr;
}

std::string Settings::place(std::string_view key) const {
  const Value* v = key.empty() ? nullptr : value(key);
  if (v != nullptr && v->origin != Origin::fallback) return v->place.text();
  const Group* inner = key.empty() ? nullptr : find_group(key);
  const bool written = inner != nullptr && inner->kind == Kind::single && given(key);
  return written ? inner->members.front().place() : place_.text();
}

Error Settings::error(std::string_view key, const std::string& cause,
                      const std::string& remedy) const {
  std::string where = path_;
  if (!key.empty()) where += (where.empty() ? "" : ".") + std::string(key);
  return {place(key), where.empty() ? cause : where + ": " + cause, remedy};
}

}  // namespace breccia
