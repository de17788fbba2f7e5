#include "batch/batch.hpp"

#include "batch/runner.hpp"
#include "batch/slurm.hpp"
#include "batch/summary.hpp"
#include "core/error.hpp"
#include "core/log.hpp"
#include "io/aside_file.hpp"
#include "jobs/folder_lock.hpp"
#include "scene/interrupt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

namespace breccia {

namespace {

using Numbers = std::vector<std::size_t>;
using Stage = VariantState::Stage;
constexpr int kAttempts = 2;  // failed ones are retried once
constexpr int kNotAll = 1, kCheckFailed = 3;

int list_variants(const Sweep& sweep) {
  for (const Variant& variant : sweep.variants)
    std::cout << variant.folder << "  " << variant.label << "\n";
  return 0;
}

std::string counted(std::size_t variants) {
  return fmt::format("{} variant{}", variants, variants == 1 ? "" : "s");
}

class Batch {
 public:
  explicit Batch(const BatchRequest& request)
      : request_(request),
        sweep_(plan_batch(request)),
        states_(load_states(sweep_, request.overwrite)) {
    const auto done = of({Stage::complete});
    if (!done.empty()) check_collected(sweep_, done.front());
  }

  /// All variants that are not complete, here.
  int run() {
    if (const auto job = slurm_job(sweep_); job && in_queue(sweep_, *job)) {
      throw Error(sweep_.output.string(), "Slurm still runs these variants, as job " + *job,
                  "breccia batch --collect tells how far they are; scancel " + *job +
                      " takes them out of the queue");
    }
    forget_slurm_job(sweep_);
    const FolderLock lock(sweep_.output, FolderLock::Hold::alone);
    const Numbers open = reopened();
    log::info(fmt::format("{}: {} in {}, {} to run, {} at a time", sweep_.name,
                          counted(states_.size()), sweep_.output.string(), open.size(),
                          sweep_.side_by_side));
    run_variants(sweep_, open, kAttempts, states_, inspector());
    const int status = summarise();
    if (interrupted())
      log::error(
          "interrupted; complete variants are kept, the same command goes on with the others");
    return status;
  }

  /// The variants of one task, each once.
  int run_these(const Numbers& numbers) {
    const FolderLock lock(sweep_.output, FolderLock::Hold::with_others);
    const auto complete = [this](std::size_t v) { return states_[v].stage == Stage::complete; };
    Numbers open = numbers;
    std::erase_if(open, complete);
    run_variants(sweep_, open, 1, states_, {});
    if (!std::all_of(numbers.begin(), numbers.end(), complete)) return kNotAll;
    return checks_hold(numbers) ? 0 : kCheckFailed;
  }

  /// All variants that are not complete, by Slurm.
  int submit_open() {
    const Numbers open = reopened();
    if (open.empty()) return summarise();
    if (const auto job = slurm_job(sweep_); job && !request_.dry_run && in_queue(sweep_, *job))
      throw Error(sweep_.output.string(), "Slurm still runs these variants, as job " + *job,
                  "breccia batch --collect tells how far they are");
    submit_these(open);
    return 0;
  }

  /// What is there; failed variants of a job that has ended go to Slurm once more.
  int collect() {
    const auto job = slurm_job(sweep_);
    if (!job) return summarise();
    if (in_queue(sweep_, *job)) {
      summarise();
      log::info("Slurm still has tasks of job " + *job + "; collect again when they have ended");
      return kNotAll;
    }
    mark_lost();
    Numbers again;
    for (const std::size_t v : of({Stage::failed, Stage::stopped}))
      if (states_[v].attempts < kAttempts) again.push_back(v);
    if (!again.empty() && !request_.dry_run) {
      summarise();
      submit_these(again);
      return kNotAll;
    }
    if (!request_.dry_run) forget_slurm_job(sweep_);
    return summarise();
  }

