#pragma once

#include "mesh/mesh.hpp"

#include <string>

namespace breccia {

/// Writes a mesh as HDF5: points, elements, bodies, regions, and the attributes "format" and
/// "version". Written beside the target and renamed, so that a file of this name is always whole.
/// Throws Error (unwritable folder, full disk); nothing is left behind then.
template <int D>
void write_mesh(const Mesh<D>& mesh, const std::string& path);

/// Reads back what `write_mesh` wrote, bit for bit. Throws Error naming the file: missing, not
/// HDF5, not a Breccia mesh, of another dimension or a newer version, truncated or with sizes or
/// numbers that do not fit together.
template <int D>
Mesh<D> read_mesh(const std::string& path);

/// Whether the file starts like HDF5 (to choose the reader of a mesh file).
bool looks_like_hdf5(const std::string& path);

}  // namespace breccia
