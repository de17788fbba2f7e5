#pragma once
#include "core/schema.hpp"

namespace breccia {

/// The keys of [[body]], its shape and its mesh.
void declare_body_keys(Schema& schema);

/// The keys of [[fractures]] but for their laws.
void declare_fracture_shape_keys(Schema& schema);

/// The keys of [material.NAME] with its laws.
void declare_material_keys(Schema& schema);

/// The keys of what acts on bodies: [gravity], [[boundary]], [[initial_stress]].
void declare_load_keys(Schema& schema);

/// The keys of [study].
void declare_study_keys(Schema& schema);

/// The keys of [batch].
void declare_batch_keys(Schema& schema);

/// A vector that is to be a direction must not be zero.
void check_direction(const Settings& section, const char* key, Problems& problems);

// Rules between several keys; each adds what it finds wrong to `problems`.
void check_run_rules(const Settings& scene, Problems& problems);
void check_body_rules(const Settings& scene, Problems& problems);
void check_fracture_rules(const Settings& scene, Problems& problems);
void check_load_rules(const Settings& scene, Problems& problems);
void check_material_rules(const Settings& scene, Problems& problems);
void check_study_rules(const Settings& scene, Problems& problems);
void check_batch_rules(const Settings& scene, Problems& problems);

}  // namespace breccia
