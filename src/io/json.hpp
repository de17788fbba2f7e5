#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace breccia {

/// Writes JSON in the order of the calls, indented by two spaces. Numbers read back exactly;
/// not-a-number and infinities become null, because JSON has no word for them. Nesting is checked
/// when the text is taken.
class JsonWriter {
 public:
  JsonWriter& begin_object();
  JsonWriter& end_object();
  JsonWriter& begin_array();
  JsonWriter& end_array();
  JsonWriter& key(std::string_view name);
  JsonWriter& value(std::string_view text);
  JsonWriter& value(const char* text) { return value(std::string_view(text)); }
  JsonWriter& value(double number);
  JsonWriter& value(std::int64_t number);
  JsonWriter& value(int number) { return value(static_cast<std::int64_t>(number)); }
  JsonWriter& value(bool flag);
  JsonWriter& null();

  template <class T>
  JsonWriter& member(std::string_view name, const T& content) {
    return key(name).value(content);
  }

  /// The whole text, ending in a newline. Throws std::logic_error while something is still open.
  std::string text() const;

 private:
  void before_value();
  void close(char bracket);
  void new_line();

  struct Level {
    char bracket;
    std::size_t items;
  };
  std::string text_;
  std::vector<Level> open_;
  bool after_key_ = false;
};

/// Text between quotation marks as JSON wants it: quotes, backslashes and control characters
/// escaped.
std::string json_escaped(std::string_view text);

}  // namespace breccia
