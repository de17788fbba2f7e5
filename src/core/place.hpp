#pragma once
#include <string>

namespace breccia {

/// Where a value was written: a line of a scene file, a `--set` option, or nowhere (a default).
struct Place {
  std::string file;  ///< scene file as the user named it, "--set" or "default"
  int line = 0;      ///< counted from 1; 0 where there is no line

  /// "disc/scene.toml:41", "--set" or "default".
  [[nodiscard]] std::string text() const {
    return line > 0 ? file + ":" + std::to_string(line) : file;
  }
};

}  // namespace breccia
