#pragma once

#include "io/array_view.hpp"
#include "io/hdf5_file.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace breccia {

/// What a checkpoint belongs to. Bit-for-bit restart is promised only for the same scene on the
/// same build, so both are compared.
struct CheckpointIdentity {
  std::string scene;  ///< fingerprint of the resolved scene
  std::string build;  ///< commit, compiler, backend, precision
};

/// A whole state as named arrays, numbers and texts. The file is HDF5 behind 512 bytes of readable
/// header that hold the format, the length and a checksum of all the rest, so that truncation and
/// damage are found before HDF5 sees the file. It replaces the older checkpoint only when it is
/// whole on the disk. Throws Error.
class CheckpointWriter {
 public:
  CheckpointWriter(const std::string& path, const CheckpointIdentity& identity);

  void put(const std::string& name, const ArrayView& array);
  template <class Range>
  void put(const std::string& name, const Range& values, std::vector<std::size_t> shape = {}) {
    put(name, view_of(values, std::move(shape)));
  }
  void put_number(const std::string& name, double value);
  void put_number(const std::string& name, std::int64_t value);
  void put_text(const std::string& name, std::string_view text);

  /// All of it on the disk under `<path>.part`; the older checkpoint is still in place.
  void seal();
  /// Seals and replaces the older checkpoint.
  void commit();

 private:
  std::string path_;
  H5Writer file_;
  bool sealed_ = false;
};

/// Reads a checkpoint, bit for bit. The constructor refuses by name a file that is missing,
/// truncated, damaged, no checkpoint at all, of a newer format, of another scene or of another
/// build, each with a remedy (Error).
class CheckpointReader {
 public:
  CheckpointReader(const std::string& path, const CheckpointIdentity& expected);

  [[nodiscard]] bool has(const std::string& name) const { return file_.has("state/" + name); }
  [[nodiscard]] std::vector<std::string> names() const { return file_.names("state"); }
  [[nodiscard]] ArrayInfo info(const std::string& name) const {
    return file_.info("state/" + name);
  }

  /// Throws Error when the array is absent or of another number type.
  template <class T>
  [[nodiscard]] std::vector<T> array(const std::string& name) const {
    return file_.read<T>("state/" + name);
  }
  /// As above into memory of exactly this size; Error when the sizes differ.
  template <class T>
  void array(const std::string& name, std::span<T> target) const {
    check_count(name, target.size());
    file_.read("state/" + name, data_type_of<T>(), target.data());
  }
  [[nodiscard]] double real(const std::string& name) const;
  [[nodiscard]] std::int64_t integer(const std::string& name) const;
  [[nodiscard]] std::string text(const std::string& name) const;

 private:
  void check_count(const std::string& name, std::size_t count) const;

  H5Reader file_;
};

}  // namespace breccia
