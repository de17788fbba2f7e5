// The run loop: steps until the end, with everything that is written on the way.
#include "core/log.hpp"
#include "io/run_folder.hpp"
#include "io/scene_reader.hpp"
#include "scene/commands.hpp"
#include "scene/cost_sheet.hpp"
#include "scene/field_norms.hpp"
#include "scene/guard.hpp"
#include "scene/interrupt.hpp"
#include "scene/part_state.hpp"
#include "scene/precision.hpp"
#include "scene/recorder.hpp"
#include "scene/scene.hpp"
#include "scene/verdict.hpp"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <iostream>
#include <sstream>

namespace breccia {

namespace {

using Watch = std::chrono::steady_clock;

double seconds_since(Watch::time_point start) {
  return std::chrono::duration<double>(Watch::now() - start).count();
}

/// What ranks ask of one another in a step.
constexpr std::uint64_t kInterrupted = 1, kCheckpoint = 2;

template <int D>
class Run {
 public:
  Run(const Settings& scene, const std::filesystem::path& folder, const RunRequest& request,
      const std::string& output)
      : scene_(scene),
        request_(request),
        world_(request.world != nullptr && request.world->size() > 1 ? request.world : nullptr),
        whole_(std::make_unique<Simulation<D>>(scene, folder)) {
    std::ostringstream resolved;
    scene.write_resolved(resolved);
    identity_ = identity_of(resolved.str());
    // A scene that cannot start must not leave a folder behind.
    if (!request.restart) {
      whole_->start();
      check_checks(scene, history_columns(*whole_), field_norms(*whole_));
    }
    lead([&] {
      const ExistingFolder existing = request.restart     ? ExistingFolder::restart
                                      : request.overwrite ? ExistingFolder::overwrite
                                                          : ExistingFolder::refuse;
      folder_ = std::make_unique<RunFolder>(output, existing);
      if (!request.restart) folder_->write_scene(resolved.str());
    });
    OutputState state;
    if (request.restart) state = load_state(RunFolder::checkpoint_in(output), identity_, *whole_);
    if (world_ != nullptr) deal_out();
    recorder_ = std::make_unique<Recorder<D>>(simulation(), folder_.get(), scene,
                                              [this] { return whole(); });
    guard_ = std::make_unique<Guard<D>>(simulation(), scene.at("run"));
    if (request.restart) {
      wall_before_ = state.wall_seconds;
      recorder_->resume(state);
    } else {
      recorder_->start();
    }
  }

  int execute() {
    announce();
    const Watch::time_point start = Watch::now();
    loop(start);
    close();
    const double wall = wall_before_ + seconds_since(start);
    Report report = make_report(simulation(), *recorder_, {status_, reason_, wall});
    report.guard = guard_->seen();
    int status = 0;
    Simulation<D>* all = whole();
    lead([&] { status = conclude(report, *all); });
    if (world_ == nullptr) return status;
    return static_cast<int>(world_->largest(status));
  }

 private:
  /// Work of the rank that writes.
  void lead(const std::function<void()>& work) const {
    if (world_ == nullptr)
      work();
    else
      world_->lead(work);
  }

  bool leads() const { return world_ == nullptr || world_->speaks(); }

  /// The simulation that this rank steps.
  Simulation<D>& simulation() { return part_ ? *part_ : *whole_; }

  /// The whole scene as it is now, at the rank that writes; null elsewhere.
  Simulation<D>* whole() {
    if (part_) collect_state(*part_, whole_.get());
    return leads() ? whole_.get() : nullptr;
  }

  void deal_out() {
    parts_ = std::make_unique<Parts<D>>(*world_, whole_->model());
    part_ = std::make_unique<Simulation<D>>(scene_, *parts_);
    take_state(*whole_, *part_);
    // With contact everybody needs to know again and again what is around.
    if (!leads() && !scene_.has("contact")) whole_.reset();
  }

  /// The ranks look around anew: after things have moved, others may be near.
  void look_around() {
    collect_state(*part_, whole_.get(), true);
    whole_->model().part.skin = part_->model().part.skin;
    auto parts = std::make_unique<Parts<D>>(*world_, whole_->model(), parts_->partition());
    auto part = std::make_unique<Simulation<D>>(scene_, *parts);
    take_state(*whole_, *part);
    part->ask_for(part_->asked());
    part_ = std::move(part);
    parts_ = std::move(parts);
    recorder_->follow(*part_);
    guard_->follow(*part_);
  }

  void announce() {
    const Model<D>& model = simulation().model();
    if (leads())
      log::info(fmt::format(
          "{}: {} elements, {} nodes, {}step {:.4g} s, about {:.0f} steps",
          scene_.text_or("title", "scene"), whole_->model().elements(), whole_->model().nodes(),
          world_ == nullptr ? "" : fmt::format("{} ranks, ", world_->size()),
          simulation().clock().dt, scene_.at("run").number("duration") / simulation().clock().dt));
    for (const std::string& line : left_in_double(model)) log::info(line);
    for (const std::string& line : precision_doubts(model)) log::warning(line);
  }

