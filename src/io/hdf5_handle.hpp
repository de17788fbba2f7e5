#pragma once
// Private to the HDF5 files of this folder: handles that close themselves, and HDF5's errors as
// ours.

#include "io/hdf5_file.hpp"

#if BRECCIA_WITH_HDF5

#include <hdf5.h>

namespace breccia::h5 {

static_assert(sizeof(hid_t) == sizeof(std::int64_t), "HDF5 handles are 64 bits wide since 1.10");

/// A handle with the function that closes it; negative means that the call which should have made
/// it failed.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  Handle& operator=(Handle&&) = delete;
  operator hid_t() const { return id_; }  // NOLINT: HDF5 functions take the number

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// Turns HDF5's own printing of errors off; they come back as Error.
void keep_quiet();

/// Error from HDF5's error stack after a failed call: system errors (disk full) and HDF5's deepest
/// message.
Error stack_error(const std::string& path, const std::string& doing);

/// Access list for one process: no locks, since files are written aside and renamed, and locks fail
/// on some network file systems.
Handle serial_access(const std::string& path);

hid_t file_type(DataType type);    ///< little endian, so that files travel between machines
hid_t memory_type(DataType type);  ///< native
Handle text_type(std::size_t length);

}  // namespace breccia::h5

#endif
