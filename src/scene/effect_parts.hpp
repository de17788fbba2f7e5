#pragma once
#include "step/model.hpp"

#include <string>
#include <vector>

namespace breccia {

/// What a scene pays for within an effect: its time is in that of the effect.
struct EffectPart {
  std::string effect, name, why;
  std::size_t bytes = 0;  ///< of those of the effect
};

/// The parts that a model has, in no order among effects.
template <int D>
std::vector<EffectPart> parts_of(const Model<D>& model);

}  // namespace breccia
