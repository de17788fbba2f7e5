#pragma once
#include "core/settings.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace breccia {

/// A scene that has been read and found right.
struct Scene {
  Settings settings;
  std::filesystem::path folder;  ///< where its files lie
  std::string name;              ///< "brazilian_disc" of brazilian_disc/scene.toml or .toml
  int dimension() const { return static_cast<int>(settings.at("run").integer("dimension")); }
};

/// Reads a scene with its --set options. Throws Error that lists everything wrong with it.
Scene read_and_resolve(const std::filesystem::path& named, const std::vector<std::string>& options);

}  // namespace breccia
