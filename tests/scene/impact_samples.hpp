#pragma once
#include "harness/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace breccia {

/// Strips one cell high between planes of symmetry: a flyer of thickness h hits a target of 2 h at
/// x = 0. `rest` is the material "m" and what else the scene needs.
inline std::string plates(double thickness, int cells, double speed, const std::string& rest) {
  const double cell = thickness / cells;
  const auto plate = [&](const char* name, double from, int number, double velocity) {
    return fmt::format(
        "[[body]]\nname = \"{}\"\nmaterial = \"m\"\nvelocity = [{}, 0]\n"
        "shape = {{ rectangle = {{ corner = [{}, 0], size = [{}, {}] }} }}\n"
        "mesh = {{ generator = \"structured\", cells = [{}, 1], pattern = \"right\" }}\n",
        name, velocity, from, number * cell, cell, number);
  };
  const auto side = [](double y) {
    return fmt::format(
        "[[boundary]]\nplane = {{ point = [0, {}], normal = [0, 1] }}\nsymmetry = true\n", y);
  };
  return "[run]\ndimension = 2\nduration = 1\n" + plate("flyer", -thickness, cells, speed) +
         plate("target", 0, 2 * cells, 0) + side(0) + side(cell) + "[contact]\n" + rest;
}

/// Velocity of the free surface, and what broke.
struct Trace {
  std::vector<double> time, velocity;  ///< s, m/s
  std::vector<double> plane;           ///< x of what broke, in order, m

  /// Mean between two times, m/s.
  double mean(double from, double to) const {
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < time.size(); ++i)
      if (time[i] > from && time[i] < to) sum += velocity[i], ++count;
    return sum / count;
  }
  double least(double from, double to) const {
    double v = 1e300;
    for (std::size_t i = 0; i < time.size(); ++i)
      if (time[i] > from && time[i] < to) v = std::min(v, velocity[i]);
    return v;
  }
  /// When it first rises through `level`, s.
  double arrival(double level) const {
    for (std::size_t i = 1; i < time.size(); ++i)
      if (velocity[i] >= level)
        return time[i - 1] + (time[i] - time[i - 1]) * (level - velocity[i - 1]) /
                                 (velocity[i] - velocity[i - 1]);
    return NAN;
  }
};

inline Trace run_plates(const std::string& scene, double end) {
  SceneWorld<2> world(scene);
  world.simulation.start();
  const std::vector<Index> nodes = find_region(world.model().mesh, "target.right")->points;
  Trace trace;
  while (world.time() < end) {
    world.step();
    const auto v = world.host<NodeVelocity<2>>();
    double sum = 0;
    for (const Index n : nodes) sum += v(n, 0);
    trace.time.push_back(world.time());
    trace.velocity.push_back(sum / static_cast<double>(nodes.size()));
    for (const auto& module : world.simulation.modules())
      for (const Event& event : module->take_events()) trace.plane.push_back(event.place[0]);
  }
  return trace;
}

}  // namespace breccia
