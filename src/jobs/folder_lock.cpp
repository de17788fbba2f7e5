#include "jobs/folder_lock.hpp"

#include "core/error.hpp"
#include "io/aside_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

namespace breccia {

FolderLock::FolderLock(const std::filesystem::path& folder, Hold hold) {
  std::filesystem::create_directories(folder);
  const std::string name = (folder / "lock").string();
  constexpr mode_t readable = 0644;
  // Without O_CLOEXEC: programs inherit it.
  file_ = open(name.c_str(), O_RDWR | O_CREAT, readable);
  if (file_ < 0) throw file_error(name, "create", errno);
  const int operation = hold == Hold::alone ? LOCK_EX : LOCK_SH;
  if (flock(file_, operation | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  close(file_);
  throw Error(folder.string(), "another breccia runs jobs in this folder",
              "wait for its end, or choose another folder with --output");
}

FolderLock::~FolderLock() {
  close(file_);
}

}  // namespace breccia
