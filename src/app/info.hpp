#pragma once
#include <string>

namespace breccia {

/// "breccia 0.1.0 (a1b2c3d)".
std::string version_line();

/// What `breccia info` prints: version, compiler, backends, threads, optional parts. Kokkos must be
/// running.
std::string info_text();

}  // namespace breccia
