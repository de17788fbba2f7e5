// breccia check: what a scene would run, without running it.
#include "comm/partition.hpp"
#include "core/log.hpp"
#include "mesh/quality.hpp"
#include "scene/catalog.hpp"
#include "scene/commands.hpp"
#include "scene/field_norms.hpp"
#include "scene/precision.hpp"
#include "scene/recorder.hpp"
#include "scene/scene.hpp"
#include "scene/simulation.hpp"
#include "scene/verdict.hpp"

#include <fmt/format.h>

#include <chrono>
#include <iostream>

namespace breccia {

namespace {

/// Seconds of one step, from a few real ones on a running copy of the scene.
template <int D>
double seconds_per_step(Simulation<D>& simulation) {
  using Watch = std::chrono::steady_clock;
  const double end = simulation.scene().at("run").number("duration");
  int steps = 0;
  const Watch::time_point start = Watch::now();
  double seconds = 0;
  while (simulation.clock().time < end && seconds < 0.5 && !simulation.model().stop.raised) {
    simulation.step(end, {});
    ++steps;
    seconds = std::chrono::duration<double>(Watch::now() - start).count();
  }
  return seconds / steps;
}

template <int D>
void print_effects(const Simulation<D>& simulation) {
  std::cout << "\neffects\n";
  for (const EffectState& effect : effects_of(simulation.scene()))
    std::cout << fmt::format("  {:<10} {:<4} {:>12} bytes\n", effect.name, effect.on ? "on" : "off",
                             simulation.model().store.bytes(effect.name));
}

template <int D>
void print_bodies(const Model<D>& model) {
  std::cout << "bodies\n";
  for (std::size_t b = 0; b < model.mesh.body_names.size(); ++b) {
    const Region& region = *find_region(model.mesh, model.mesh.body_names[b]);
    std::string extent;
    for (int d = 0; d < D; ++d) {
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (const Index n : region.points) {
        low = std::min(low, model.mesh.point[n][d]);
        high = std::max(high, model.mesh.point[n][d]);
      }
      extent += fmt::format("  {} {:.5g} to {:.5g} m", "xyz"[d], low, high);
    }
    const int group = model.mesh.group_of_body(static_cast<Index>(b));
    std::cout << fmt::format("  {:<16} {:>9} {} of {:<12}{}\n", model.mesh.body_names[b],
                             region.elements.size() / static_cast<std::size_t>(group),
                             group == 1 ? "elements" : fmt::format("composites (of {})", group),
                             model.material_of_body(static_cast<Index>(b)).name, extent);
  }
}

/// What dealing the mesh out to ranks would cost.
template <int D>
void print_partitions(const Model<D>& model) {
  if (!can_partition()) return;
  std::cout << "\npartition   imbalance   cut faces   elements computed twice\n";
  for (const int parts : {2, 8, 32}) {
    if (parts > model.elements() / 100) break;
    const Partition p = partition(model.mesh, model.topology, parts);
    std::cout << fmt::format("{:>9} {:>11.3f} {:>11} {:>23.1f} %\n", parts, p.imbalance,
                             p.cut_faces, 100 * p.ghost_share);
  }
}

template <int D>
int check(const Scene& scene) {
  Simulation<D> simulation(scene.settings, scene.folder);
  simulation.start();
  check_checks(scene.settings, history_columns(simulation), field_norms(simulation));
  const Model<D>& model = simulation.model();
  std::vector<double> speed;
  for (std::size_t b = 0; b < model.mesh.body_names.size(); ++b) {
    const Index material = model.body_material[b];
    speed.push_back(std::sqrt(model.p_wave_modulus(material) / model.materials[material].density));
  }
  std::cout << scene.settings.text_or("title", scene.name) << "\n\n";
  print_bodies(model);
  std::cout << "\nmesh\n" << to_text(assess_quality(model.mesh, speed));
  print_effects(simulation);
  std::cout << "\nplan of a step\n" << simulation.plan().print();
  print_partitions(model);
  for (const std::string& line : left_in_double(model)) std::cout << '\n' << line << '\n';
  for (const std::string& line : precision_doubts(model)) log::warning(line);
  const double duration = scene.settings.at("run").number("duration");
  const double dt = simulation.clock().dt;
  const double steps = duration / dt;
  std::cout << fmt::format("\nstep {:.4g} s, set by {}\n", dt, simulation.step_record().set_by)
            << fmt::format("memory of the fields {:.1f} MB\n",
                           static_cast<double>(model.store.bytes()) / 1e6)
            << fmt::format(
                   "about {:.0f} steps; at the present step and with nothing broken about {}\n",
                   steps, duration_text(steps * seconds_per_step(simulation)));
  return 0;
}

}  // namespace

int check_scene(const CheckRequest& request) {
  const Scene scene = read_and_resolve(request.scene, request.options);
  return scene.dimension() == 2 ? check<2>(scene) : check<3>(scene);
}

}  // namespace breccia
