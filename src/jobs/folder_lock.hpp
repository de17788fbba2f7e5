#pragma once

#include <filesystem>

namespace breccia {

/// Holds a folder while it lives, so that two commands do not run the same jobs in it. Programs
/// that are started meanwhile hold it as well: it is free when the last of them has ended. Where a
/// file system knows no locks nobody is refused.
class FolderLock {
 public:
  enum class Hold { alone, with_others };

  /// \throws Error when somebody else holds the folder.
  FolderLock(const std::filesystem::path& folder, Hold hold);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int file_;
};

}  // namespace breccia
