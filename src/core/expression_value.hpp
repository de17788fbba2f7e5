#pragma once
#include "core/expression.hpp"

#include <string>
#include <vector>

namespace breccia {

/// Applies an operator + - * / ^ to numbers or series, element by element.
ExpressionValue combine(char op, const ExpressionValue& a, const ExpressionValue& b);

/// The functions that a formula may call.
bool is_function(const std::string& name);
std::vector<std::string> function_names();

/// How many arguments `name` takes: "1", "2 or more".
bool takes(const std::string& name, std::size_t arguments);
std::string arguments_text(const std::string& name);

/// \throws Error with an empty place when the arguments are not what the function needs.
ExpressionValue call(const std::string& name, const std::vector<ExpressionValue>& arguments,
                     const std::vector<double>& time);

}  // namespace breccia
