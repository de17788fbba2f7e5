#pragma once
#include "core/config.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace breccia {

/// The scene file for what the user named: a file, or a folder with a scene.toml in it.
/// \throws Error when there is none.
std::filesystem::path find_scene_file(const std::filesystem::path& named);

/// Reads a scene and applies `--set key.path=value` options in order. A value is read as TOML; a
/// bare word or a quantity (`--set run.duration=2 ms`) is taken as text.
/// \throws Error with file and line when the file is not TOML, or an option makes no sense.
Config read_scene(const std::filesystem::path& file, const std::vector<std::string>& options = {});

/// The same for a text; `name` stands for the file in messages.
Config read_scene_text(const std::string& text, const std::string& name,
                       const std::vector<std::string>& options = {});

}  // namespace breccia
