#include "jobs/run_results.hpp"

#include "core/error.hpp"
#include "core/text.hpp"
#include "io/json_reader.hpp"
#include "io/number_table.hpp"

#include <algorithm>

namespace breccia {

Results read_results(const std::filesystem::path& folder) {
  NumberTable history = read_number_table((folder / "history.csv").string());
  Results results;
  results.columns = std::move(history.columns);
  results.rows = std::move(history.rows);
  const Json report = read_json((folder / "report.json").string());
  for (const auto& [name, number] : report["numbers"].object())
    results.numbers.emplace_back(name, number.number());
  return results;
}

void check_names(const std::vector<std::string>& formulas, const std::filesystem::path& folder) {
  const Results results = read_results(folder);
  const std::vector<std::string> known = quantities_of(results).names;
  for (const std::string& formula : formulas) {
    for (const std::string& name : Expression(formula).names()) {
      if (std::find(known.begin(), known.end(), name) != known.end()) continue;
      throw Error("", "this run has no '" + name + "'." + did_you_mean(name, known),
                  "docs/output.md lists columns and results; sensors add theirs");
    }
  }
}

}  // namespace breccia
