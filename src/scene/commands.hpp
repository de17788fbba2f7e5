#pragma once
#include "core/schema.hpp"
#include "core/world.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace breccia {

/// What `breccia run` was asked for.
struct RunRequest {
  std::filesystem::path scene;                  ///< file, or folder with scene.toml
  std::vector<std::string> options;             ///< "key.path=value" of each --set
  std::optional<std::filesystem::path> output;  ///< otherwise `<scene name>.out`
  bool overwrite = false;
  bool restart = false;
  bool quiet = false;
  const World* world = nullptr;  ///< the ranks that run it together; none: this one
};

/// What `breccia check` was asked for.
struct CheckRequest {
  std::filesystem::path scene;
  std::vector<std::string> options;
};

/// What `breccia mesh` was asked for.
struct MeshRequest {
  std::filesystem::path scene;
  std::vector<std::string> options;
  std::filesystem::path output;
};

// Each returns the exit status: 0 done, 1 stopped before its time, 3 a check of the scene failed.
// User errors are thrown as Error (status 2). Kokkos is initialised by the caller.
int run_scene(const RunRequest& request);
int check_scene(const CheckRequest& request);
int mesh_scene(const MeshRequest& request);

/// Every key of every module that this build has.
void declare_schema(Schema& schema);

}  // namespace breccia
