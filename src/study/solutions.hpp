#pragma once

#include "core/unit.hpp"

#include <span>
#include <string>
#include <vector>

namespace breccia {

/// A problem whose answer is a formula.
struct Solution {
  struct Parameter {
    std::string name;
    Dimension dimension;
    std::string doc;
  };
  std::string name;  ///< "cantilever.deflection"
  Dimension dimension;
  std::string doc;     ///< what it is the answer to, with the formula
  std::string source;  ///< where it comes from
  std::vector<Parameter> parameters;
  double (*value)(std::span<const double> parameters);  ///< in their order, SI
};

/// All that a study may name.
const std::vector<Solution>& solutions();

/// The value for parameters written "name = quantity". \throws Error with an empty place: no such
/// solution (nearest named), a parameter missing, unknown or of another dimension, no finite value.
double solve(const std::string& name, const std::vector<std::string>& parameters);

/// The list as Markdown: `breccia study --solutions`.
std::string solutions_text();

}  // namespace breccia
