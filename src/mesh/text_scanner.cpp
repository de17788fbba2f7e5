#include "mesh/text_scanner.hpp"

#include "mesh/refusal.hpp"

#include <charconv>
#include <fstream>
#include <sstream>

namespace breccia {

TextScanner::TextScanner(const std::string& path) : path_(path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (file) text << file.rdbuf();
  if (!file || file.bad()) {
    refuse(path, "the file cannot be read", "check its name and that you may read it");
  }
  text_ = std::move(text).str();
}

void TextScanner::skip_blanks() {
  while (at_ < text_.size() && static_cast<unsigned char>(text_[at_]) <= ' ') {
    if (text_[at_] == '\n') ++line_;
    ++at_;
  }
}

bool TextScanner::at_end() {
  skip_blanks();
  return at_ == text_.size();
}

std::string_view TextScanner::word() {
  if (at_end()) fail("the file ends too early");
  std::size_t begin = at_;
  if (text_[at_] == '"') {
    const std::size_t close = text_.find('"', at_ + 1);
    if (close == std::string::npos) fail("a quotation mark is not closed");
    ++begin;
    at_ = close + 1;
    return std::string_view(text_).substr(begin, close - begin);
  }
  while (at_ < text_.size() && static_cast<unsigned char>(text_[at_]) > ' ') ++at_;
  return std::string_view(text_).substr(begin, at_ - begin);
}

long long TextScanner::integer() {
  const std::string_view text = word();
  long long value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) {
    fail("\"" + std::string(text) + "\" is not a whole number");
  }
  return value;
}

long long TextScanner::integer(long long low, long long high, const std::string& what) {
  const long long value = integer();
  if (value < low || value > high) fail(what + " " + std::to_string(value) + " is out of range");
  return value;
}

double TextScanner::number() {
  const std::string_view text = word();
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) {
    fail("\"" + std::string(text) + "\" is not a number");
  }
  return value;
}

void TextScanner::skip_past(std::string_view mark) {
  while (word() != mark) {
  }
}

void TextScanner::fail(const std::string& cause) const {
  refuse(path_ + ":" + std::to_string(line_), cause,
         "write the mesh anew; the file is damaged or was cut off");
}

}  // namespace breccia
