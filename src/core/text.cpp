#include "core/text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

namespace breccia {

std::string number_text(double value) {
  std::array<char, 32> buffer{};
  char* const first = buffer.data();
  char* const last = first + buffer.size();
  const double size = std::abs(value);
  const bool everyday = size >= 1e-4 && size < 1e7;  // 100000, not 1e+05
  const auto end = everyday ? std::to_chars(first, last, value, std::chars_format::fixed)
                            : std::to_chars(first, last, value);
  return {first, end.ptr};
}

std::string join(const std::vector<std::string>& words, std::string_view between) {
  std::string text;
  for (const auto& word : words) {
    if (!text.empty()) text += between;
    text += word;
  }
  return text;
}

std::vector<std::string> split(std::string_view text, char at) {
  std::vector<std::string> parts;
  if (text.empty()) return parts;
  std::size_t begin = 0;
  while (true) {
    const std::size_t end = text.find(at, begin);
    parts.emplace_back(text.substr(begin, end - begin));
    if (end == std::string_view::npos) return parts;
    begin = end + 1;
  }
}

std::string trimmed(std::string_view text) {
  const auto blank = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return std::string(text);
}

int edit_distance(std::string_view a, std::string_view b) {
  // Three rows of the table of optimal string alignment: before-last, last and current.
  const std::size_t n = b.size();
  std::vector<int> before(n + 1), last(n + 1), row(n + 1);
  for (std::size_t j = 0; j <= n; ++j) last[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= n; ++j) {
      const int change = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, change});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
    before.swap(last);
    last.swap(row);
  }
  return last[n];
}

std::string nearest(std::string_view word, const std::vector<std::string>& known) {
  std::string best;
  // A third of the letters may be wrong, but never more than 3: farther words only mislead.
  int limit = std::min(3, static_cast<int>(word.size() + 1) / 3);
  for (const auto& candidate : known) {
    const int distance = edit_distance(word, candidate);
    if (distance < limit || (distance == limit && best.empty())) {
      best = candidate;
      limit = distance;
    }
  }
  if (!best.empty()) return best;
  for (const auto& candidate : known) {  // "tens" for "tensile_strength", "youngs_modulus"
    const std::string_view shorter = std::min(word, std::string_view(candidate));
    const std::string_view longer = std::max(word, std::string_view(candidate));
    if (shorter.size() >= 3 && longer.substr(0, shorter.size()) == shorter) return candidate;
  }
  return best;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
  const std::string near = nearest(word, known);
  return near.empty() ? near : " Did you mean '" + near + "'?";
}

std::string indented(std::string_view text, int blanks) {
  const std::string margin(static_cast<std::size_t>(blanks), ' ');
  std::string moved = margin;
  for (const char c : text) {
    moved += c;
    if (c == '\n') moved += margin;
  }
  return moved;
}

}  // namespace breccia
