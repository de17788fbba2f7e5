#include "io/hdf5_handle.hpp"

#if BRECCIA_WITH_HDF5

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <stdexcept>

namespace breccia {
namespace {

using h5::Handle;

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

bool put_attribute(hid_t file, const std::string& object, const std::string& name, hid_t stored,
                   hid_t native, hid_t space, const void* data) {
  const Handle owner(H5Oopen(file, object.empty() ? "/" : object.c_str(), H5P_DEFAULT), H5Oclose);
  if (owner < 0) return false;
  const Handle attribute(H5Acreate2(owner, name.c_str(), stored, space, H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose);
  return attribute >= 0 && H5Awrite(attribute, native, data) >= 0;
}

std::string attribute_words(const std::string& object, const std::string& name) {
  return "write attribute '" + name + "' of '" + object + "'";
}

}  // namespace

H5Writer::H5Writer(const std::string& path, std::size_t user_block) : aside_(path) {
  h5::keep_quiet();
  disk_.descriptor = ::open(part().c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (disk_.descriptor < 0) throw file_error(path, "create the file", errno);
  const Handle access = h5::serial_access(path);
  const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  if (h5::set_driver(access, disk_) && H5Pset_userblock(creation, user_block) >= 0) {
    file_ = H5Fcreate(part().c_str(), H5F_ACC_TRUNC, creation, access);
  }
  if (file_ >= 0 && disk_.error == 0) return;
  const Error error = trouble("create the file");
  abandon();  // the destructor of an object that was never made does not run
  throw error;
}

H5Writer::~H5Writer() {
  abandon();
}

void H5Writer::abandon() {
  if (disk_.error == 0) disk_.error = ECANCELED;  // nothing more needs to be written
  if (file_ >= 0) H5Fclose(std::exchange(file_, -1));
  if (disk_.descriptor >= 0) ::close(std::exchange(disk_.descriptor, -1));
  H5Eclear2(H5E_DEFAULT);
}

Error H5Writer::trouble(const std::string& doing) const {
  if (disk_.error != 0) return file_error(aside_.target(), "write", disk_.error);
  return h5::stack_error(aside_.target(), doing);
}

void H5Writer::check(bool done, const std::string& doing) const {
  if (!done || disk_.error != 0) throw trouble(doing);
}

void H5Writer::group(const std::string& name) {
  const Handle links = with_groups();
  const Handle made(H5Gcreate2(file_, name.c_str(), links, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  check(made >= 0, "create group '" + name + "'");
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
  check(written, "write data set '" + name + "'");
}

void H5Writer::write_text(const std::string& name, std::string_view text) {
  const std::string padded = text.empty() ? std::string(1, '\0') : std::string(text);
  const Handle type = h5::text_type(text.size()), space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle links = with_groups(), creation = timeless_list();
  const Handle set(H5Dcreate2(file_, name.c_str(), type, space, links, creation, H5P_DEFAULT),
                   H5Dclose);
  const bool written =
      set >= 0 && H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, padded.data()) >= 0;
  check(written, "write text '" + name + "'");
}

void H5Writer::attribute(const std::string& object, const std::string& name,
                         std::string_view text) {
  const std::string padded = text.empty() ? std::string(1, '\0') : std::string(text);
  const Handle type = h5::text_type(text.size()), space(H5Screate(H5S_SCALAR), H5Sclose);
  check(put_attribute(file_, object, name, type, type, space, padded.data()),
        attribute_words(object, name));
}

void H5Writer::attribute(const std::string& object, const std::string& name,
                         std::span<const std::int64_t> values) {
  const hsize_t count = values.size();
  const Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose);
  check(put_attribute(file_, object, name, H5T_STD_I64LE, H5T_NATIVE_INT64, space, values.data()),
        attribute_words(object, name));
}

void H5Writer::attribute(const std::string& object, const std::string& name, double value) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  check(put_attribute(file_, object, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, space, &value),
        attribute_words(object, name));
}

void H5Writer::seal() {
  if (file_ < 0) return;
  check(H5Fclose(std::exchange(file_, -1)) >= 0, "close the file");
  if (::fsync(disk_.descriptor) != 0 && errno != EINVAL) {
    throw file_error(aside_.target(), "write to the disk", errno);
  }
  ::close(std::exchange(disk_.descriptor, -1));
}

void H5Writer::commit() {
  seal();
  aside_.sync();  // whatever the owner wrote into the user block after sealing
  aside_.publish();
}

}  // namespace breccia

#endif
