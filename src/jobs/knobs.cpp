#include "jobs/knobs.hpp"

#include "core/error.hpp"
#include "core/text.hpp"
#include "core/unit.hpp"

#include <algorithm>
#include <limits>

namespace breccia {

namespace {

using Parts = std::vector<std::string>;

bool bare(const std::string& word) {
  return word.find_first_of(". \"'") == std::string::npos;
}

std::string path_of(const Parts& parts) {
  std::string path;
  for (const std::string& part : parts)
    path += (path.empty() ? "" : ".") + (bare(part) ? part : "\"" + part + "\"");
  return path;
}

/// What * stands for: names of a table, names or indices of a list.
Parts members_of(const Config& group) {
  Parts names;
  if (group.is(Config::Kind::table)) {
    for (const auto& entry : group.table()) names.push_back(entry.first);
  } else if (group.is(Config::Kind::array)) {
    for (std::size_t i = 0; i < group.array().size(); ++i) names.push_back(std::to_string(i));
  }
  return names;
}

const Config* step_into(const Config& here, const std::string& part) {
  if (const Config* inner = here.find(part)) return inner;
  if (!here.is(Config::Kind::array)) return nullptr;
  for (std::size_t i = 0; i < here.array().size(); ++i) {
    const Config& element = here.array()[i];
    const Config* name = element.find("name");
    const bool named = name != nullptr && name->is(Config::Kind::text) && name->text() == part;
    if (named || std::to_string(i) == part) return &element;
  }
  return nullptr;
}

struct Found {
  Parts path;
  bool written;  ///< the key stands in the scene
};

/// Walks the scene along `pattern`; the last part need not be there.
void walk(const Config& here, const Parts& pattern, const Parts& walked, std::vector<Found>& out) {
  const std::string& part = pattern[walked.size()];
  const auto go = [&](const std::string& name) {
    Parts next = walked;
    next.push_back(name);
    const Config* inner = step_into(here, name);
    if (next.size() == pattern.size()) {
      out.push_back({next, inner != nullptr});
    } else if (inner != nullptr) {
      walk(*inner, pattern, next, out);
    }
  };
  if (part != "*") return go(part);
  for (const std::string& name : members_of(here)) go(name);
}

std::vector<std::string> chosen(const std::vector<Found>& found) {
  const bool any =
      std::any_of(found.begin(), found.end(), [](const Found& f) { return f.written; });
  std::vector<std::string> paths;
  for (const Found& f : found)
    if (f.written || !any) paths.push_back(path_of(f.path));
  return paths;
}

const KnownKnob* known(const std::string& name) {
  for (const KnownKnob& knob : known_knobs())
    if (knob.name == name) return &knob;
  return nullptr;
}

[[noreturn]] void unknown(const std::string& name) {
  std::vector<std::string> names;
  for (const KnownKnob& knob : known_knobs()) names.push_back(knob.name);
  throw Error("", "no knob '" + name + "'." + did_you_mean(name, names),
              "knobs: " + join(names) + "; or the path of a key, such as body.disc.mesh.size");
}

}  // namespace

std::span<const KnownKnob> known_knobs() {
  static const std::vector<KnownKnob> all = {
      {"mesh size", {"body.*.mesh.size"}, "size of the elements of all bodies"},
      {"cells", {"body.*.mesh.cells"}, "cells of structured meshes, [nx, ny]"},
      {"element", {"body.*.mesh.element"}, "kind of element of all bodies"},
      {"step factor", {"run.step_factor"}, "time step as a share of the stable one"},
      {"step", {"run.step"}, "fixed time step"},
      {"mass scaling", {"run.mass_scaling.step"}, "step that mass scaling aims at"},
      {"rest tolerance", {"run.rest.tolerance"}, "when a scene counts as at rest"},
      {"precision", {"run.precision"}, "arithmetic of the loops"},
      {"seed", {"run.seed"}, "seed of everything random"},
      {"alpha",
       {"fracture.*.alpha", "interface.*.alpha", "fractures.*.law.alpha"},
       "share of the strength at which interfaces are inserted"},
      {"interface stiffness",
       {"fracture.*.stiffness_factor", "interface.*.stiffness_factor",
        "fractures.*.law.stiffness_factor", "fractures.*.friction.stiffness_factor"},
       "stiffness of interfaces over that of elements"},
      {"contact stiffness", {"contact.stiffness_factor"}, "stiffness of contact over elements"},
      {"contact damping", {"contact.damping"}, "damping of contact"},
      {"skin", {"contact.skin"}, "reach of the contact search"},
      {"damping", {"material.*.damping"}, "damping of materials"},
      {"fracture size", {"fractures.*.size"}, "size of elements at given fractures"},
  };
  return all;
}

std::vector<std::string> knob_paths(const std::string& key, const Config& scene) {
  const KnownKnob* knob = known(key);
  if (knob == nullptr && key.find('.') == std::string::npos) unknown(key);
  std::vector<Found> found;
  for (const std::string& path : knob != nullptr ? knob->paths : std::vector<std::string>{key}) {
    const Parts pattern = key_path(path);
    const bool plain = std::find(pattern.begin(), pattern.end(), "*") == pattern.end();
    // A section that has only defaults need not be written; those of effects must.
    if (plain && (knob == nullptr || pattern.front() == "run")) {
      found.push_back({pattern, true});
    } else {
      walk(scene, pattern, {}, found);
    }
  }
  const std::vector<std::string> paths = chosen(found);
  if (!paths.empty()) return paths;
  throw Error("", "'" + key + "' fits nothing in this scene",
              knob != nullptr ? "it sets " + join(knob->paths)
                              : "a * stands for the elements of a list, and there are none");
}

double rung_number(const std::string& rung) {
  const bool list = !rung.empty() && rung.front() == '[';
  try {
    if (!list) return parse_quantity(rung).value;
    return 1 / parse_quantity(trimmed(split(rung.substr(1, rung.size() - 2), ',').at(0))).value;
  } catch (const std::exception&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

}  // namespace breccia
