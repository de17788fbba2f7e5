#pragma once

#include "batch/state.hpp"

#include <iosfwd>
#include <limits>

namespace breccia {

/// What a complete variant has told.
struct VariantResult {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  struct Check {
    std::string name;
    double value = kNone;
    bool pass = false;
  };
  double steps = kNone, wall = kNone;
  std::vector<Check> checks;
  std::vector<double> collected;  ///< not-a-number where a formula has no value
  [[nodiscard]] int passed() const;
};

/// Results of all variants; those that are not complete have none.
std::vector<VariantResult> read_variants(const Sweep& sweep,
                                         const std::vector<VariantState>& states);

/// Refuses a collected quantity that speaks of what a complete variant does not have.
/// \throws Error at the line of the sweep.
void check_collected(const Sweep& sweep, std::size_t variant);

/// summary.csv: one row per variant.
std::string summary_csv(const Sweep& sweep, const std::vector<VariantState>& states,
                        const std::vector<VariantResult>& results);

/// The same for people, with means and spreads; of many variants those that are not as they should
/// be.
void print_summary(const Sweep& sweep, const std::vector<VariantState>& states,
                   const std::vector<VariantResult>& results, std::ostream& out);

}  // namespace breccia
