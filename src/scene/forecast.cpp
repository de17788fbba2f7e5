#include "scene/forecast.hpp"

#include "scene/catalog.hpp"
#include "scene/cost_sheet.hpp"
#include "scene/frame_builder.hpp"
#include "scene/guard.hpp"
#include "scene/recorder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace breccia {

namespace {

using Watch = std::chrono::steady_clock;

/// Steps before the measured ones: first searches, first looks at memory.
constexpr int kWarmUp = 2;

template <class Work>
double seconds_of(const Work& work) {
  const Watch::time_point start = Watch::now();
  work();
  return std::chrono::duration<double>(Watch::now() - start).count();
}

double seconds_of(const std::vector<Cost>& costs, const std::string& effect) {
  for (const Cost& cost : costs)
    if (cost.effect == effect) return cost.seconds;
  return 0;
}

/// Seconds of each effect in a step, and how many steps they were measured over.
template <int D>
std::vector<Cost> step_costs(Simulation<D>& simulation, double budget, int& measured) {
  const double end = simulation.scene().at("run").number("duration");
  const auto more = [&] {
    return simulation.clock().time < end && !simulation.model().stop.raised;
  };
  for (int i = 0; i < kWarmUp && more(); ++i) simulation.step(end, {});
  const std::vector<Cost> before = simulation.plan().costs();
  const Watch::time_point start = Watch::now();
  const auto spent = [&] { return std::chrono::duration<double>(Watch::now() - start).count(); };
  for (measured = 0; more() && (measured < 1 || spent() < budget); ++measured)
    simulation.step(end, {});
  std::vector<Cost> costs = simulation.plan().costs();
  for (Cost& cost : costs)
    cost.seconds = (cost.seconds - seconds_of(before, cost.effect)) / std::max(1, measured);
  return costs;
}

/// Seconds of making a frame, and its bytes; nothing is written.
template <int D>
double frame_seconds(Simulation<D>& simulation, std::size_t& bytes) {
  return seconds_of([&] {
    Picture picture;
    const Fragments fragments = find_fragments(simulation.model());
    for (const auto& module : simulation.modules()) module->draw(simulation.model(), picture);
    bytes = FrameBuilder<D>(simulation.model(), simulation.clock(), picture, fragments).bytes();
  });
}

template <int D>
std::size_t checkpoint_bytes(const Store& store) {
  std::size_t sum = 0;
  store.save([&sum](const FieldInfo&, const void*, std::size_t bytes) { sum += bytes; });
  return sum;
}

std::string by_default(const Settings& section, const char* key) {
  return section.given(key) ? line_of(section.place(key)) : "default";
}

/// What is written: rows, frames and checkpoints, their bytes on the disk and the seconds that
/// making them takes.
template <int D>
Forecast::Effect output_of(Simulation<D>& simulation, double seconds_of_steps, double& disk) {
  const Settings& output = simulation.scene().at("output");
  Forecast::Effect effect{"output", true, "[output]", 0, 0, {}};
  disk = 0;
  const auto add = [&](const char* name, double count, double bytes, double seconds,
                       const char* key) {
    effect.parts.push_back(
        {"output", name,
         fmt::format("{:.0f} of {:.3g} MB, {}", count, bytes / 1e6, by_default(output, key)), 0});
    effect.seconds += count * seconds;
    disk += count * bytes;
  };
  history_columns(simulation);
  std::size_t columns = 0;
  const double row = seconds_of([&] { columns = history_columns(simulation).size(); });
  const double rows =
      simulation.scene().at("run").number("duration") / history_interval(simulation.scene());
  add("rows of history.csv", std::floor(rows) + 1, 20 * static_cast<double>(columns), row,
      "history");
  std::size_t frame_bytes = 0;
  const auto frames = output.integer("frames");
  const double frame = frames > 0 ? frame_seconds(simulation, frame_bytes) : 0;
  if (frames > 0)
    add("frames", static_cast<double>(frames + 1), static_cast<double>(frame_bytes), frame,
        "frames");
  const double checkpoints = 1 + std::floor(seconds_of_steps / output.number("checkpoint"));
  const auto state = static_cast<double>(checkpoint_bytes<D>(simulation.model().store));
  // Each replaces the one before, so one stays.
  add("checkpoints", checkpoints, state, 0, "checkpoint");
  disk -= (checkpoints - 1) * state;
  return effect;
}

/// The looks of the guard. It has to be measured when there is a step behind it.
template <int D>
Forecast::Effect guard_of(Simulation<D>& simulation, double steps) {
  const Settings& run = simulation.scene().at("run");
  const auto every = run.at("guard").integer("every");
  Forecast::Effect effect{"guard", every > 0, "", 0, 0, {}};
  effect.why = every > 0
                   ? fmt::format("every {} steps, {}", every, by_default(run.at("guard"), "every"))
                   : "run.guard.every = 0, " + line_of(run.at("guard").place("every"));
  if (every == 0) return effect;
  Guard<D> guard(simulation, run);
  double seconds = 0;
  const auto timed = [&seconds](const auto& work) { seconds += seconds_of(work); };
  simulation.step(
      1e300, {[&] { timed([&] { guard.before(); }); }, [&] { timed([&] { guard.after(); }); }});
  effect.seconds = std::floor(steps / static_cast<double>(every)) * seconds;
  return effect;
}

}  // namespace

double Forecast::seconds() const {
  double sum = 0;
  for (const Effect& effect : effects) sum += effect.seconds;
  return sum;
}

template <int D>
Forecast forecast(Simulation<D>& simulation, double budget) {
  Forecast sheet;
  sheet.steps = simulation.scene().at("run").number("duration") / simulation.clock().dt;
  const std::vector<Cost> costs = step_costs(simulation, budget, sheet.measured);
  const std::vector<EffectPart> parts = parts_of(simulation.model());
  for (const EffectState& state : effects_of(simulation.scene())) {
    Forecast::Effect effect{state.name, state.on, state.why, 0, 0, {}};
    effect.bytes = effect_bytes(simulation, state.name);
    effect.seconds = seconds_of(costs, state.name) * sheet.steps;
    std::copy_if(parts.begin(), parts.end(), std::back_inserter(effect.parts),
                 [&state](const EffectPart& part) { return part.effect == state.name; });
    sheet.effects.push_back(std::move(effect));
  }
  const double steps = sheet.seconds();
  sheet.effects.push_back(guard_of(simulation, sheet.steps));
  sheet.effects.push_back(output_of(simulation, steps, sheet.disk));
  return sheet;
}

std::vector<std::string> unforeseen(const Settings& scene, const std::vector<EffectPart>& parts) {
  std::vector<std::string> list;
  for (const EffectState& effect : effects_of(scene)) {
    if (!effect.on) continue;
    if (effect.name == "fracture")
      list.emplace_back("cracks: interfaces, new surface, a shorter step");
    if (effect.name == "contact") list.emplace_back("contacts that come or go, and searches");
    if (effect.name == "excavation") list.emplace_back("excavations that begin later");
    if (effect.name == "rest") list.emplace_back("when rest is reached");
  }
  for (const EffectPart& part : parts)
    if (part.name == "yielding") list.emplace_back("plastic flow");
  if (scene.at("output").integer("frames") > 0) list.emplace_back("the disk");
  return list;
}

template Forecast forecast(Simulation<2>&, double);
template Forecast forecast(Simulation<3>&, double);

}  // namespace breccia
