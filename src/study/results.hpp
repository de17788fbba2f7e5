#pragma once

#include "study/jobs.hpp"
#include "study/plan.hpp"

#include <array>

namespace breccia {

/// A ladder of one knob, the others fixed.
struct Line {
  std::size_t knob = 0;
  std::string others;                ///< "element tri3"; empty where nothing else is varied
  double order = JobResult::kNone;   ///< over the last two rungs
  double fitted = JobResult::kNone;  ///< over all of them
  bool moves = false;                ///< the error falls at least to half along the ladder
};

/// The cheapest job that reaches an error.
struct Target {
  double error = 0;
  std::optional<std::size_t> job;
};

inline constexpr std::array<double, 3> kTargets{0.05, 0.01, 0.001};

/// What a study says of one quantity; lists have one entry per job.
struct Findings {
  std::vector<double> value, reference, error;  ///< error as a share of the scale
  std::vector<std::string> note;                ///< why there is no value
  std::vector<bool> front;                      ///< not beaten in both error and seconds
  std::string basis;                            ///< how the reference was found
  std::vector<Line> lines;
  std::vector<Target> targets;
  std::optional<std::size_t> best;
  bool constant = false;  ///< the same in all jobs
};

/// Median seconds of a job, as the study counts them.
double seconds_of(const Study& study, const JobResult& outcome);

/// \throws Error with an empty place when a formula speaks of what a finished job does not have.
void check_names(const Judged& judged, const std::filesystem::path& folder);

Findings find(const Study& study, const Judged& judged, const Runs& runs);

/// One sentence per target and per ladder, ready to be read.
std::vector<std::string> sentences(const Study& study, const Judged& judged, const Runs& runs,
                                   const Findings& findings);

}  // namespace breccia
