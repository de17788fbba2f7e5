#pragma once
#include "core/expression.hpp"
#include "core/settings.hpp"
#include "io/report.hpp"
#include "scene/main_crack.hpp"

#include <string>
#include <vector>

namespace breccia {

using Numbers = std::vector<std::pair<std::string, double>>;

/// What the formulas of [[check]] may speak of: history columns as series, results as numbers.
struct Results {
  std::vector<std::string> columns;  ///< of the history; the first is time
  std::vector<std::vector<double>> rows;
  Numbers numbers;  ///< "fragments", "crack.angle", ...
};

/// Results as the names of a formula. The results must live as long.
Quantities quantities_of(const Results& results);

/// Results of a run that are one number each.
Numbers result_numbers(const Report& report, const MainCrack& crack);

/// Refuses the [[check]]s that speak of what this scene has no column, number or norm for, or that
/// allow a share of zero.
/// \throws Error with the lines of all of them.
void check_checks(const Settings& scene, const std::vector<std::string>& columns,
                  const Numbers& norms);

/// Evaluates every [[check]]. A formula without a value fails its check with a note.
std::vector<Report::Check> judge(const Settings& scene, const Results& results);

}  // namespace breccia
