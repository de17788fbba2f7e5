#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace breccia {

/// Shortest decimal text that reads back as the same double ("0.02", "6e+10").
std::string number_text(double value);

/// "a, b, c".
std::string join(const std::vector<std::string>& words, std::string_view between = ", ");

/// Parts of `text` between the characters `at`; an empty text has no parts.
std::vector<std::string> split(std::string_view text, char at);

/// Text without blanks at both ends.
std::string trimmed(std::string_view text);

/// Letters inserted, removed, changed or swapped with a neighbour between two words.
int edit_distance(std::string_view a, std::string_view b);

/// The word of `known` that `word` was probably meant to be; empty when none is near.
std::string nearest(std::string_view word, const std::vector<std::string>& known);

/// " Did you mean 'x'?" for the nearest word, or nothing.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& known);

/// Every line of `text` moved right by `blanks`.
std::string indented(std::string_view text, int blanks);

}  // namespace breccia
