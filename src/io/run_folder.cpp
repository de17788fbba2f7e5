#include "io/run_folder.hpp"

#include "io/aside_file.hpp"

#include <filesystem>

namespace breccia {
namespace {

namespace fs = std::filesystem;

// Everything a run or tools/plot writes into its folder.
constexpr const char* kOurs[] = {"scene.toml",
                                 "frames",
                                 "frames.vtkhdf.series",
                                 "cracks.vtkhdf.series",
                                 "contacts.vtkhdf.series",
                                 "history.csv",
                                 "events.csv",
                                 "emissions.csv",
                                 "fragments.csv",
                                 "checkpoint.h5",
                                 "report.json",
                                 "pictures"};

bool holds_something(const std::string& path) {
  std::error_code trouble;
  return fs::directory_iterator(path, trouble) != fs::directory_iterator();
}

}  // namespace

RunFolder::RunFolder(std::string path, ExistingFolder existing) : path_(std::move(path)) {
  while (path_.size() > 1 && path_.back() == '/') path_.pop_back();
  std::error_code trouble;
  const fs::file_status status = fs::status(path_, trouble);
  if (fs::exists(status) && !fs::is_directory(status)) {
    throw Error(path_, "the output folder is a file",
                "remove it, or choose another folder with --output");
  }
  if (existing == ExistingFolder::refuse && fs::exists(status) && holds_something(path_)) {
    throw Error(path_, "the output folder exists already",
                "--overwrite replaces the run in it, --restart continues it, --output chooses "
                "another folder");
  }
  if (existing == ExistingFolder::restart && !fs::exists(checkpoint())) {
    throw Error(path_, "there is no checkpoint to restart from (checkpoint.h5)",
                "run without --restart (with --overwrite if the folder holds an earlier run)");
  }
  if (existing == ExistingFolder::overwrite && fs::exists(status)) empty();
  make();
}

void RunFolder::empty() const {
  std::error_code trouble;
  for (const char* name : kOurs) {
    for (const std::string& path : {path_ + "/" + name, path_ + "/" + name + ".part"}) {
      fs::remove_all(path, trouble);
      if (trouble) throw file_error(path, "remove", trouble.value());
    }
  }
}

void RunFolder::make() const {
  std::error_code trouble;
  fs::create_directories(path_, trouble);
  if (trouble) throw file_error(path_, "create the output folder", trouble.value());
  // A probe finds read-only folders and full disks now; a kilobyte, because some full disks still
  // take empty files.
  AsideFile probe(path_ + "/probe");
  probe.write(std::string(1024, '\0'));
  probe.sync();
}

void RunFolder::write_scene(std::string_view text) const {
  write_whole(scene(), text);
}

}  // namespace breccia
