#pragma once

#include <string>
#include <vector>

namespace breccia {

/// A table of numbers from a text file.
struct NumberTable {
  std::vector<std::string> columns;  ///< empty where the file has no line of names
  std::vector<std::vector<double>> rows;
};

/// Reads comma-separated numbers: history.csv, or a measured curve. A first line that is not
/// numbers names the columns; lines that begin with # and empty ones are left out.
/// \throws Error with file and line.
NumberTable read_number_table(const std::string& path);

}  // namespace breccia
