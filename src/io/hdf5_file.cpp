#include "io/hdf5_file.hpp"

namespace breccia {

bool hdf5_available() {
  return BRECCIA_WITH_HDF5 != 0;
}

void require_hdf5(const std::string& path) {
  if (hdf5_available()) return;
  throw Error(
      path,
      "this build of Breccia has no HDF5, so frames, checkpoints and HDF5 meshes cannot be used",
      "install HDF5 (Debian: libhdf5-dev) and configure again, or switch frames and checkpoints "
      "off");
}

#if !BRECCIA_WITH_HDF5

// Constructing a writer or reader throws, so no other member is ever reached; they exist to be
// linked.
H5Writer::H5Writer(const std::string& path, std::size_t) : aside_(path) {
  require_hdf5(path);
}
H5Writer::~H5Writer() = default;
void H5Writer::group(const std::string&) {}
void H5Writer::write(const std::string&, const ArrayView&, const H5Storage&) {}
void H5Writer::write_text(const std::string&, std::string_view) {}
void H5Writer::attribute(const std::string&, const std::string&, std::string_view) {}
void H5Writer::attribute(const std::string&, const std::string&, std::span<const std::int64_t>) {}
void H5Writer::attribute(const std::string&, const std::string&, double) {}
void H5Writer::seal() {}
void H5Writer::commit() {}
void H5Writer::abandon() {}
void H5Writer::check(bool, const std::string&) const {}
Error H5Writer::trouble(const std::string&) const {
  return {{}, {}};
}

H5Reader::H5Reader(const std::string& path) : path_(path) {
  require_hdf5(path);
}
H5Reader::~H5Reader() = default;
bool H5Reader::has(const std::string&) const {
  return false;
}
std::vector<std::string> H5Reader::names(const std::string&) const {
  return {};
}
ArrayInfo H5Reader::info(const std::string&) const {
  return {};
}
void H5Reader::read(const std::string&, DataType, void*) const {}
std::string H5Reader::read_text(const std::string&) const {
  return {};
}
bool H5Reader::has_attribute(const std::string&, const std::string&) const {
  return false;
}
std::string H5Reader::text_attribute(const std::string&, const std::string&) const {
  return {};
}
std::vector<std::int64_t> H5Reader::integer_attribute(const std::string&,
                                                      const std::string&) const {
  return {};
}
double H5Reader::real_attribute(const std::string&, const std::string&) const {
  return 0;
}

#endif

}  // namespace breccia
