#include "io/hdf5_handle.hpp"

#if BRECCIA_WITH_HDF5

#include <array>

namespace breccia {
namespace {

using h5::Handle;

Handle open_set(hid_t file, const std::string& path, const std::string& name) {
  Handle set(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose);
  if (set < 0) {
    H5Eclear2(H5E_DEFAULT);
    throw Error(path, "there is no data set '" + name + "'",
                "the file comes from another program or version");
  }
  return set;
}

// The number type of a stored type, or false when it is none of ours (text, compound, 16 bits).
bool known_type(hid_t stored, DataType& type) {
  for (const DataType t :
       {DataType::f64, DataType::f32, DataType::i32, DataType::i64, DataType::u8, DataType::u64}) {
    const Handle native(H5Tget_native_type(stored, H5T_DIR_ASCEND), H5Tclose);
    if (native >= 0 && H5Tequal(native, h5::memory_type(t)) > 0) {
      type = t;
      return true;
    }
  }
  H5Eclear2(H5E_DEFAULT);
  return false;
}

std::vector<std::size_t> shape_of(hid_t space) {
  const int rank = H5Sget_simple_extent_ndims(space);
  std::vector<hsize_t> extent(rank > 0 ? static_cast<std::size_t>(rank) : 0);
  if (rank > 0) H5Sget_simple_extent_dims(space, extent.data(), nullptr);
  return {extent.begin(), extent.end()};
}

Handle open_attribute(hid_t file, const std::string& path, const std::string& object,
                      const std::string& name) {
  Handle attribute(H5Aopen_by_name(file, object.empty() ? "/" : object.c_str(), name.c_str(),
                                   H5P_DEFAULT, H5P_DEFAULT),
                   H5Aclose);
  if (attribute < 0) {
    H5Eclear2(H5E_DEFAULT);
    throw Error(path, "there is no attribute '" + name + "' at '" + object + "'",
                "the file comes from another program or version");
  }
  return attribute;
}

// Fixed-length text of a data set or attribute; `get` reads it with the given type.
template <class Get>
std::string fixed_text(const Handle& type, const std::string& path, const std::string& name,
                       Get get) {
  if (type < 0 || H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) > 0) {
    throw Error(path, "'" + name + "' is not a text of fixed length");
  }
  std::string text(H5Tget_size(type), '\0');
  if (get(type, text.data()) < 0) throw h5::stack_error(path, "read text '" + name + "'");
  text.resize(text.find_last_not_of('\0') + 1);
  return text;
}

}  // namespace

H5Reader::H5Reader(const std::string& path) : path_(path) {
  h5::keep_quiet();
  const Handle access = h5::serial_access(path);
  file_ = H5Fopen(path.c_str(), H5F_ACC_RDONLY, access);
  if (file_ < 0) throw h5::stack_error(path, "open the file");
}

H5Reader::~H5Reader() {
  if (file_ >= 0) H5Fclose(file_);
}

bool H5Reader::has(const std::string& name) const {
  // H5Lexists wants every group on the way to exist, so ask along the path.
  for (std::size_t at = name.find('/', 1);; at = name.find('/', at + 1)) {
    if (H5Lexists(file_, name.substr(0, at).c_str(), H5P_DEFAULT) <= 0) {
      H5Eclear2(H5E_DEFAULT);
      return false;
    }
    if (at == std::string::npos) return true;
  }
}

std::vector<std::string> H5Reader::names(const std::string& group) const {
  const Handle open(H5Gopen2(file_, group.empty() ? "/" : group.c_str(), H5P_DEFAULT), H5Gclose);
  std::vector<std::string> found;
  const auto add = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  if (open < 0 || H5Literate(open, H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &found) < 0) {
    throw h5::stack_error(path_, "list group '" + group + "'");
  }
  return found;
}

ArrayInfo H5Reader::info(const std::string& name) const {
  const Handle set = open_set(file_, path_, name);
  const Handle space(H5Dget_space(set), H5Sclose), stored(H5Dget_type(set), H5Tclose);
  ArrayInfo info;
  if (!known_type(stored, info.type)) {
    throw Error(path_,
                "data set '" + name + "' does not hold numbers of a type that Breccia writes");
  }
  info.shape = shape_of(space);
  return info;
}

void H5Reader::read(const std::string& name, DataType type, void* target) const {
  const ArrayInfo stored = info(name);
  if (stored.type != type) {
    throw Error(path_, "data set '" + name + "' holds " + std::string(name_of(stored.type)) +
                           ", not " + std::string(name_of(type)));
  }
  if (stored.count() == 0) return;
  const Handle set = open_set(file_, path_, name);
  if (H5Dread(set, h5::memory_type(type), H5S_ALL, H5S_ALL, H5P_DEFAULT, target) < 0) {
    throw h5::stack_error(path_, "read data set '" + name + "'");
  }
}

std::string H5Reader::read_text(const std::string& name) const {
  const Handle set = open_set(file_, path_, name), type(H5Dget_type(set), H5Tclose);
  return fixed_text(type, path_, name, [&](hid_t t, char* text) {
    return H5Dread(set, t, H5S_ALL, H5S_ALL, H5P_DEFAULT, text);
  });
}

bool H5Reader::has_attribute(const std::string& object, const std::string& name) const {
  const char* owner = object.empty() ? "/" : object.c_str();
  const bool found = H5Aexists_by_name(file_, owner, name.c_str(), H5P_DEFAULT) > 0;
  H5Eclear2(H5E_DEFAULT);
  return found;
}

std::string H5Reader::text_attribute(const std::string& object, const std::string& name) const {
  const Handle attribute = open_attribute(file_, path_, object, name);
  const Handle type(H5Aget_type(attribute), H5Tclose);
  return fixed_text(type, path_, name,
                    [&](hid_t t, char* text) { return H5Aread(attribute, t, text); });
}

std::vector<std::int64_t> H5Reader::integer_attribute(const std::string& object,
                                                      const std::string& name) const {
  const Handle attribute = open_attribute(file_, path_, object, name);
  const Handle space(H5Aget_space(attribute), H5Sclose);
  std::vector<std::int64_t> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  if (H5Aread(attribute, H5T_NATIVE_INT64, values.data()) < 0) {
    throw h5::stack_error(path_, "read attribute '" + name + "'");
  }
  return values;
}

double H5Reader::real_attribute(const std::string& object, const std::string& name) const {
  const Handle attribute = open_attribute(file_, path_, object, name);
  const Handle space(H5Aget_space(attribute), H5Sclose);
  double value = 0;
  if (H5Sget_simple_extent_npoints(space) != 1 ||
      H5Aread(attribute, H5T_NATIVE_DOUBLE, &value) < 0) {
    throw Error(path_, "attribute '" + name + "' of '" + object + "' is not one number");
  }
  return value;
}

}  // namespace breccia

#endif
