// breccia check: what a scene would run, without running it.
#include "comm/partition.hpp"
#include "core/log.hpp"
#include "mesh/quality.hpp"
#include "scene/commands.hpp"
#include "scene/field_norms.hpp"
#include "scene/forecast.hpp"
#include "scene/precision.hpp"
#include "scene/recorder.hpp"
#include "scene/scene.hpp"
#include "scene/simulation.hpp"
#include "scene/verdict.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iostream>

namespace breccia {

namespace {

/// Seconds of real steps that a forecast is made from.
constexpr double kBudget = 0.5;

std::string bytes_text(std::size_t bytes) {
  return bytes < 100000 ? fmt::format("{} B", bytes)
                        : fmt::format("{:.3g} MB", static_cast<double>(bytes) / 1e6);
}

void print_forecast(const Forecast& sheet, const Settings& scene) {
  std::cout << fmt::format("\n{:<24} {:<4} {:>10} {:>10}  {}\n", "effect", "", "memory", "seconds",
                           "why");
  std::vector<EffectPart> parts;
  for (const Forecast::Effect& effect : sheet.effects) {
    if (!effect.on) {
      std::cout << fmt::format("{:<24} {:<4} {:>10} {:>10}  {}\n", effect.name, "off", "-", "-",
                               effect.why);
      continue;
    }
    std::cout << fmt::format("{:<24} {:<4} {:>10} {:>10.3g}  {}\n", effect.name, "on",
                             bytes_text(effect.bytes), effect.seconds, effect.why);
    for (const EffectPart& part : effect.parts)
      std::cout << fmt::format("  {:<27} {:>10} {:>10}  {}\n", part.name,
                               part.bytes > 0 ? bytes_text(part.bytes) : "", "", part.why);
    parts.insert(parts.end(), effect.parts.begin(), effect.parts.end());
  }
  std::cout << fmt::format(
      "\nabout {:.0f} steps; as in the first {}, with nothing broken, about {}\n", sheet.steps,
      sheet.measured, duration_text(sheet.seconds()));
  const std::vector<std::string> more = unforeseen(scene, parts);
  if (!more.empty()) std::cout << fmt::format("not foreseen: {}\n", fmt::join(more, "; "));
  std::cout << fmt::format("files of about {:.3g} MB before compression\n", sheet.disk / 1e6);
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
  std::cout << "\nplan of a step\n" << simulation.plan().print();
  print_partitions(model);
  for (const std::string& line : left_in_double(model)) std::cout << '\n' << line << '\n';
  for (const std::string& line : precision_doubts(model)) log::warning(line);
  std::cout << fmt::format("\nstep {:.4g} s, set by {}\n", simulation.clock().dt,
                           simulation.step_record().set_by)
            << fmt::format("memory of the fields {:.1f} MB\n",
                           static_cast<double>(model.store.bytes()) / 1e6);
  print_forecast(forecast(simulation, kBudget), scene.settings);
  if (model.stop.raised) log::warning("these steps ended with: " + model.stop.cause);
  return 0;
}

}  // namespace

int check_scene(const CheckRequest& request) {
  const Scene scene = read_and_resolve(request.scene, request.options);
  return scene.dimension() == 2 ? check<2>(scene) : check<3>(scene);
}

}  // namespace breccia
