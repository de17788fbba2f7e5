#include "batch/summary.hpp"

#include "core/error.hpp"
#include "core/unit.hpp"
#include "io/json_reader.hpp"
#include "jobs/rows.hpp"
#include "jobs/run_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace breccia {

namespace {

using Stage = VariantState::Stage;
constexpr std::size_t kLongTable = 60;

double value_of(const std::string& formula, const Quantities& quantities) {
  try {
    return Expression(formula).evaluate(quantities);
  } catch (const Error&) {
    return VariantResult::kNone;  // an arrival that never came
  }
}

VariantResult read_one(const Sweep& sweep, std::size_t variant) {
  const std::filesystem::path folder = sweep.folder(variant);
  const Json report = read_json((folder / "report.json").string());
  VariantResult result;
  result.steps = report["steps"].number();
  result.wall = report["wall_seconds"].number();
  for (const Json& check : report["checks"].array())
    result.checks.push_back({check["name"].text(), check["value"].number(), check["pass"].flag()});
  if (sweep.collect.empty()) return result;
  const Results told = read_results(folder);
  const Quantities quantities = quantities_of(told);
  for (const Collected& c : sweep.collect)
    result.collected.push_back(value_of(c.formula, quantities));
  return result;
}

/// The checks of the scene, as the first complete variant has them.
std::vector<VariantResult::Check> checks_of(const std::vector<VariantResult>& results) {
  for (const VariantResult& r : results)
    if (!r.checks.empty()) return r.checks;
  return {};
}

/// A column of values in SI where all are quantities of one kind, else as they were written.
struct Column {
  std::string title;
  std::vector<std::string> cells;  ///< of each step
};

Column column_of(const Varied& varied) {
  Column column{varied.name, {}};
  std::optional<Dimension> dimension;
  try {
    for (const std::string& value : varied.values) {
      const Quantity q = parse_quantity(value);
      if (dimension && *dimension != q.dimension) throw Error("", "not of one kind");
      dimension = q.dimension;
      column.cells.push_back(csv_cell(q.value));
    }
    if (dimension && *dimension != unit::none) column.title += " [" + si_unit(*dimension) + "]";
  } catch (const Error&) {
    column.cells.clear();
    for (const std::string& value : varied.values) column.cells.push_back(csv_cell(value));
  }
  column.title = csv_cell(column.title);
  return column;
}

TableRow row_of(const Sweep& sweep, const Variant& variant, const VariantState& state,
                const VariantResult& result) {
  TableRow row{variant.folder};
  for (const Varied& varied : sweep.varied)
    row.push_back(varied.words[sweep.step(variant, varied.axis)]);
  const bool complete = state.stage == Stage::complete;
  const auto number = [&](const char* form, double value) {
    return complete && std::isfinite(value) ? fmt::format(fmt::runtime(form), value) : "-";
  };
  row.push_back(number("{:.0f}", result.steps));
  row.push_back(number("{:.3g}", result.wall));
  for (std::size_t c = 0; c < sweep.collect.size(); ++c)
    row.push_back(complete ? number("{:.6g}", result.collected[c]) : "-");
  row.push_back(
      result.checks.empty() ? "-" : fmt::format("{} of {}", result.passed(), result.checks.size()));
  row.push_back(complete ? "" : stage_text(state.stage));
  return row;
}

bool noteworthy(const VariantState& state, const VariantResult& result) {
  return state.stage != Stage::complete || result.passed() < static_cast<int>(result.checks.size());
}

TableRow statistics(const std::string& name, const std::vector<double>& all) {
  std::vector<double> values;
  std::copy_if(all.begin(), all.end(), std::back_inserter(values),
               [](double v) { return std::isfinite(v); });
  if (values.size() < 2) return {};
  const auto n = static_cast<double>(values.size());
  double mean = 0, square = 0;
  for (const double v : values) mean += v / n;
  for (const double v : values) square += (v - mean) * (v - mean) / (n - 1);
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return {name,
          std::to_string(values.size()),
          fmt::format("{:.6g}", *least),
          fmt::format("{:.6g}", mean),
          fmt::format("{:.6g}", *most),
          fmt::format("{:.3g}", std::sqrt(square)),
          ""};
}

void print_statistics(const Sweep& sweep, const std::vector<VariantResult>& results,
                      std::ostream& out) {
  std::vector<TableRow> rows;
  const auto add = [&rows](const std::string& name, const std::vector<double>& values) {
    TableRow row = statistics(name, values);
    if (!row.empty()) rows.push_back(std::move(row));
  };
  std::vector<double> values;
  for (std::size_t c = 0; c < sweep.collect.size(); ++c) {
    values.clear();
    for (const VariantResult& r : results)
      if (c < r.collected.size()) values.push_back(r.collected[c]);
    add(sweep.collect[c].name, values);
  }
  const auto checks = checks_of(results);
  for (std::size_t c = 0; c < checks.size(); ++c) {
    values.clear();
    for (const VariantResult& r : results)
      if (c < r.checks.size()) values.push_back(r.checks[c].value);
    add(checks[c].name, values);
  }
  if (rows.empty()) return;
  rows.insert(rows.begin(),
              {"over all variants", "values", "least", "mean", "largest", "std deviation", ""});
  out << "\n";
  print_rows(rows, out);
}

}  // namespace

