// The run loop: steps until the end, with everything that is written on the way.
#include "core/log.hpp"
#include "io/run_folder.hpp"
#include "io/scene_reader.hpp"
#include "scene/commands.hpp"
#include "scene/cost_sheet.hpp"
#include "scene/field_norms.hpp"
#include "scene/guard.hpp"
#include "scene/interrupt.hpp"
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

template <int D>
class Run {
 public:
  Run(const Settings& scene, const std::filesystem::path& folder, const RunRequest& request,
      const std::string& output)
      : scene_(scene), request_(request), simulation_(scene, folder) {
    std::ostringstream resolved;
    scene.write_resolved(resolved);
    identity_ = identity_of(resolved.str());
    const ExistingFolder existing = request.restart     ? ExistingFolder::restart
                                    : request.overwrite ? ExistingFolder::overwrite
                                                        : ExistingFolder::refuse;
    if (request.restart) {
      folder_ = std::make_unique<RunFolder>(output, existing);
    } else {
      // A scene that cannot start must not leave a folder behind.
      simulation_.start();
      check_checks(scene, history_columns(simulation_), field_norms(simulation_));
      folder_ = std::make_unique<RunFolder>(output, existing);
      folder_->write_scene(resolved.str());
    }
    recorder_ = std::make_unique<Recorder<D>>(simulation_, *folder_, scene);
    guard_ = std::make_unique<Guard<D>>(simulation_, scene.at("run"));
    if (request.restart) {
      const OutputState state = load_state(folder_->checkpoint(), identity_, simulation_);
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
    Report report = make_report(simulation_, *recorder_, {status_, reason_, wall});
    report.guard = guard_->seen();
    const Results results = this->results(report);
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

 private:
  void announce() const {
    const Model<D>& model = simulation_.model();
    log::info(fmt::format("{}: {} elements, {} nodes, step {:.4g} s, about {:.0f} steps",
                          scene_.text_or("title", "scene"), model.elements(), model.nodes(),
                          simulation_.clock().dt,
                          scene_.at("run").number("duration") / simulation_.clock().dt));
    for (const std::string& line : left_in_double(model)) log::info(line);
    for (const std::string& line : precision_doubts(model)) log::warning(line);
  }

  void loop(Watch::time_point start) {
    const double end = scene_.at("run").number("duration");
    const double interval = scene_.at("output").number("checkpoint");
    double next_checkpoint = interval;
    Progress progress(end, "steps");
    const typename Simulation<D>::Watchers watchers{[&] {
                                                      if (guard_->due())
                                                        timed("guard", [&] { guard_->before(); });
                                                      timed("output", [&] { recorder_->before(); });
                                                    },
                                                    [&] {
                                                      if (guard_->due())
                                                        timed("guard", [&] { guard_->after(); });
                                                      timed("output", [&] { recorder_->after(); });
                                                    }};
    watch_for_interrupt();
    while (simulation_.clock().time < end) {
      simulation_.step(end, watchers);
      if (simulation_.model().stop.raised) break;
      const Rest& rest = simulation_.model().rest;
      if (rest.reached && rest.stops) break;
      if (interrupted()) {
        interrupted_ = true;
        break;
      }
      progress.update(simulation_.clock().time, static_cast<double>(simulation_.clock().step));
      if (seconds_since(start) < next_checkpoint) continue;
      checkpoint(wall_before_ + seconds_since(start));
      next_checkpoint = seconds_since(start) + interval;
    }
    progress.finish();
    wall_loop_ = wall_before_ + seconds_since(start);
  }

  /// Does some work and books its time to an effect.
  template <class Work>
  void timed(const char* effect, const Work& work) {
    const Watch::time_point begin = Watch::now();
    work();
    simulation_.plan().book(effect, seconds_since(begin), 0);
  }

  void checkpoint(double wall) {
    timed("output", [&] {
      OutputState state = recorder_->sync();
      state.wall_seconds = wall;
      save_state(folder_->checkpoint(), identity_, simulation_, state);
    });
  }

  /// Ends the run: a checkpoint while the state is that of a step's start, then the last row and
  /// frame.
  void close() {
    const Stop stop = simulation_.model().stop;
    if (interrupted_) {
      checkpoint(wall_loop_);
      status_ = "stopped";
      reason_ = fmt::format(
          "interrupted at time {:.6g} s (step {}); a checkpoint is in {}; go on with "
          "`breccia run ... --restart`",
          simulation_.clock().time, simulation_.clock().step, folder_->checkpoint());
    } else if (stop.raised) {
      checkpoint(wall_loop_);
      status_ = "failed";
      reason_ = stop.cause;
    } else {
      status_ = "complete";
      checkpoint(wall_loop_);
      const Rest& rest = simulation_.model().rest;
      if (rest.wanted && !rest.reached)
        log::warning(
            fmt::format("the scene has not come to rest: largest net force {:.2g} of the "
                        "mean force on a corner; give it a longer run.duration",
                        rest.unbalance));
    }
    recorder_->expect_last();
    simulation_.close({[this] { timed("output", [this] { recorder_->before(); }); },
                       [this] { timed("output", [this] { recorder_->after(); }); }});
    timed("output", [this] { recorder_->finish(); });
  }

  Results results(const Report& report) {
    const std::vector<Point<D>>& points = simulation_.model().mesh.point;
    Numbers numbers = result_numbers(report, find_main_crack<D>(recorder_->last_cracks(), points));
    const Numbers norms = field_norms(simulation_);
    numbers.insert(numbers.end(), norms.begin(), norms.end());
    return {recorder_->columns(), recorder_->history(), std::move(numbers)};
  }

  const Settings& scene_;
  const RunRequest& request_;
  Simulation<D> simulation_;
  CheckpointIdentity identity_;
  std::unique_ptr<RunFolder> folder_;
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
