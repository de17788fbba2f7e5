#pragma once

#include <string_view>

namespace breccia {

/// What this executable was built from and with; `breccia info` prints it and every report.json
/// carries it.
struct BuildInfo {
  std::string_view version;
  std::string_view commit;  // short hash, with "+" when the tree had changes; "unknown" outside git
  std::string_view compiler;
  std::string_view build_type;
  std::string_view arch;
  std::string_view flags;
  std::string_view kokkos;
  std::string_view mpi;  // name and version of an optional part, or "off"
  std::string_view hdf5;
  std::string_view metis;
  std::string_view gmsh;
};

const BuildInfo& build_info();

}  // namespace breccia