int VariantResult::passed() const {
  return static_cast<int>(
      std::count_if(checks.begin(), checks.end(), [](const Check& check) { return check.pass; }));
}

std::vector<VariantResult> read_variants(const Sweep& sweep,
                                         const std::vector<VariantState>& states) {
  std::vector<VariantResult> results(states.size());
  for (std::size_t v = 0; v < states.size(); ++v)
    if (states[v].stage == Stage::complete) results[v] = read_one(sweep, v);
  return results;
}

void check_collected(const Sweep& sweep, std::size_t variant) {
  std::vector<std::string> formulas;
  for (const Collected& c : sweep.collect) formulas.push_back(c.formula);
  if (formulas.empty()) return;
  try {
    check_names(formulas, sweep.folder(variant));
  } catch (const Error& e) {
    throw Error(sweep.collect_place, "batch.collect: " + e.cause(), e.remedy());
  }
}

std::string summary_csv(const Sweep& sweep, const std::vector<VariantState>& states,
                        const std::vector<VariantResult>& results) {
  std::vector<Column> columns;
  std::string text = "variant";
  for (const Varied& varied : sweep.varied) {
    columns.push_back(column_of(varied));
    text += "," + columns.back().title;
  }
  text += ",status,attempts,steps,wall_seconds";
  for (const Collected& c : sweep.collect) text += "," + csv_cell(c.name);
  const auto checks = checks_of(results);
  for (const auto& check : checks)
    text += "," + csv_cell(check.name) + "," + csv_cell(check.name + ": pass");
  text += ",reason\n";
  for (const Variant& variant : sweep.variants) {
    const VariantState& state = states[variant.number];
    const VariantResult& r = results[variant.number];
    text += variant.folder;
    for (std::size_t k = 0; k < columns.size(); ++k)
      text += "," + columns[k].cells[sweep.step(variant, sweep.varied[k].axis)];
    text += "," + stage_text(state.stage) + "," + std::to_string(state.attempts);
    text += "," + csv_cell(r.steps) + "," + csv_cell(r.wall);
    for (std::size_t c = 0; c < sweep.collect.size(); ++c)
      text += "," + (c < r.collected.size() ? csv_cell(r.collected[c]) : "");
    for (std::size_t c = 0; c < checks.size(); ++c)
      text += c < r.checks.size()
                  ? "," + csv_cell(r.checks[c].value) + "," + (r.checks[c].pass ? "1" : "0")
                  : ",,";
    text += "," + csv_cell(state.reason) + "\n";
  }
  return text;
}

void print_summary(const Sweep& sweep, const std::vector<VariantState>& states,
                   const std::vector<VariantResult>& results, std::ostream& out) {
  TableRow head{"variant"};
  for (const Varied& varied : sweep.varied) head.push_back(varied.name);
  for (const char* word : {"steps", "wall [s]"}) head.emplace_back(word);
  for (const Collected& c : sweep.collect) head.push_back(c.name);
  for (const char* word : {"checks", ""}) head.emplace_back(word);
  std::vector<TableRow> rows{head};
  const bool all = states.size() <= kLongTable;
  for (const Variant& variant : sweep.variants) {
    const std::size_t v = variant.number;
    if (all || noteworthy(states[v], results[v]))
      rows.push_back(row_of(sweep, variant, states[v], results[v]));
  }
  out << "\n";
  if (!all)
    out << "  " << states.size() << " variants; those that are not complete, or fail a check:\n";
  if (all || rows.size() > 1) print_rows(rows, out);
  print_statistics(sweep, results, out);
}

}  // namespace breccia
