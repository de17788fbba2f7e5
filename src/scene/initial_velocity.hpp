#pragma once
#include "core/settings.hpp"
#include "step/model.hpp"

#include <vector>

namespace breccia {

/// Velocity of every node at t = 0, (node, D), m/s: that of its body, the body's spin and expansion
/// about its centre of mass, and what it has towards a place. Each copy of a body has a centre of
/// its own. Empty when nothing moves.
template <int D>
std::vector<double> initial_velocity(const Settings& scene, const Model<D>& model);

}  // namespace breccia
