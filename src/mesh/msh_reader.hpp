#pragma once

#include "mesh/raw_mesh.hpp"

namespace breccia {

/// Whether the file is an ASCII MSH file of version 2.2, 4.0 or 4.1, which `read_msh` takes. Throws
/// Error when the file is missing or is no MSH file at all.
bool is_ascii_msh(const std::string& path);

/// Reads ASCII MSH 2.2 and 4.1 without Gmsh, with the fields of elements ($ElementData).
/// Throws Error with file and line: truncated, numbers that are none, entities that do not exist,
/// elements of other types than simplices of first or second order, fields that contradict
/// themselves.
RawMesh read_msh(const std::string& path);

}  // namespace breccia
