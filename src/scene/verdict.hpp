#pragma once
#include "core/settings.hpp"
#include "io/report.hpp"

#include <string>
#include <vector>

namespace breccia {

/// What the formulas of [[check]] may speak of: history columns as series, results as numbers.
struct Results {
  std::vector<std::string> columns;  ///< of the history; the first is time
  std::vector<std::vector<double>> rows;
  std::vector<std::pair<std::string, double>> numbers;  ///< "fragments", "crack.angle", ...
};

/// Evaluates every [[check]]. A formula that cannot be evaluated fails its check with a note;
/// the syntax was checked when the scene was read.
std::vector<Report::Check> judge(const Settings& scene, const Results& results);

}  // namespace breccia
