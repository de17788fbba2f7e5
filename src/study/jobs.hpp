#pragma once

#include "study/plan.hpp"

#include <functional>
#include <limits>

namespace breccia {

/// What became of a job.
struct JobResult {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  bool complete = false;
  bool reused = false;                  ///< finished in an earlier call
  std::string reason;                   ///< why it is not complete
  std::vector<double> wall, processor;  ///< [s] of each repeat
  double elements = kNone, steps = kNone, res_1 = kNone, res_2 = kNone;
  [[nodiscard]] double element_steps() const { return elements * steps; }
};

struct Runs {
  std::vector<JobResult> outcomes;  ///< one per job
  bool interrupted = false;         ///< somebody wants the study to stop; finished jobs are kept
};

/// Is shown every job when it is complete; what it throws ends the study.
using Inspector = std::function<void(std::size_t job)>;

/// Runs all jobs that an earlier call has not finished, each in a process and a folder of its own.
/// A job that fails keeps its reason and is tried again by the next call.
Runs run_jobs(const Study& study, const Inspector& inspect);

}  // namespace breccia
