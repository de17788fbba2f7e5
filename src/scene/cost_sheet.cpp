#include "scene/cost_sheet.hpp"

#include "core/build_info.hpp"
#include "scene/catalog.hpp"

#include <sys/resource.h>

namespace breccia {

std::int64_t peak_memory_bytes() {
  rusage usage{};
  if (getrusage(RUSAGE_SELF, &usage) != 0) return 0;
  return static_cast<std::int64_t>(usage.ru_maxrss) * 1024;  // Linux counts in KiB
}

namespace {

/// In the order of `breccia check`.
template <int D>
void add_effects(const Simulation<D>& simulation, const std::vector<Cost>& costs, Report& report) {
  std::vector<EffectState> states = effects_of(simulation.scene());
  states.push_back({"guard", simulation.scene().at("run").integer("guard.every") > 0, ""});
  states.push_back({"output", true, ""});
  if (!simulation.model().part.whole()) states.push_back({"exchange", true, ""});
  for (const EffectState& state : states) {
    if (!state.on) {
      report.effects_off.push_back(state.name);
      continue;
    }
    Report::Effect effect;
    effect.name = state.name;
    effect.bytes = static_cast<std::int64_t>(effect_bytes(simulation, effect.name));
    for (const Cost& cost : costs)
      if (cost.effect == effect.name) {
        effect.seconds = cost.seconds;
        effect.launches = cost.launches;
      }
    report.effects.push_back(effect);
  }
}

}  // namespace

template <int D>
std::size_t effect_bytes(const Simulation<D>& simulation, const std::string& effect) {
  std::size_t bytes = simulation.model().store.bytes(effect);
  for (const auto& module : simulation.modules())
    if (module->key() == effect) bytes += module->bytes();
  return bytes;
}

template <int D>
Report make_report(Simulation<D>& simulation, const Recorder<D>& recorder, const Outcome& outcome) {
  const Settings& scene = simulation.scene();
  Report report;
  report.title = scene.text_or("title", "");
  report.status = outcome.status;
  report.reason = outcome.reason;
  report.steps = simulation.clock().step;
  report.time = simulation.clock().time;
  report.wall_seconds = outcome.wall_seconds;
  report.threads = Exec().concurrency();
  report.backend = Exec::name();
  report.precision = scene.at("run").text("precision");
  const StepRecord& step = simulation.step_record();
  report.time_step.min = step.min;
  report.time_step.max = step.max;
  if (report.steps > 0) report.time_step.mean = report.time / static_cast<double>(report.steps);
  report.time_step.set_by = step.set_by;
  report.time_step.added_mass = simulation.model().added_mass;
  const Counts counts = simulation.counts();
  report.interfaces = {counts.bonded, counts.inserted, counts.released};
  const Rest& rest = simulation.model().rest;
  report.rest.wanted = rest.wanted;
  report.rest.reached = rest.reached;
  if (rest.reached) report.rest.time = rest.time;
  report.rest.unbalance = rest.unbalance;
  report.rest.motion = rest.motion;
  const Ledger& ledger = recorder.last_ledger();
  report.ledger.emplace_back("KE", ledger.kinetic);
  report.ledger.emplace_back("W_ext", ledger.external());
  for (const Ledger::Entry& entry : ledger.entries())
    report.ledger.emplace_back(entry.name, entry.joule);
  report.res_1 = ledger.residual_1();
  report.res_2 = ledger.residual_2();
  add_effects(simulation, simulation.plan().costs(), report);
  report.peak_memory_bytes = peak_memory_bytes();
  const BuildInfo& build = build_info();
  report.version = {std::string(build.version), std::string(build.commit),
                    std::string(build.compiler) + " " + std::string(build.build_type)};
  return report;
}

template std::size_t effect_bytes(const Simulation<2>&, const std::string&);
template std::size_t effect_bytes(const Simulation<3>&, const std::string&);
template Report make_report(Simulation<2>&, const Recorder<2>&, const Outcome&);
template Report make_report(Simulation<3>&, const Recorder<3>&, const Outcome&);

}  // namespace breccia
