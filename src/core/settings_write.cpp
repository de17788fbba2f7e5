// The resolved scene as TOML.
#include "core/settings.hpp"
#include "core/text.hpp"

#include <cctype>
#include <ostream>
#include <string_view>

namespace breccia {

namespace {

std::string quoted(const std::string& text) {
  constexpr std::string_view hex = "0123456789ABCDEF";
  std::string out = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (code < 0x20 || code == 0x7F) {  // TOML has no bare control characters
      out += "\\u00";
      out += hex[code / 16];
      out += hex[code % 16];
    } else {
      out += c;
    }
  }
  return out + '"';
}

std::string bare_or_quoted(const std::string& key) {
  bool bare = !key.empty();
  for (const char c : key) {
    bare = bare && (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-');
  }
  return bare ? key : quoted(key);
}

/// A TOML float needs a point or an exponent.
std::string toml(double x) {
  const std::string text = number_text(x);
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}
std::string toml(bool x) {
  return x ? "true" : "false";
}
std::string toml(std::int64_t x) {
  return std::to_string(x);
}
std::string toml(const std::string& x) {
  return quoted(x);
}
std::string toml(const std::optional<double>& x) {
  return x ? toml(*x) : "\"free\"";
}

template <class T>
std::string toml(const std::vector<T>& list) {
  std::vector<std::string> parts;
  for (const auto& element : list) parts.push_back(toml(element));
  return "[" + join(parts) + "]";
}

std::string remark(const Settings::Value& v) {
  std::vector<std::string> words;
  if (v.dimension != unit::none) words.push_back(si_unit(v.dimension));
  if (!v.written.empty()) words.push_back("written " + v.written);
  if (v.origin == Settings::Origin::option) words.emplace_back("--set");
  if (v.origin == Settings::Origin::fallback) words.emplace_back("default");
  std::string text = words.empty() ? std::string() : "  # " + join(words);
  for (char& c : text) {
    if (std::iscntrl(static_cast<unsigned char>(c)) != 0) c = ' ';  // a remark is one line
  }
  return text;
}

void write_values(const Settings& section, std::ostream& out) {
  for (const auto& v : section.values()) {
    const std::string text = std::visit([](const auto& x) { return toml(x); }, v.value);
    out << bare_or_quoted(v.key) << " = " << text << remark(v) << "\n";
  }
}

void write_section(const Settings& section, const std::string& header, std::ostream& out);

void write_groups(const Settings& section, const std::string& path, std::ostream& out) {
  for (const auto& group : section.groups()) {
    const std::string inner = (path.empty() ? "" : path + ".") + bare_or_quoted(group.word);
    for (const auto& member : group.members) {
      out << "\n";
      if (group.kind == Settings::Kind::list) {
        out << "[[" << inner << "]]\n";
        write_section(member, inner, out);
      } else {
        const bool named = group.kind == Settings::Kind::named;
        const std::string header = named ? inner + "." + bare_or_quoted(member.name()) : inner;
        out << "[" << header << "]\n";
        write_section(member, header, out);
      }
    }
  }
}

void write_section(const Settings& section, const std::string& header, std::ostream& out) {
  write_values(section, out);
  write_groups(section, header, out);
}

}  // namespace

void Settings::write_resolved(std::ostream& out) const {
  out << "# The resolved scene: every key with the value used, in SI units (m, kg, s, K, rad).\n";
  write_section(*this, "", out);
}

}  // namespace breccia
