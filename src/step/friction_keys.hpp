#pragma once
#include "core/schema.hpp"
#include "core/settings.hpp"
#include "point/friction_law.hpp"

namespace breccia {

// The scene keys of a law of friction, the same for faults and contact: the coefficient at rest,
// which each section declares by a word of its own, and these.

void add_friction_keys(SectionBuilder& section);

/// Keys that the law needs and that are missing, or that it does not have. `coefficient` is the key
/// of the coefficient at rest.
void check_friction(const Settings& friction, const char* coefficient, Problems& problems);

FrictionLaw read_friction(const Settings& friction, const char* coefficient);

/// True where some contact of the scene has another law than Coulomb's: its points remember more.
bool contact_remembers(const Settings& scene);

}  // namespace breccia
