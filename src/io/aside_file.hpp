#pragma once

#include "core/error.hpp"

#include <string>
#include <string_view>

namespace breccia {

/// The Error of a failed system call on a file: `doing` is what was tried ("write", "create
/// folder"), `code` is errno. Causes users meet (disk full, no permission, no such folder) get a
/// remedy of their own.
Error file_error(const std::string& path, std::string_view doing, int code);

/// A file that comes into being whole or not at all: it is written under `part()`, then renamed to
/// its name. An older file of that name stays until then. What is not published is removed when the
/// object goes.
class AsideFile {
 public:
  explicit AsideFile(std::string target) : target_(std::move(target)), part_(target_ + ".part") {}
  ~AsideFile();
  AsideFile(const AsideFile&) = delete;
  AsideFile& operator=(const AsideFile&) = delete;

  [[nodiscard]] const std::string& target() const { return target_; }
  [[nodiscard]] const std::string& part() const { return part_; }

  /// Creates the part with this content. Throws Error (no folder, no permission, disk full).
  void write(std::string_view content);
  /// Forces what lies under `part()` to the disk. Throws Error.
  void sync();
  /// Renames the part to the target and makes the renaming durable. Call `sync` before. Throws
  /// Error.
  void publish();

 private:
  std::string target_, part_;
  bool published_ = false;
};

/// Writes a whole text file, or leaves the old one as it was. Throws Error.
void write_whole(const std::string& path, std::string_view content);

}  // namespace breccia
