#include "io/number_table.hpp"

#include "core/error.hpp"
#include "core/text.hpp"

#include <charconv>
#include <fstream>
#include <optional>

namespace breccia {

namespace {

std::optional<double> number_of(const std::string& text) {
  const char* begin = text.data();
  const char* end = begin + text.size();
  if (begin != end && *begin == '+') ++begin;
  double value = 0;
  const auto read = std::from_chars(begin, end, value);
  if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
  return value;
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells = split(line, ',');
  for (std::string& cell : cells) cell = trimmed(cell);
  return cells;
}

std::vector<double> numbers_of(const std::vector<std::string>& cells, const std::string& place) {
  std::vector<double> row;
  for (const std::string& cell : cells) {
    const auto value = number_of(cell);
    if (!value)
      throw Error(place, "'" + cell + "' is not a number", "numbers in SI, without units");
    row.push_back(*value);
  }
  return row;
}

}  // namespace

NumberTable read_number_table(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw Error(path, "the table cannot be read", "check that the file is there");
  NumberTable table;
  int line = 0;
  for (std::string text; std::getline(file, text);) {
    ++line;
    if (trimmed(text).empty() || trimmed(text).front() == '#') continue;
    const std::vector<std::string> cells = cells_of(text);
    if (table.rows.empty() && table.columns.empty() && !number_of(cells.front())) {
      table.columns = cells;
      continue;
    }
    const std::string place = path + ":" + std::to_string(line);
    table.rows.push_back(numbers_of(cells, place));
    if (table.rows.back().size() != table.rows.front().size())
      throw Error(place, "the row has " + std::to_string(cells.size()) +
                             " numbers, the first has " +
                             std::to_string(table.rows.front().size()));
  }
  if (table.rows.empty()) throw Error(path, "the table has no rows");
  return table;
}

}  // namespace breccia
