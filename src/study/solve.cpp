#include "core/error.hpp"
#include "core/text.hpp"
#include "study/solutions.hpp"

#include <algorithm>
#include <cmath>

namespace breccia {

namespace {

const Solution& find(const std::string& name) {
  std::vector<std::string> names;
  for (const Solution& solution : solutions()) {
    if (solution.name == name) return solution;
    names.push_back(solution.name);
  }
  throw Error("", "no solution '" + name + "'." + did_you_mean(name, names),
              "solutions: " + join(names) + "\nbreccia study --solutions explains them");
}

std::string parameters_text(const Solution& solution) {
  std::vector<std::string> words;
  for (const auto& p : solution.parameters) {
    const std::string si = si_unit(p.dimension);
    words.push_back(p.name + (si == "1" ? "" : " [" + si + "]"));
  }
  return "parameters of " + solution.name + ": " + join(words);
}

std::size_t index_of(const Solution& solution, const std::string& name) {
  std::vector<std::string> names;
  for (const auto& p : solution.parameters) names.push_back(p.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    throw Error("", solution.name + " has no parameter '" + name + "'." + did_you_mean(name, names),
                parameters_text(solution));
  }
  return static_cast<std::size_t>(found - names.begin());
}

double value_of(const Solution::Parameter& parameter, const std::string& text) {
  const Quantity q = parse_quantity(text);
  const bool plain = !q.has_unit;  // a pure number is taken in SI, as in scenes
  if (plain || q.dimension == parameter.dimension) return q.value;
  throw Error("", parameter.name + ": \"" + text + "\" is " +
                      with_article(dimension_name(q.dimension)) + "; " +
                      with_article(friendly(parameter.dimension)) + ", is wanted");
}

}  // namespace

double solve(const std::string& name, const std::vector<std::string>& parameters) {
  const Solution& solution = find(name);
  std::vector<double> values(solution.parameters.size());
  std::vector<bool> given(values.size());
  for (const std::string& pair : parameters) {
    const auto equals = pair.find('=');
    const std::size_t i = index_of(solution, trimmed(pair.substr(0, equals)));
    const std::string text = equals == std::string::npos ? "" : trimmed(pair.substr(equals + 1));
    values[i] = value_of(solution.parameters[i], text);
    given[i] = true;
  }
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (given[i]) continue;
    throw Error("",
                solution.name + " needs the parameter '" + solution.parameters[i].name + "' (" +
                    solution.parameters[i].doc + ")",
                parameters_text(solution));
  }
  const double value = solution.value(values);
  if (std::isfinite(value)) return value;
  throw Error("", solution.name + " has no value for these parameters",
              "check their signs and sizes; " + parameters_text(solution));
}

std::string solutions_text() {
  std::string text = "| solution | unit | what | parameters |\n|---|---|---|---|\n";
  for (const Solution& s : solutions()) {
    std::vector<std::string> words;
    for (const auto& p : s.parameters)
      words.push_back("`" + p.name + "` " + p.doc + " [" + si_unit(p.dimension) + "]");
    text += "| `" + s.name + "` | " + si_unit(s.dimension) + " | " + s.doc + " (" + s.source +
            ") | " + join(words) + " |\n";
  }
  return text;
}

}  // namespace breccia
