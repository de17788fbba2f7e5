#include "scene/verdict.hpp"

#include "core/expression.hpp"
#include "core/text.hpp"

#include <algorithm>
#include <cmath>

namespace breccia {

namespace {

/// "10 %" is a share of the reference, anything else is in the unit of the value.
bool is_share(const std::string& tolerance) {
  const std::string text = trimmed(tolerance);
  return !text.empty() && text.back() == '%';
}

Report::Check judge_one(const Settings& section, const Quantities& quantities) {
  Report::Check check;
  check.name = section.text("name");
  const std::string& tolerance = section.text("tolerance");
  check.relative = is_share(tolerance);
  try {
    check.reference = Expression(section.text("reference")).evaluate(quantities);
    check.tolerance = Expression(tolerance).evaluate(quantities);
    check.value = Expression(section.text("value")).evaluate(quantities);
  } catch (const Error& error) {
    check.note = error.what();
    return check;
  }
  const double allowed = check.tolerance * (check.relative ? std::abs(check.reference) : 1.0);
  check.pass = std::abs(check.value - check.reference) <= allowed;
  return check;
}

void check_names(const Settings& check, const char* key, const std::vector<std::string>& known,
                 Problems& problems) {
  for (const std::string& name : Expression(check.text(key)).names()) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    problems.add(check.error(key, "this run has no '" + name + "'." + did_you_mean(name, known),
                             "docs/output.md lists columns and results; sensors add theirs"));
  }
}

void check_share(const Settings& check, Problems& problems) {
  const Expression reference(check.text("reference"));
  if (!is_share(check.text("tolerance")) || !reference.names().empty()) return;
  if (reference.evaluate({}) == 0)
    problems.add(check.error("tolerance", "a share of a reference of 0 allows nothing",
                             "give the tolerance in the unit of the value"));
}

}  // namespace

Quantities quantities_of(const Results& results) {
  Quantities q;
  for (const auto& row : results.rows) q.time.push_back(row.front());
  q.names = results.columns;
  for (const auto& [name, value] : results.numbers) q.names.push_back(name);
  q.find = [&results](const std::string& name) -> std::optional<ExpressionValue> {
    for (const auto& [known, value] : results.numbers)
      if (known == name) return ExpressionValue(value);
    const auto column = std::find(results.columns.begin(), results.columns.end(), name);
    if (column == results.columns.end()) return std::nullopt;
    const auto at = static_cast<std::size_t>(column - results.columns.begin());
    std::vector<double> series;
    for (const auto& row : results.rows) series.push_back(row[at]);
    return ExpressionValue(std::move(series));
  };
  return q;
}

Numbers result_numbers(const Report& report, const MainCrack& crack) {
  return {{"steps", static_cast<double>(report.steps)},
          {"elements", static_cast<double>(report.elements)},
          {"nodes", static_cast<double>(report.nodes)},
          {"fragments", static_cast<double>(report.fragments)},
          {"interfaces.bonded", static_cast<double>(report.interfaces.bonded)},
          {"interfaces.inserted", static_cast<double>(report.interfaces.inserted)},
          {"interfaces.released", static_cast<double>(report.interfaces.released)},
          {"crack.length", crack.length},
          {"crack.area", crack.area},
          {"crack.angle", crack.angle},
          {"crack.x", crack.centre[0]},
          {"crack.y", crack.centre[1]},
          {"crack.z", crack.centre[2]},
          {"crack.start", crack.start},
          {"crack.speed", crack.speed},
          {"rest.reached", report.rest.reached ? 1.0 : 0.0},
          {"rest.time", report.rest.time},
          {"rest.unbalance", report.rest.unbalance},
          {"res_1", report.res_1},
          {"res_2", report.res_2}};
}

void check_checks(const Settings& scene, const std::vector<std::string>& columns,
                  const Numbers& norms) {
  std::vector<std::string> known = columns;
  for (const auto& [name, value] : result_numbers({}, {})) known.push_back(name);
  for (const auto& [name, value] : norms) known.push_back(name);
  Problems problems;
  for (const Settings& check : scene.list("check")) {
    for (const char* key : {"value", "reference", "tolerance"})
      check_names(check, key, known, problems);
    check_share(check, problems);
  }
  problems.raise();
}

std::vector<Report::Check> judge(const Settings& scene, const Results& results) {
  const Quantities quantities = quantities_of(results);
  std::vector<Report::Check> checks;
  for (const Settings& section : scene.list("check"))
    checks.push_back(judge_one(section, quantities));
  return checks;
}

}  // namespace breccia
