#include "io/hdf5_handle.hpp"

#if BRECCIA_WITH_HDF5

#include <algorithm>
#include <cstdlib>

namespace breccia::h5 {
namespace {

struct Stack {
  int code = 0;        // errno, when a system call failed
  std::string detail;  // deepest message
};

herr_t visit(unsigned, const H5E_error2_t* error, void* data) {
  auto& stack = *static_cast<Stack*>(data);
  const std::string text = error->desc != nullptr ? error->desc : "";
  const std::string mark = "errno = ";
  if (const auto at = text.find(mark); at != std::string::npos && stack.code == 0) {
    stack.code = std::atoi(text.c_str() + at + mark.size());
  }
  if (stack.detail.empty()) stack.detail = text;
  return 0;
}

}  // namespace

void keep_quiet() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Error stack_error(const std::string& path, const std::string& doing) {
  Stack stack;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, visit, &stack);
  H5Eclear2(H5E_DEFAULT);
  if (stack.code != 0) return file_error(path, doing, stack.code);
  const auto says = [&](const char* words) {
    return stack.detail.find(words) != std::string::npos;
  };
  const std::string cannot = "cannot " + doing + ": ";
  if (says("signature")) return {path, cannot + "this is no HDF5 file", "give the right file"};
  if (says("truncated") || says("eof")) {
    return {path, cannot + "the file is truncated (" + stack.detail + ")",
            "copy or write it again; the missing end cannot be recovered"};
  }
  return {path, cannot + "HDF5 says: " + stack.detail, "the file may be damaged; write it again"};
}

Handle serial_access(const std::string& path) {
  Handle list(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  if (list < 0 || H5Pset_fclose_degree(list, H5F_CLOSE_STRONG) < 0 ||
      H5Pset_file_locking(list, false, true) < 0) {
    throw stack_error(path, "set up HDF5");
  }
  return list;
}

hid_t file_type(DataType type) {
  switch (type) {
    case DataType::f64:
      return H5T_IEEE_F64LE;
    case DataType::f32:
      return H5T_IEEE_F32LE;
    case DataType::i32:
      return H5T_STD_I32LE;
    case DataType::i64:
      return H5T_STD_I64LE;
    case DataType::u8:
      return H5T_STD_U8LE;
    case DataType::u64:
      return H5T_STD_U64LE;
  }
  return -1;
}

hid_t memory_type(DataType type) {
  switch (type) {
    case DataType::f64:
      return H5T_NATIVE_DOUBLE;
    case DataType::f32:
      return H5T_NATIVE_FLOAT;
    case DataType::i32:
      return H5T_NATIVE_INT32;
    case DataType::i64:
      return H5T_NATIVE_INT64;
    case DataType::u8:
      return H5T_NATIVE_UINT8;
    case DataType::u64:
      return H5T_NATIVE_UINT64;
  }
  return -1;
}

Handle text_type(std::size_t length) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, std::max<std::size_t>(length, 1));  // HDF5 knows no empty text
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  return type;
}

}  // namespace breccia::h5

#endif
