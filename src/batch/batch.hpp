#pragma once

#include "batch/sweep.hpp"

namespace breccia {

/// `breccia batch`: 0 all variants are complete, 1 some are not, 3 some have failed a check.
/// \throws Error (status 2) for what is wrong with the sweep.
int batch_scene(const BatchRequest& request);

}  // namespace breccia
