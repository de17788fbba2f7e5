#pragma once

#include "study/plan.hpp"

namespace breccia {

/// The jobs of a study: every combination of rungs, or each ladder on its own with the other knobs
/// as in the scene. Labels and options are filled in; the identity is not.
std::vector<Job> climb(const std::vector<Knob>& knobs, bool product);

/// Finds jobs that have the same identity, which run once, and numbers the folders.
void number_jobs(std::vector<Job>& jobs);

/// Jobs along the ladder of one knob, the others fixed: indices into `jobs`, in order of the rungs.
/// Only lines of at least two.
std::vector<std::vector<std::size_t>> lines_along(std::size_t knob, const std::vector<Job>& jobs);

/// "element tri3" of a line along another knob; empty where nothing else is varied.
std::string other_rungs(const Job& job, std::size_t knob, const std::vector<Knob>& knobs);

}  // namespace breccia