  void loop(Watch::time_point start) {
    const double end = scene_.at("run").number("duration");
    const double interval = scene_.at("output").number("checkpoint");
    double next_checkpoint = interval;
    Progress progress(end, "steps");
    const typename Simulation<D>::Watchers watchers{[this] { before_motion(); },
                                                    [this] { after_motion(); }};
    watch_for_interrupt();
    simulation().ask_for([&] {
      const bool due = leads() && seconds_since(start) >= next_checkpoint;
      return (interrupted() ? kInterrupted : 0) | (due ? kCheckpoint : 0);
    });
    while (simulation().clock().time < end) {
      if (parts_ && parts_->outdated(part_->model(), part_->clock()))
        timed("exchange", [this] { look_around(); });
      simulation().step(end, watchers);
      if (simulation().model().stop.raised) break;
      const Rest& rest = simulation().model().rest;
      if (rest.reached && rest.stops) break;
      const std::uint64_t wishes = simulation().wishes();
      interrupted_ = (wishes & kInterrupted) != 0;
      if (interrupted_) break;
      progress.update(simulation().clock().time, static_cast<double>(simulation().clock().step));
      if ((wishes & kCheckpoint) == 0) continue;
      checkpoint(wall_before_ + seconds_since(start));
      next_checkpoint = seconds_since(start) + interval;
    }
    progress.finish();
    wall_loop_ = wall_before_ + seconds_since(start);
  }

  void before_motion() {
    if (guard_->due()) timed("guard", [this] { guard_->before(); });
    timed("output", [this] { recorder_->before(); });
  }

  void after_motion() {
    if (guard_->due()) timed("guard", [this] { guard_->after(); });
    timed("output", [this] { recorder_->after(); });
  }

  /// Does some work and books its time to an effect.
  template <class Work>
  void timed(const char* effect, const Work& work) {
    const Watch::time_point begin = Watch::now();
    work();
    simulation().plan().book(effect, seconds_since(begin), 0);
  }

  void checkpoint(double wall) {
    timed("output", [&] {
      Simulation<D>* all = whole();
      lead([&] {
        OutputState state = recorder_->sync();
        state.wall_seconds = wall;
        save_state(folder_->checkpoint(), identity_, *all, state);
      });
    });
  }

  /// Ends the run: a checkpoint while the state is that of a step's start, then the last row and
  /// frame.
  void close() {
    const Stop stop = simulation().model().stop;
    const Clock& clock = simulation().clock();
    if (interrupted_) {
      checkpoint(wall_loop_);
      status_ = "stopped";
      reason_ = fmt::format(
          "interrupted at time {:.6g} s (step {}); a checkpoint is in {}; go on with "
          "`breccia run ... --restart`",
          clock.time, clock.step, folder_ ? folder_->checkpoint() : "");
    } else if (stop.raised) {
      checkpoint(wall_loop_);
      status_ = "failed";
      reason_ = stop.cause;
    } else {
      status_ = "complete";
      checkpoint(wall_loop_);
      const Rest& rest = simulation().model().rest;
      if (rest.wanted && !rest.reached)
        log::warning(
            fmt::format("the scene has not come to rest: largest net force {:.2g} of the "
                        "mean force on a corner; give it a longer run.duration",
                        rest.unbalance));
    }
    recorder_->expect_last();
    simulation().close({[this] { timed("output", [this] { recorder_->before(); }); },
                        [this] { timed("output", [this] { recorder_->after(); }); }});
    timed("output", [this] { recorder_->finish(); });
  }

  /// Checks, report, exit status; at the rank that writes.
  int conclude(Report& report, Simulation<D>& all) {
    report.elements = all.model().elements();
    report.nodes = all.model().nodes();
    report.ranks = world_ == nullptr ? 1 : world_->size();
    report.element_steps_per_second = static_cast<double>(report.elements) *
                                      static_cast<double>(report.steps) / report.wall_seconds;
    report.fragments = static_cast<std::int64_t>(recorder_->last_fragments());
    report.state_hash = state_hash(all);
    const Results results = this->results(report, all);
    report.numbers = results.numbers;
    report.checks = judge(scene_, results);
    write_report(report, folder_->report());
    if (!request_.quiet) print_report(report, std::cout);
    if (status_ != "complete") {
      log::error(reason_);
      return 1;
    }
    for (const Report::Check& check : report.checks)
      if (!check.pass) return 3;
    return 0;
  }

  Results results(const Report& report, Simulation<D>& all) {
    Numbers numbers = result_numbers(
        report, find_main_crack<D>(recorder_->last_cracks(), all.model().mesh.point));
    const Numbers norms = field_norms(all);
    numbers.insert(numbers.end(), norms.begin(), norms.end());
    return {recorder_->columns(), recorder_->history(), std::move(numbers)};
  }

  const Settings& scene_;
  const RunRequest& request_;
  const World* world_;  ///< null: one rank
  /// The whole scene: what is stepped by one rank; of many the first keeps it for output.
  std::unique_ptr<Simulation<D>> whole_;
  std::unique_ptr<Parts<D>> parts_;
  std::unique_ptr<Simulation<D>> part_;
  CheckpointIdentity identity_;
  std::unique_ptr<RunFolder> folder_;  ///< at the rank that writes
  std::unique_ptr<Recorder<D>> recorder_;
  std::unique_ptr<Guard<D>> guard_;
  double wall_before_ = 0, wall_loop_ = 0;
  bool interrupted_ = false;
  std::string status_, reason_;
};

}  // namespace

int run_scene(const RunRequest& request) {
  const Scene scene = read_and_resolve(request.scene, request.options);
  const std::string output = request.output ? request.output->string() : (scene.name + ".out");
  if (scene.dimension() == 2)
    return Run<2>(scene.settings, scene.folder, request, output).execute();
  return Run<3>(scene.settings, scene.folder, request, output).execute();
}

}  // namespace breccia
