#include "io/aside_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace breccia {
namespace {

std::string remedy_for(int code) {
  switch (code) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      return "free some space, write fewer frames ([output] frames), or choose another folder with "
             "--output";
    case EACCES:
    case EPERM:
    case EROFS:
      return "choose a folder you may write to with --output";
    case ENOENT:
      return "check the path; the folder it names must exist";
    case ENOTDIR:
      return "a part of the path is a file, not a folder; check the path";
    case EMFILE:
    case ENFILE:
      return "too many files are open; raise the limit (ulimit -n)";
    default:
      return {};
  }
}

class OpenFile {
 public:
  OpenFile(const std::string& path, int flags)
      : fd_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
  ~OpenFile() {
    if (fd_ >= 0) ::close(fd_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  [[nodiscard]] int number() const { return fd_; }

 private:
  int fd_;
};

// Some file systems (and pipes) know no fsync and say EINVAL: there is nothing to force then.
bool synced(int fd) {
  return ::fsync(fd) == 0 || errno == EINVAL || errno == ENOTSUP;
}

}  // namespace

Error file_error(const std::string& path, std::string_view doing, int code) {
  const bool full = code == ENOSPC || code == EDQUOT;
  const std::string reason = full ? "the disk is full" : std::strerror(code);
  return {path, "cannot " + std::string(doing) + ": " + reason, remedy_for(code)};
}

AsideFile::~AsideFile() {
  if (!published_) ::unlink(part_.c_str());
}

void AsideFile::write(std::string_view content) {
  const OpenFile file(part_, O_WRONLY | O_CREAT | O_TRUNC);
  if (file.number() < 0) throw file_error(target_, "create the file", errno);
  while (!content.empty()) {
    const ssize_t done = ::write(file.number(), content.data(), content.size());
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) throw file_error(target_, "write", errno);
    content.remove_prefix(static_cast<std::size_t>(done));
  }
}

void AsideFile::sync() {
  const OpenFile file(part_, O_RDONLY);
  if (file.number() < 0) throw file_error(target_, "write", errno);
  if (!synced(file.number())) throw file_error(target_, "write to the disk", errno);
}

void AsideFile::publish() {
  if (std::rename(part_.c_str(), target_.c_str()) != 0) {
    throw file_error(target_, "rename from " + part_, errno);
  }
  published_ = true;
  // The renaming is an entry of the folder: only a synchronised folder survives a loss of power.
  const std::string folder = std::filesystem::path(target_).parent_path().string();
  const OpenFile parent(folder.empty() ? "." : folder, O_RDONLY | O_DIRECTORY);
  if (parent.number() >= 0 && !synced(parent.number())) {
    throw file_error(target_, "write to the disk", errno);
  }
}

void write_whole(const std::string& path, std::string_view content) {
  AsideFile aside(path);
  aside.write(content);
  aside.sync();
  aside.publish();
}

}  // namespace breccia
