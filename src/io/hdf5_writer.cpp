#include "io/hdf5_handle.hpp"

#if BRECCIA_WITH_HDF5

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <stdexcept>

namespace breccia {
namespace {

using h5::Handle;

// After a failed write (disk full) HDF5 keeps dirty metadata that it can never flush, so the file
// could never be closed and the library would try again at exit. Its descriptor is therefore turned
// to memory before closing; the part on the disk is removed anyway.
void abandon(hid_t file) {
  const Handle access(H5Fget_access_plist(file), H5Pclose);
  void* driver = nullptr;
  if (H5Fget_vfd_handle(file, access, &driver) >= 0 && driver != nullptr) {
    const int memory = ::memfd_create("breccia", MFD_CLOEXEC);
    if (memory >= 0) {
      ::dup2(memory, *static_cast<int*>(driver));
      ::close(memory);
    }
  }
  H5Fclose(file);
  H5Eclear2(H5E_DEFAULT);
}

// Without the time of writing, so that equal content gives equal files.
Handle timeless_list() {
  Handle list(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(list, false);
  return list;
}

Handle creation_list(const ArrayView& array, const H5Storage& storage) {
  Handle list = timeless_list();
  H5Pset_fill_time(list, H5D_FILL_TIME_NEVER);
  if (storage.deflate <= 0 || array.count() == 0) return list;
  // About a megabyte per chunk: large enough to compress well, small enough for HDF5's chunk cache.
  constexpr std::size_t chunk_bytes = std::size_t{1} << 20;
  std::vector<hsize_t> chunk(array.shape.begin(), array.shape.end());
  const std::size_t row = std::max<std::size_t>(array.bytes() / array.shape[0], 1);
  chunk[0] = std::clamp<hsize_t>(chunk_bytes / row, 1, array.shape[0]);
  H5Pset_chunk(list, static_cast<int>(chunk.size()), chunk.data());
  H5Pset_deflate(list, static_cast<unsigned>(storage.deflate));
  return list;
}

Handle with_groups() {
  Handle list(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(list, 1);
  return list;
}

void put_attribute(hid_t file, const std::string& path, const std::string& object,
                   const std::string& name, hid_t stored, hid_t native, hid_t space,
                   const void* data) {
  const Handle owner(H5Oopen(file, object.empty() ? "/" : object.c_str(), H5P_DEFAULT), H5Oclose);
  const Handle attribute(
      owner < 0 ? -1 : H5Acreate2(owner, name.c_str(), stored, space, H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose);
  if (attribute < 0 || H5Awrite(attribute, native, data) < 0) {
    throw h5::stack_error(path, "write attribute '" + name + "' of '" + object + "'");
  }
}

}  // namespace

H5Writer::H5Writer(const std::string& path, std::size_t user_block) : aside_(path) {
  h5::keep_quiet();
  const Handle access = h5::serial_access(path);
  const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  if (H5Pset_userblock(creation, user_block) < 0)
    throw h5::stack_error(path, "reserve the user block");
  file_ = H5Fcreate(part().c_str(), H5F_ACC_TRUNC, creation, access);
  if (file_ < 0) throw h5::stack_error(path, "create the file");
}

H5Writer::~H5Writer() {
  if (file_ >= 0) abandon(file_);
}

void H5Writer::group(const std::string& name) {
  const Handle links = with_groups();
  const Handle made(H5Gcreate2(file_, name.c_str(), links, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  if (made < 0) throw h5::stack_error(aside_.target(), "create group '" + name + "'");
}

void H5Writer::write(const std::string& name, const ArrayView& array, const H5Storage& storage) {
  if (array.shape.empty())
    throw std::logic_error("H5Writer: data set '" + name + "' without a shape");
  const std::vector<hsize_t> extent(array.shape.begin(), array.shape.end());
  const Handle space(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr),
                     H5Sclose);
  const Handle links = with_groups(), creation = creation_list(array, storage);
  const Handle set(H5Dcreate2(file_, name.c_str(), h5::file_type(array.type), space, links,
                              creation, H5P_DEFAULT),
                   H5Dclose);
  const bool written =
      set >= 0 && (array.count() == 0 || H5Dwrite(set, h5::memory_type(array.type), H5S_ALL,
                                                  H5S_ALL, H5P_DEFAULT, array.data) >= 0);
  if (!written) throw h5::stack_error(aside_.target(), "write data set '" + name + "'");
}

void H5Writer::write_text(const std::string& name, std::string_view text) {
  const std::string padded = text.empty() ? std::string(1, '\0') : std::string(text);
  const Handle type = h5::text_type(text.size()), space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle links = with_groups(), creation = timeless_list();
  const Handle set(H5Dcreate2(file_, name.c_str(), type, space, links, creation, H5P_DEFAULT),
                   H5Dclose);
  if (set < 0 || H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, padded.data()) < 0) {
    throw h5::stack_error(aside_.target(), "write text '" + name + "'");
  }
}

void H5Writer::attribute(const std::string& object, const std::string& name,
                         std::string_view text) {
  const std::string padded = text.empty() ? std::string(1, '\0') : std::string(text);
  const Handle type = h5::text_type(text.size()), space(H5Screate(H5S_SCALAR), H5Sclose);
  put_attribute(file_, aside_.target(), object, name, type, type, space, padded.data());
}

void H5Writer::attribute(const std::string& object, const std::string& name,
                         std::span<const std::int64_t> values) {
  const hsize_t count = values.size();
  const Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose);
  put_attribute(file_, aside_.target(), object, name, H5T_STD_I64LE, H5T_NATIVE_INT64, space,
                values.data());
}

void H5Writer::attribute(const std::string& object, const std::string& name, double value) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  put_attribute(file_, aside_.target(), object, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, space,
                &value);
}

void H5Writer::seal() {
  if (file_ < 0) return;
  // Flushing first keeps the file open on failure, so that it can be abandoned; a failed close
  // could not.
  if (H5Fflush(file_, H5F_SCOPE_GLOBAL) < 0) {
    const Error error = h5::stack_error(aside_.target(), "write");
    abandon(std::exchange(file_, -1));
    throw error;
  }
  if (H5Fclose(std::exchange(file_, -1)) < 0)
    throw h5::stack_error(aside_.target(), "close the file");
  aside_.sync();
}

void H5Writer::commit() {
  seal();
  aside_.publish();
}

}  // namespace breccia

#endif
