#pragma once

#include <string>
#include <string_view>

namespace breccia {

/// What to do with an output folder that exists already.
enum class ExistingFolder { refuse, overwrite, restart };

/// The folder a run writes into, and the names in it. The constructor makes it and tries whether
/// files can be made in it, so that a run does not discover this at its first frame. Throws Error:
/// exists already (refuse), nothing to restart from (restart), not a folder, no permission, disk
/// full. `overwrite` removes what an earlier run of Breccia wrote and nothing else.
class RunFolder {
 public:
  RunFolder(std::string path, ExistingFolder existing);

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] std::string scene() const { return path_ + "/scene.toml"; }
  [[nodiscard]] std::string history() const { return path_ + "/history.csv"; }
  [[nodiscard]] std::string events() const { return path_ + "/events.csv"; }
  [[nodiscard]] std::string emissions() const { return path_ + "/emissions.csv"; }
  [[nodiscard]] std::string fragments() const { return path_ + "/fragments.csv"; }
  [[nodiscard]] std::string checkpoint() const { return checkpoint_in(path_); }
  [[nodiscard]] static std::string checkpoint_in(const std::string& path) {
    return path + "/checkpoint.h5";
  }
  [[nodiscard]] std::string report() const { return path_ + "/report.json"; }

  /// Writes the resolved scene. Throws Error.
  void write_scene(std::string_view text) const;

 private:
  void empty() const;
  void make() const;

  std::string path_;
};

}  // namespace breccia
