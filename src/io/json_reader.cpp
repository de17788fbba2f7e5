#include "io/json_reader.hpp"

#include "core/error.hpp"

#include <charconv>
#include <fstream>
#include <limits>
#include <sstream>

namespace breccia {

namespace {

constexpr int kDeepest = 100;

class Parser {
 public:
  Parser(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  Json whole() {
    Json value = any(0);
    blanks();
    if (at_ != text_.size()) fail("something follows the end");
    return value;
  }

 private:
  [[noreturn]] void fail(const std::string& cause) const {
    throw Error(name_,
                "this is not JSON: " + cause + " (character " + std::to_string(at_ + 1) + ")");
  }

  void blanks() {
    while (at_ < text_.size() && std::string_view(" \t\r\n").find(text_[at_]) != text_.npos) ++at_;
  }
  char next() {
    blanks();
    if (at_ == text_.size()) fail("it ends too early");
    return text_[at_];
  }
  bool take(char wanted) {
    if (next() != wanted) return false;
    ++at_;
    return true;
  }
  void demand(char wanted) {
    if (!take(wanted)) fail(std::string("'") + wanted + "' is missing");
  }
  bool word(std::string_view wanted) {
    if (text_.substr(at_, wanted.size()) != wanted) return false;
    at_ += wanted.size();
    return true;
  }

  Json any(int depth) {
    if (depth > kDeepest) fail("it is nested too deeply");
    switch (next()) {
      case '{':
        return object(depth);
      case '[':
        return array(depth);
      case '"':
        return Json(string());
      default:
        break;
    }
    if (word("true")) return Json(true);
    if (word("false")) return Json(false);
    if (word("null")) return {};
    double value = 0;
    const auto read = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (read.ec != std::errc()) fail("a value is missing");
    at_ = static_cast<std::size_t>(read.ptr - text_.data());
    return Json(value);
  }

  Json object(int depth) {
    Json::Object members;
    demand('{');
    if (take('}')) return Json(std::move(members));
    do {
      if (next() != '"') fail("a name is missing");
      std::string name = string();
      demand(':');
      members.insert_or_assign(std::move(name), any(depth + 1));
    } while (take(','));
    demand('}');
    return Json(std::move(members));
  }

  Json array(int depth) {
    Json::Array elements;
    demand('[');
    if (take(']')) return Json(std::move(elements));
    do {
      elements.push_back(any(depth + 1));
    } while (take(','));
    demand(']');
    return Json(std::move(elements));
  }

  std::string string() {
    std::string text;
    demand('"');
    while (true) {
      if (at_ == text_.size()) fail("a text is not closed");
      const char c = text_[at_++];
      if (c == '"') return text;
      if (c == '\\') {
        escape(text);
      } else {
        text += c;
      }
    }
  }

  void escape(std::string& text) {
    constexpr std::string_view from = "\"\\/bfnrt", to = "\"\\/\b\f\n\r\t";
    const char c = at_ < text_.size() ? text_[at_++] : '\0';
    if (const auto found = from.find(c); found != from.npos) {
      text += to[found];
      return;
    }
    unsigned code = 0;
    const char* begin = text_.data() + at_;
    const bool whole = c == 'u' && text_.size() - at_ >= 4;
    if (!whole || std::from_chars(begin, begin + 4, code, 16).ptr != begin + 4)
      fail("an escape is unknown");
    at_ += 4;
    put_utf8(text, code);
  }

  /// JsonWriter escapes control characters alone, so that pairs of surrogates do not occur.
  static void put_utf8(std::string& text, unsigned code) {
    if (code < 0x80) {
      text += static_cast<char>(code);
    } else if (code < 0x800) {
      text += static_cast<char>(0xC0 | (code >> 6));
      text += static_cast<char>(0x80 | (code & 0x3F));
    } else {
      text += static_cast<char>(0xE0 | (code >> 12));
      text += static_cast<char>(0x80 | ((code >> 6) & 0x3F));
      text += static_cast<char>(0x80 | (code & 0x3F));
    }
  }

  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0;
};

}  // namespace

Json::Json() : value_(std::numeric_limits<double>::quiet_NaN()) {}

const Json& Json::operator[](std::string_view name) const {
  static const Json nothing;
  const auto* members = std::get_if<Object>(&value_);
  if (members == nullptr) return nothing;
  const auto found = members->find(name);
  return found == members->end() ? nothing : found->second;
}

const Json::Array& Json::array() const {
  static const Array nothing;
  const auto* held = std::get_if<Array>(&value_);
  return held == nullptr ? nothing : *held;
}

const Json::Object& Json::object() const {
  static const Object nothing;
  const auto* held = std::get_if<Object>(&value_);
  return held == nullptr ? nothing : *held;
}

double Json::number() const {
  const auto* held = std::get_if<double>(&value_);
  return held == nullptr ? std::numeric_limits<double>::quiet_NaN() : *held;
}

std::string Json::text() const {
  const auto* held = std::get_if<std::string>(&value_);
  return held == nullptr ? std::string() : *held;
}

bool Json::flag() const {
  const auto* held = std::get_if<bool>(&value_);
  return held != nullptr && *held;
}

Json parse_json(std::string_view text, const std::string& name) {
  return Parser(text, name).whole();
}

Json read_json(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (file) text << file.rdbuf();
  if (!file) throw Error(path, "the file cannot be read");
  return parse_json(text.str(), path);
}

}  // namespace breccia
