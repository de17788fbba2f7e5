#include "io/number.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace breccia {

void append_number(std::string& text, std::int64_t value) {
  std::array<char, 24> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  text.append(buffer.data(), end.ptr);
}

void append_number(std::string& text, double value) {
  const bool whole = std::abs(value) < 1e15 && value == std::floor(value);
  if (whole && !(value == 0 && std::signbit(value))) {
    append_number(text, static_cast<std::int64_t>(value));
    return;
  }
  if (std::isnan(value)) {  // the sign of a NaN carries nothing and differs between machines
    text += "nan";
    return;
  }
  std::array<char, 40> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  text.append(buffer.data(), end.ptr);
}

}  // namespace breccia
