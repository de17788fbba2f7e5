#include "io/hdf5_driver.hpp"

#if BRECCIA_WITH_HDF5

#include <hdf5.h>

#if H5_VERSION_GE(1, 13, 0)
#include <H5FDdevelop.h>
#endif

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <iterator>

namespace breccia::h5 {
namespace {

// What the access list carries, copied by HDF5 byte for byte.
struct Carried {
  WriteState* state;
};

// HDF5 casts the driver's file from and to its own first member.
struct File {
  H5FD_t common;
  WriteState* state;
  haddr_t space;  ///< end of what HDF5 has allocated
  haddr_t end;    ///< end of what has been written
};

File& as_ours(H5FD_t* file) {
  return *reinterpret_cast<File*>(file);
}
const File& as_ours(const H5FD_t* file) {
  return *reinterpret_cast<const File*>(file);
}

H5FD_t* open_file(const char*, unsigned, hid_t access, haddr_t) {
  const auto* carried = static_cast<const Carried*>(H5Pget_driver_info(access));
  if (carried == nullptr) return nullptr;
  return reinterpret_cast<H5FD_t*>(new File{{}, carried->state, 0, 0});
}

herr_t close_file(H5FD_t* file) {
  delete &as_ours(file);
  return 0;
}

int compare(const H5FD_t* a, const H5FD_t* b) {
  const auto *x = as_ours(a).state, *y = as_ours(b).state;
  return x < y ? -1 : x > y ? 1 : 0;
}

// The same habits as HDF5's own driver for plain files.
herr_t query(const H5FD_t*, unsigned long* features) {
  if (features != nullptr) {
    *features = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA |
                H5FD_FEAT_DATA_SIEVE | H5FD_FEAT_AGGREGATE_SMALLDATA;
  }
  return 0;
}

haddr_t get_space(const H5FD_t* file, H5FD_mem_t) {
  return as_ours(file).space;
}

herr_t set_space(H5FD_t* file, H5FD_mem_t, haddr_t address) {
  as_ours(file).space = address;
  return 0;
}

haddr_t get_end(const H5FD_t* file, H5FD_mem_t) {
  return as_ours(file).end;
}

herr_t get_handle(H5FD_t* file, hid_t, void** handle) {
  *handle = &as_ours(file).state->descriptor;
  return 0;
}

herr_t read_bytes(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t address, size_t size, void* target) {
  WriteState& state = *as_ours(file).state;
  auto* next = static_cast<char*>(target);
  auto place = static_cast<off_t>(address);
  while (size > 0) {
    const ssize_t n = ::pread(state.descriptor, next, size, place);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0 && state.error == 0) state.error = errno;
    if (n <= 0) break;
    next += n;
    place += n;
    size -= static_cast<size_t>(n);
  }
  std::memset(next, 0, size);  // HDF5 takes what lies behind the end as zeros
  return 0;
}

herr_t write_bytes(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t address, size_t size,
                   const void* source) {
  File& ours = as_ours(file);
  WriteState& state = *ours.state;
  const auto* next = static_cast<const char*>(source);
  auto place = static_cast<off_t>(address);
  ours.end = std::max(ours.end, address + size);
  while (size > 0 && state.error == 0) {
    const ssize_t n = ::pwrite(state.descriptor, next, size, place);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) {
      state.error = errno;
      break;
    }
    next += n;
    place += n;
    size -= static_cast<size_t>(n);
  }
  return 0;
}

herr_t truncate_file(H5FD_t* file, hid_t, hbool_t) {
  File& ours = as_ours(file);
  WriteState& state = *ours.state;
  if (ours.space == ours.end) return 0;
  if (state.error == 0 && ::ftruncate(state.descriptor, static_cast<off_t>(ours.space)) != 0) {
    state.error = errno;
  }
  ours.end = ours.space;
  return 0;
}

H5FD_class_t make_class() {
  H5FD_class_t driver{};
#if H5_VERSION_GE(1, 13, 0)
  driver.version = H5FD_CLASS_VERSION;
  driver.value = static_cast<H5FD_class_value_t>(H5_VFD_RESERVED + 77);
#endif
  driver.name = "breccia";
  driver.maxaddr = static_cast<haddr_t>(1) << 62;
  driver.fc_degree = H5F_CLOSE_STRONG;
  driver.fapl_size = sizeof(Carried);
  driver.open = open_file;
  driver.close = close_file;
  driver.cmp = compare;
  driver.query = query;
  driver.get_eoa = get_space;
  driver.set_eoa = set_space;
  driver.get_eof = get_end;
  driver.get_handle = get_handle;
  driver.read = read_bytes;
  driver.write = write_bytes;
  driver.truncate = truncate_file;
  const H5FD_mem_t map[H5FD_MEM_NTYPES] = H5FD_FLMAP_DICHOTOMY;
  std::copy(std::begin(map), std::end(map), std::begin(driver.fl_map));
  return driver;
}

}  // namespace

bool set_driver(std::int64_t access_list, WriteState& state) {
  static const H5FD_class_t driver = make_class();
  static const hid_t registered = H5FDregister(&driver);
  const Carried carried = {&state};
  return registered >= 0 && H5Pset_driver(access_list, registered, &carried) >= 0;
}

}  // namespace breccia::h5

#endif
