#include "batch/runner.hpp"

#include "core/error.hpp"
#include "core/log.hpp"
#include "io/json_reader.hpp"
#include "jobs/outcome.hpp"
#include "jobs/queue.hpp"
#include "scene/interrupt.hpp"

#include <fmt/format.h>

#include <cstdlib>

namespace breccia {

namespace {

namespace fs = std::filesystem;
using Stage = VariantState::Stage;

/// Whether something else than the run itself has ended it.
bool was_cut_off(const Ending& ending, const std::string& folder) {
  constexpr int by_signal = 128;  // a launcher reports the signal of a rank so
  if (ending.signal != 0 || ending.status > by_signal || ending.late) return true;
  try {
    return ending.status == 1 && read_json(folder + "/report.json")["status"].text() == "stopped";
  } catch (const Error&) {
    return false;
  }
}

class Runner {
 public:
  Runner(const Sweep& sweep, int attempts, std::vector<VariantState>& states,
         const VariantInspector& inspect)
      : sweep_(sweep),
        attempts_(attempts),
        states_(states),
        inspect_(inspect),
        queue_(sweep.side_by_side, sweep.time_limit) {}

  void run(const std::vector<std::size_t>& numbers) {
    for (const std::size_t v : numbers) queue_.add(v);
    queue_.run([this](std::size_t v) { return start(v); },
               [this](std::size_t v, const Ending& ending) { finish(v, ending); });
  }

 private:
  std::unique_ptr<Process> start(std::size_t v) {
    VariantState& state = states_[v];
    const fs::path folder = sweep_.folder(v);
    const bool restart = state.cut_off && fs::exists(folder / "checkpoint.h5");
    state.stage = Stage::running;
    state.attempts += 1;
    state.cut_off = true;  // should nobody be left to say otherwise
    state.reason.clear();
    save_state(sweep_, v, state);
    const bool in_slurm = std::getenv("SLURM_JOB_ID") != nullptr;
    return std::make_unique<Process>(run_command(sweep_, v, restart, in_slurm),
                                     (folder / kLogFile).string());
  }

  void finish(std::size_t v, const Ending& ending) {
    VariantState& state = states_[v];
    const std::string folder = sweep_.folder(v).string();
    try {
      state.reason = trouble_of(ending, folder, sweep_.time_limit);
    } catch (const Error& e) {
      state.reason = e.what();
    }
    const bool complete = state.reason.empty();
    state.stage = complete ? Stage::complete : interrupted() ? Stage::stopped : Stage::failed;
    state.cut_off = !complete && (interrupted() || was_cut_off(ending, folder));
    save_state(sweep_, v, state);
    const bool again = state.stage == Stage::failed && state.attempts < attempts_;
    if (again) queue_.add(v);
    say(v, ending, again);
    if (complete && inspect_) inspect_(v);
  }

  void say(std::size_t v, const Ending& ending, bool again) const {
    const VariantState& state = states_[v];
    const std::string what =
        state.stage == Stage::complete
            ? fmt::format("{:.3g} s", ending.wall)
            : stage_text(state.stage) + ": " + state.reason + (again ? "; once more" : "");
    log::info(sweep_.variants[v].folder + "  " + sweep_.variants[v].label + ": " + what);
  }

  const Sweep& sweep_;
  int attempts_;
  std::vector<VariantState>& states_;
  const VariantInspector& inspect_;
  JobQueue queue_;
};

}  // namespace

std::vector<std::string> run_command(const Sweep& sweep, std::size_t variant, bool restart,
                                     bool in_slurm) {
  std::vector<std::string> command;
  const std::string ranks = std::to_string(sweep.ranks), threads = std::to_string(sweep.threads);
  if (sweep.ranks > 1 && in_slurm) {
    command = {"srun", "--ntasks=" + ranks, "--cpus-per-task=" + threads};
  } else if (sweep.ranks > 1) {
    // Unbound, or all runs side by side would share the first cores.
    command = {"mpirun", "-n", ranks, "--bind-to", "none"};
  }
  for (const std::string& word : {sweep.program, std::string("run"), sweep.scene.string()})
    command.push_back(word);
  for (const std::string& option : sweep.variants[variant].options) {
    command.emplace_back("--set");
    command.push_back(option);
  }
  command.insert(command.end(), {"--quiet", restart ? "--restart" : "--overwrite", "--threads",
                                 threads, "--output", sweep.folder(variant).string()});
  return command;
}

void run_variants(const Sweep& sweep, const std::vector<std::size_t>& numbers, int attempts,
                  std::vector<VariantState>& states, const VariantInspector& inspect) {
  Runner(sweep, attempts, states, inspect).run(numbers);
}

}  // namespace breccia
