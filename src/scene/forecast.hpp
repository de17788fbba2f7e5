#pragma once
#include "scene/effect_parts.hpp"
#include "scene/simulation.hpp"

#include <string>
#include <vector>

namespace breccia {

/// What a run would cost, effect by effect, under the names and in the order of its report.
struct Forecast {
  struct Effect {
    std::string name;
    bool on = true;
    std::string why;
    std::size_t bytes = 0;
    double seconds = 0;
    std::vector<EffectPart> parts;
  };
  std::vector<Effect> effects;
  double steps = 0;
  int measured = 0;  ///< steps that the seconds were measured over
  double disk = 0;   ///< bytes that files would have, before compression

  double seconds() const;
};

/// Makes steps of the simulation for `budget` seconds, two at least, and multiplies: what has not
/// begun yet (cracks, contacts, plastic flow) is not in it. Writes nothing.
template <int D>
Forecast forecast(Simulation<D>& simulation, double budget);

/// What may make the run dearer than its forecast, one sentence each.
std::vector<std::string> unforeseen(const Settings& scene, const std::vector<EffectPart>& parts);

}  // namespace breccia
