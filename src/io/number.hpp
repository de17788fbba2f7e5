#pragma once

#include <cstdint>
#include <string>

namespace breccia {

/// Appends the shortest decimal text that reads back as the same double; whole numbers below 1e15
/// without exponent. Not-a-number and infinities become nan, inf, -inf.
void append_number(std::string& text, double value);
void append_number(std::string& text, std::int64_t value);

}  // namespace breccia
