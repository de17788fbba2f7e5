#pragma once

#include "core/settings.hpp"

#include <string>

namespace breccia {

/// Changes with anything that changes the result of a scene: its resolved keys, what is in the
/// files that it names, the build of this program, and `more`.
std::string job_identity(const Settings& scene, const std::string& more = {});

}  // namespace breccia
