#pragma once

#include "scene/verdict.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace breccia {

/// What a finished run has told, as its own [[check]]s saw it.
/// \throws Error when its files are damaged.
Results read_results(const std::filesystem::path& folder);

/// \throws Error with an empty place when a formula speaks of what a finished run does not have.
void check_names(const std::vector<std::string>& formulas, const std::filesystem::path& folder);

}  // namespace breccia
