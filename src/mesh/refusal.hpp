#pragma once

#include "mesh/mesh.hpp"

#include <span>
#include <string>

namespace breccia {

/// Throws Error with place, cause and remedy.
[[noreturn]] void refuse(const std::string& place, const std::string& cause,
                         const std::string& remedy);

/// "3, 7, 12 and 4 more": the first few ids of a list.
std::string list_ids(std::span<const Index> ids);

/// "element 7" or "elements 7, 9 and 3 more".
std::string name_ids(const std::string& entity, std::span<const Index> ids);

/// "(0.1, 0.25) m"
template <std::size_t D>
std::string place_text(const std::array<double, D>& x);

/// A number with six significant digits.
std::string short_number(double value);

}  // namespace breccia
