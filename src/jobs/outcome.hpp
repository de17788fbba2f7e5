#pragma once

#include "jobs/process.hpp"

#include <optional>
#include <string>

namespace breccia {

/// What a job prints lands in this file of its folder.
inline constexpr const char* kLogFile = "log.txt";

/// Why a run has no result, from how it ended and what it has left in its folder; empty where it
/// has one. A failed check is a result. `time_limit` is the one that made it late.
/// \throws Error when report.json cannot be read.
std::string trouble_of(const Ending& ending, const std::string& folder,
                       std::optional<double> time_limit);

}  // namespace breccia
