#include "study/picture.hpp"

#include "core/error.hpp"
#include "core/log.hpp"
#include "jobs/process.hpp"

#include <cstdlib>

namespace breccia {

namespace {

namespace fs = std::filesystem;

/// tools/plot of the tree that the executable or the current folder lies in.
std::string plotter(const fs::path& program) {
  if (const char* named = std::getenv("BRECCIA_PLOT")) return named;
  std::error_code trouble;
  for (fs::path start : {fs::absolute(program, trouble), fs::current_path(trouble) / "here"}) {
    while (start.has_parent_path() && start != start.parent_path()) {
      start = start.parent_path();
      const fs::path found = start / "tools" / "plot";
      if (fs::is_regular_file(found, trouble)) return found.string();
    }
  }
  return {};
}

bool drawn(const std::string& plot, const Study& study) {
  try {
    Process process({plot, study.output.string()}, (study.output / "plot.log").string());
    const Ending ending = process.wait();
    return ending.status == 0 && ending.signal == 0;
  } catch (const Error&) {
    return false;
  }
}

}  // namespace

void draw_picture(const Study& study) {
  const std::string plot = plotter(study.program);
  const fs::path picture = study.output / "study.png";
  if (!plot.empty() && drawn(plot, study)) {
    log::info("picture: " + picture.string());
  } else {
    log::info("for a picture: tools/plot " + study.output.string());
  }
}

}  // namespace breccia
