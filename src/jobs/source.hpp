#pragma once

#include "core/config.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace breccia {

/// A scene with the section that says what to make of it, [study] or [batch]. The section may stand
/// in a file of its own that names its scene.
class SceneSource {
 public:
  using Options = std::vector<std::string>;

  /// `options` are those of --set; those of the section go to it, the others to every job.
  /// \throws Error when there is no such section, or its file holds more than it while it names
  /// another scene.
  SceneSource(std::string section, const std::filesystem::path& named, const Options& options);

  /// The scene with the options of a job; without [study] and [batch].
  [[nodiscard]] Config read(const Options& options) const;
  /// The scene with the section, to be resolved once.
  [[nodiscard]] Config whole() const;

  [[nodiscard]] Config& section() { return about_; }
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }    ///< of the section
  [[nodiscard]] const std::filesystem::path& scene() const { return scene_; }  ///< that jobs run
  [[nodiscard]] const Options& shared() const { return shared_; }  ///< of every job, for --set

  /// What results are named after: the file, or its folder where it is a scene.toml.
  [[nodiscard]] std::string name() const;

 private:
  void refer(const Config& own, const Config& named);
  void add_set();

  std::string word_;
  std::filesystem::path file_, scene_;
  Config about_;
  Options shared_;
};

}  // namespace breccia
