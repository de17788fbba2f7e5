#pragma once
#include "harness/temp_folder.hpp"
#include "io/json_reader.hpp"
#include "scene/commands.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace breccia {

/// The report of a run of the scene.
inline Json report_of(const std::string& scene) {
  const TempFolder folder;
  std::ofstream(folder / "scene.toml") << scene;
  RunRequest request;
  request.scene = folder / "scene.toml";
  request.output = folder / "out";
  request.quiet = true;
  EXPECT_EQ(run_scene(request), 0);
  return read_json(folder / "out/report.json");
}

}  // namespace breccia
