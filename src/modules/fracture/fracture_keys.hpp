#pragma once
#include "core/schema.hpp"

namespace breccia {

/// Strength, energies and springs of faces.
void add_law_keys(SectionBuilder section);

/// stiffness_factor and damping.
void add_spring_keys(SectionBuilder& section);

}  // namespace breccia
