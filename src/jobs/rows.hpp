#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace breccia {

/// A cell of a CSV file; texts are quoted where they must be, a number that is none is empty.
std::string csv_cell(const std::string& text);
std::string csv_cell(double number);

using TableRow = std::vector<std::string>;

/// Rows for people: the first and the last column to the left, all others to the right.
void print_rows(const std::vector<TableRow>& rows, std::ostream& out);

}  // namespace breccia
