#include "io/json.hpp"

#include "io/number.hpp"

#include <cmath>
#include <stdexcept>

namespace breccia {

std::string json_escaped(std::string_view text) {
  constexpr std::string_view hex = "0123456789abcdef";
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (c == '\n') {
      out += "\\n";
    } else if (c == '\t') {
      out += "\\t";
    } else if (code < 0x20) {
      out += "\\u00";
      out += hex[code >> 4];
      out += hex[code & 15u];
    } else {
      out += c;
    }
  }
  return out;
}

void JsonWriter::new_line() {
  text_ += '\n';
  text_.append(2 * open_.size(), ' ');
}

void JsonWriter::before_value() {
  if (after_key_) {
    after_key_ = false;
    return;
  }
  if (open_.empty()) return;
  if (open_.back().bracket == '}') throw std::logic_error("JSON: a value in an object needs a key");
  if (open_.back().items++ > 0) text_ += ',';
  new_line();
}

JsonWriter& JsonWriter::key(std::string_view name) {
  if (open_.empty() || open_.back().bracket != '}') {
    throw std::logic_error("JSON: a key outside an object");
  }
  if (open_.back().items++ > 0) text_ += ',';
  new_line();
  text_ += '"' + json_escaped(name) + "\": ";
  after_key_ = true;
  return *this;
}

JsonWriter& JsonWriter::begin_object() {
  before_value();
  text_ += '{';
  open_.push_back({'}', 0});
  return *this;
}

JsonWriter& JsonWriter::begin_array() {
  before_value();
  text_ += '[';
  open_.push_back({']', 0});
  return *this;
}

void JsonWriter::close(char bracket) {
  if (open_.empty() || open_.back().bracket != bracket || after_key_) {
    throw std::logic_error("JSON: brackets do not match");
  }
  const bool filled = open_.back().items > 0;
  open_.pop_back();
  if (filled) new_line();
  text_ += bracket;
}

JsonWriter& JsonWriter::end_object() {
  close('}');
  return *this;
}

JsonWriter& JsonWriter::end_array() {
  close(']');
  return *this;
}

JsonWriter& JsonWriter::value(std::string_view text) {
  before_value();
  text_ += '"' + json_escaped(text) + '"';
  return *this;
}

JsonWriter& JsonWriter::value(double number) {
  if (!std::isfinite(number)) return null();
  before_value();
  append_number(text_, number);
  return *this;
}

JsonWriter& JsonWriter::value(std::int64_t number) {
  before_value();
  append_number(text_, number);
  return *this;
}

JsonWriter& JsonWriter::value(bool flag) {
  before_value();
  text_ += flag ? "true" : "false";
  return *this;
}

JsonWriter& JsonWriter::null() {
  before_value();
  text_ += "null";
  return *this;
}

std::string JsonWriter::text() const {
  if (!open_.empty() || after_key_) throw std::logic_error("JSON: something is still open");
  return text_ + '\n';
}

}  // namespace breccia
