#include "core/config.hpp"

#include "core/error.hpp"
#include "core/text.hpp"

#include <charconv>

namespace breccia {

namespace {

std::vector<std::string> element_names(const Config::Array& list) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Config* name = list[i].find("name");
    const bool named = name != nullptr && name->is(Config::Kind::text);
    names.push_back(named ? name->text() : std::to_string(i));
  }
  return names;
}

Config& list_element(Config::Array& list, const std::string& word, const std::string& path) {
  std::size_t index = 0;
  const auto read = std::from_chars(word.data(), word.data() + word.size(), index);
  const bool number = read.ec == std::errc() && read.ptr == word.data() + word.size();
  if (number && index < list.size()) return list[index];
  const auto names = element_names(list);
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (names[i] == word) return list[i];
  }
  throw Error(
      "--set", path + ": the list has no element '" + word + "'." + did_you_mean(word, names),
      list.empty()
          ? "the list is empty"
          : "elements: " + join(names) + " (or 0 to " + std::to_string(list.size() - 1) + ")");
}

}  // namespace

std::vector<std::string> key_path(std::string_view path) {
  std::vector<std::string> parts(1);
  char quote = 0;
  for (const char c : path) {
    if (quote != 0) {
      if (c == quote) {
        quote = 0;
      } else {
        parts.back() += c;
      }
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '.') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  for (auto& part : parts) {
    part = trimmed(part);
    if (part.empty() || quote != 0) {
      throw Error("--set", "'" + std::string(path) + "' is not a path of keys",
                  "write section.key=value, for example run.duration=2ms");
    }
  }
  return parts;
}

const Config* Config::find(std::string_view key) const {
  if (!is(Kind::table)) return nullptr;
  for (const auto& entry : table()) {
    if (entry.first == key) return &entry.second;
  }
  return nullptr;
}

Config* Config::find(std::string_view key) {
  return const_cast<Config*>(static_cast<const Config*>(this)->find(key));
}

void Config::set(std::string_view path, Config value) {
  const auto parts = key_path(path);
  Config* here = this;
  std::string walked;
  for (const auto& part : parts) {
    walked += (walked.empty() ? "" : ".") + part;
    if (here->is(Kind::array)) {
      here = &list_element(here->array(), part, walked);
    } else if (here->is(Kind::table)) {
      Config* next = here->find(part);
      if (next == nullptr) {
        here->table().emplace_back(part, Config(Table{}, value.place()));
        next = &here->table().back().second;
      }
      here = next;
    } else {
      throw Error("--set", walked + ": there is " + here->describe() + " above it, not a section");
    }
  }
  *here = std::move(value);
}

std::string Config::describe() const {
  switch (kind()) {
    case Kind::boolean:
      return boolean() ? "the flag true" : "the flag false";
    case Kind::integer:
      return "the number " + std::to_string(integer());
    case Kind::real:
      return "the number " + number_text(real());
    case Kind::text:
      return "the text \"" + text() + "\"";
    case Kind::array:
      return array().empty() ? "an empty list" : "a list";
    case Kind::table:
      return "a table";
  }
  throw std::logic_error("a Config of no kind");
}

std::string Config::written() const {
  switch (kind()) {
    case Kind::boolean:
      return boolean() ? "true" : "false";
    case Kind::integer:
      return std::to_string(integer());
    case Kind::real:
      return number_text(real());
    case Kind::text:
      return "\"" + text() + "\"";
    default:
      break;
  }
  std::vector<std::string> parts;
  if (is(Kind::array)) {
    for (const auto& element : array()) parts.push_back(element.written());
    return "[" + join(parts) + "]";
  }
  for (const auto& [name, value] : table()) parts.push_back(name + " = " + value.written());
  return "{ " + join(parts) + " }";
}

}  // namespace breccia
