#pragma once

#include "io/array_view.hpp"
#include "io/aside_file.hpp"
#include "io/hdf5_driver.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace breccia {

/// Whether this build can read and write HDF5. Without it every function below throws Error that
/// says so.
bool hdf5_available();

/// Throws Error naming `path` and how to get a build with HDF5, unless `hdf5_available()`.
void require_hdf5(const std::string& path);

/// How a data set is stored. Contiguous by default; a deflate level of 1..9 stores it in compressed
/// chunks.
struct H5Storage {
  int deflate = 0;
};

/// Writes one HDF5 file whole or not at all. Names are paths ("VTKHDF/PointData/velocity"); missing
/// groups are made. Every failure throws Error with the file and the cause; the target is then as
/// it was and the part is gone.
class H5Writer {
 public:
  /// `user_block`: bytes kept free at the start of the file for the caller (0 or a power of two
  /// from 512).
  explicit H5Writer(const std::string& path, std::size_t user_block = 0);
  ~H5Writer();
  H5Writer(const H5Writer&) = delete;
  H5Writer& operator=(const H5Writer&) = delete;

  void group(const std::string& name);
  void write(const std::string& name, const ArrayView& array, const H5Storage& storage = {});
  /// Scalar data set of fixed-length text.
  void write_text(const std::string& name, std::string_view text);

  /// Attributes of a group or data set that exists ("" or "/" is the file). Text is fixed-length,
  /// as VTK demands.
  void attribute(const std::string& object, const std::string& name, std::string_view text);
  void attribute(const std::string& object, const std::string& name,
                 std::span<const std::int64_t> values);
  void attribute(const std::string& object, const std::string& name, double value);

  /// Closes the HDF5 file; all is on the disk under `part()` afterwards, and nothing more can be
  /// written.
  void seal();
  /// Seals, and gives the file its name.
  void commit();
  [[nodiscard]] const std::string& part() const { return aside_.part(); }

 private:
  void abandon();
  void check(bool done, const std::string& doing) const;
  [[nodiscard]] Error trouble(const std::string& doing) const;

  AsideFile aside_;
  h5::WriteState disk_;
  std::int64_t file_ = -1;  ///< HDF5 handle; -1 when closed
};

/// Reads an HDF5 file. Every failure throws Error with the file and the cause (missing, no HDF5,
/// truncated, no such data set, other type).
class H5Reader {
 public:
  explicit H5Reader(const std::string& path);
  ~H5Reader();
  H5Reader(const H5Reader&) = delete;
  H5Reader& operator=(const H5Reader&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] bool has(const std::string& name) const;
  /// Names of the members of a group, in alphabetical order.
  [[nodiscard]] std::vector<std::string> names(const std::string& group) const;
  [[nodiscard]] ArrayInfo info(const std::string& name) const;
  [[nodiscard]] std::string read_text(const std::string& name) const;
  /// Reads into memory of `info(name).bytes()` bytes; `type` must be the stored one.
  void read(const std::string& name, DataType type, void* target) const;

  template <class T>
  [[nodiscard]] std::vector<T> read(const std::string& name) const {
    std::vector<T> values(info(name).count());
    read(name, data_type_of<T>(), values.data());
    return values;
  }

  [[nodiscard]] bool has_attribute(const std::string& object, const std::string& name) const;
  [[nodiscard]] std::string text_attribute(const std::string& object,
                                           const std::string& name) const;
  [[nodiscard]] std::vector<std::int64_t> integer_attribute(const std::string& object,
                                                            const std::string& name) const;
  [[nodiscard]] double real_attribute(const std::string& object, const std::string& name) const;

 private:
  std::string path_;
  std::int64_t file_ = -1;
};

}  // namespace breccia
