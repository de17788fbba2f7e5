#pragma once

#include "jobs/process.hpp"

#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <vector>

namespace breccia {

/// Jobs that wait for their turn and run as processes, a bounded number at a time.
class JobQueue {
 public:
  /// Starts a job; nothing where it need not run after all.
  using Start = std::function<std::unique_ptr<Process>(std::size_t job)>;
  /// Is told how a job ended, of those that an interrupt has stopped too; may add jobs.
  using Finish = std::function<void(std::size_t job, const Ending& ending)>;

  /// `time_limit` [s] of each job. A job that is to stop is asked first, and killed half a minute
  /// later.
  explicit JobQueue(int side_by_side, std::optional<double> time_limit = {})
      : side_by_side_(static_cast<std::size_t>(side_by_side)), time_limit_(time_limit) {}

  void add(std::size_t job) { waiting_.push_back(job); }

  /// Runs until no job is left. Ctrl-C and SIGTERM stop the jobs that run, and no other starts.
  void run(const Start& start, const Finish& finish);

 private:
  struct Running {
    std::size_t job;
    std::unique_ptr<Process> process;
    bool late = false;
    double asked = 0;  ///< [s] after its start; 0: it may run
  };

  void fill(const Start& start);
  void look(const Finish& finish);
  static void ask(Running& one);

  std::size_t side_by_side_;
  std::optional<double> time_limit_;
  std::deque<std::size_t> waiting_;
  std::vector<Running> running_;
};

}  // namespace breccia
