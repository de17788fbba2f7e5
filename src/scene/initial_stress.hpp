#pragma once
#include "step/model.hpp"

namespace breccia {

/// The stress that [[initial_stress]] gives each element (constant in an element, taken at its
/// centroid), Pa; empty where the scene has none. Throws Error where two sections claim one
/// element.
template <int D>
std::vector<Sym<3>> initial_stress(const Settings& scene, const Model<D>& model);

}  // namespace breccia
