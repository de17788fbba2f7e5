#pragma once
#include "core/log.hpp"
#include "io/scene_reader.hpp"
#include "scene/commands.hpp"
#include "scene/simulation.hpp"

#include <memory>
#include <string>

namespace breccia::perf {

/// A simulation together with the settings that it refers to.
template <int D>
struct RunningScene {
  Settings settings;
  std::unique_ptr<Simulation<D>> simulation;

  explicit RunningScene(const std::string& text) {
    log::set_quiet(true);
    Schema schema;
    declare_schema(schema);
    settings = schema.resolve(read_scene_text(text, "benchmark"));
    simulation = std::make_unique<Simulation<D>>(settings, ".");
    simulation->start();
  }
};

/// What a shaking block is made of.
struct BlockKind {
  std::string element = {};  ///< tri3 or tet4 if empty
  int group = 1;             ///< sub-elements of that element
  bool mixed = false;        ///< precision
  std::string elastic = "elastic = { young = 60e9, poisson = 0.25 }\n";
};

/// A block of jittered elements that shakes: about `elements` simplices. `extra` adds keys of the
/// material and sections.
template <int D>
std::string shaking_block(double elements, const std::string& extra = {},
                          const BlockKind& kind = {}) {
  const int per_cell = (D == 2 ? 2 : 6) * kind.group;
  const int n = static_cast<int>(std::pow(elements / per_cell, 1.0 / D) + 0.5);
  const std::string cells = std::to_string(n);
  const bool plane = D == 2;
  return std::string("[run]\ndimension = ") + (plane ? "2" : "3") +
         "\nduration = 1.0\nprecision = \"" + (kind.mixed ? "mixed" : "double") +
         "\"\n[[body]]\nname = \"block\"\nmaterial = \"rock\"\n" +
         (plane ? "shape = { rectangle = { corner = [0, 0], size = [1, 1] } }\n"
                : "shape = { box = { corner = [0, 0, 0], size = [1, 1, 1] } }\n") +
         "mesh = { generator = \"structured\", jitter = 0.1, pattern = \"" +
         (plane ? "right" : "kuhn") +
         (kind.element.empty() ? "\"" : "\", element = \"" + kind.element + "\"") + ", cells = [" +
         cells + ", " + cells + (plane ? "] }\n" : ", " + cells + "] }\n") +
         (plane ? "spin = 1.0\n" : "spin = [0, 0, 1]\n") + "[material.rock]\ndensity = 2650\n" +
         kind.elastic + extra;
}

}  // namespace breccia::perf
