#pragma once

#include <cstdint>

namespace breccia::h5 {

/// An open file descriptor that HDF5 writes through, and the first error that happened there.
///
/// HDF5 cannot survive a failed write: its metadata cache stays in a state in which the file can
/// never be closed, and the library crashes over it at exit. So it is never told of one; the error
/// is kept here, all later writes are swallowed, and the owner of the file looks and throws.
struct WriteState {
  int descriptor = -1;
  int error = 0;  ///< errno of the first failure
};

/// Sets the driver of a file access list to one that creates a file in `state`, which must live as
/// long as the file is open. Returns false when HDF5 refuses.
bool set_driver(std::int64_t access_list, WriteState& state);

}  // namespace breccia::h5
