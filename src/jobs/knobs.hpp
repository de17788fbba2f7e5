#pragma once

#include "core/config.hpp"

#include <span>
#include <string>
#include <vector>

namespace breccia {

/// A knob that has a name: "mesh size" is the size of all bodies.
struct KnownKnob {
  std::string name;
  std::vector<std::string> paths;  ///< of keys; * stands for all of a list
  std::string doc;
};

std::span<const KnownKnob> known_knobs();

/// The paths that a knob sets: those of a known knob, or the path itself, with each *
/// replaced by every element that writes the key, or else by every one that has the section.
/// \throws Error with an empty place when the knob is unknown (nearest named), or fits nothing.
std::vector<std::string> knob_paths(const std::string& key, const Config& scene);

/// A rung as a number: a quantity in SI; of a list of cells, one over the first; not-a-number for
/// words.
double rung_number(const std::string& rung);

}  // namespace breccia
