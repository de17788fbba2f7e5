#pragma once

#include <string>
#include <string_view>

namespace breccia {

/// Reads words and numbers off a text file held in memory and knows the line it is at.
class TextScanner {
 public:
  /// Throws Error when the file cannot be read.
  explicit TextScanner(const std::string& path);

  const std::string& path() const { return path_; }
  bool at_end();
  /// Bytes still to read: no honest count is larger.
  long long remaining() const { return static_cast<long long>(text_.size() - at_); }
  /// Next word; a word in double quotes is returned without them. Throws Error at the end of the
  /// file.
  std::string_view word();
  long long integer();
  /// An integer from `low` to `high`; `what` names it in the error.
  long long integer(long long low, long long high, const std::string& what);
  double number();
  /// Moves behind the next line that starts with `mark`. Throws Error when there is none.
  void skip_past(std::string_view mark);
  /// Throws Error at the line of the last word read.
  [[noreturn]] void fail(const std::string& cause) const;

 private:
  void skip_blanks();

  std::string path_, text_;
  std::size_t at_ = 0;
  long line_ = 1;
};

}  // namespace breccia