 private:
  [[nodiscard]] Numbers of(std::initializer_list<Stage> stages) const {
    Numbers numbers;
    for (std::size_t v = 0; v < states_.size(); ++v)
      if (std::find(stages.begin(), stages.end(), states_[v].stage) != stages.end())
        numbers.push_back(v);
    return numbers;
  }

  /// What is not complete has all its attempts before it again.
  Numbers reopened() {
    Numbers open;
    for (std::size_t v = 0; v < states_.size(); ++v) {
      if (states_[v].stage == Stage::complete) continue;
      states_[v].attempts = 0;
      open.push_back(v);
    }
    return open;
  }

  [[nodiscard]] VariantInspector inspector() const {
    return [this, seen = !of({Stage::complete}).empty()](std::size_t variant) mutable {
      if (!seen) check_collected(sweep_, variant);
      seen = true;
    };
  }

  void submit_these(const Numbers& numbers) {
    const auto script = write_slurm_script(sweep_, request_, numbers);
    if (request_.dry_run) {
      log::info("written, not submitted: " + script.string());
      return;
    }
    const std::vector<VariantState> before = states_;
    for (const std::size_t v : numbers) {
      states_[v].stage = Stage::queued;
      save_state(sweep_, v, states_[v]);
    }
    try {
      const std::string job = submit(sweep_, script);
      log::info(fmt::format("{} with Slurm as job {}; breccia batch --collect makes the summary",
                            counted(numbers.size()), job));
    } catch (const Error&) {
      for (const std::size_t v : numbers) save_state(sweep_, v, before[v]);
      throw;
    }
  }

  /// What tasks that are gone could not write down themselves. One that was to run several variants
  /// has been stopped in front of the rest; one of a single variant was cancelled, or cannot begin.
  void mark_lost() {
    for (const std::size_t v : of({Stage::queued})) {
      states_[v].stage = sweep_.slurm.variants_per_task > 1 ? Stage::stopped : Stage::waiting;
      states_[v].reason = "its task has not begun with it; the texts in slurm may say why";
    }
    for (const std::size_t v : of({Stage::running})) {
      states_[v].stage = Stage::failed;
      states_[v].reason = "ended without a word: its task was killed, or its machine went down";
    }
  }

  [[nodiscard]] bool checks_hold(const Numbers& numbers) const {
    const auto results = read_variants(sweep_, states_);
    return std::all_of(numbers.begin(), numbers.end(), [&](std::size_t v) {
      return results[v].passed() == static_cast<int>(results[v].checks.size());
    });
  }

  /// Writes and prints the summary and names what has failed. The exit status.
  int summarise() const {
    const auto results = read_variants(sweep_, states_);
    const auto file = sweep_.output / "summary.csv";
    std::filesystem::create_directories(sweep_.output);
    write_whole(file.string(), summary_csv(sweep_, states_, results));
    if (!request_.quiet) {
      print_summary(sweep_, states_, results, std::cout);
      std::cout << "\n  " << file.string() << "\n";
    }
    const Numbers failed = of({Stage::failed});
    std::string list = fmt::format("{} of {} failed", failed.size(), counted(states_.size()));
    for (const std::size_t v : failed)
      list += fmt::format("\n  {} ({}): {}", sweep_.variants[v].folder, sweep_.variants[v].label,
                          states_[v].reason);
    if (!failed.empty()) log::error(list + "\n  log.txt in the folder of a variant says more");
    const Numbers complete = of({Stage::complete});
    if (complete.size() < states_.size()) return kNotAll;
    return checks_hold(complete) ? 0 : kCheckFailed;
  }

  const BatchRequest& request_;
  Sweep sweep_;
  std::vector<VariantState> states_;
};

}  // namespace

int batch_scene(const BatchRequest& request) {
  if (request.list) return list_variants(plan_batch(request));
  Batch batch(request);
  if (!request.variants.empty()) return batch.run_these(request.variants);
  if (request.collect) return batch.collect();
  if (request.slurm) return batch.submit_open();
  return batch.run();
}

}  // namespace breccia
