#pragma once
#include "core/schema.hpp"

namespace breccia {

/// The keys of [[body]], its shape and its mesh.
void declare_body_keys(Schema& schema);

// Rules between several keys; each adds what it finds wrong to `problems`.
void check_run_rules(const Settings& scene, Problems& problems);
void check_body_rules(const Settings& scene, Problems& problems);
void check_place_rules(const Settings& scene, Problems& problems);

}  // namespace breccia
