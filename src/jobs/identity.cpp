#include "jobs/identity.hpp"

#include "core/build_info.hpp"
#include "io/digest.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>

namespace breccia {

namespace {

namespace fs = std::filesystem;

/// Files that a scene names count as what is in them.
void add_files(const Settings& section, std::string& text) {
  for (const Settings::Value& v : section.values()) {
    const auto* word = std::get_if<std::string>(&v.value);
    std::error_code trouble;
    if (word == nullptr || !fs::path(*word).is_absolute() || !fs::is_regular_file(*word, trouble))
      continue;
    std::ifstream file(*word, std::ios::binary);
    std::ostringstream content;
    content << file.rdbuf();
    text += fingerprint(content.str());
  }
  for (const Settings::Group& group : section.groups())
    for (const Settings& member : group.members) add_files(member, text);
}

}  // namespace

std::string job_identity(const Settings& scene, const std::string& more) {
  std::ostringstream resolved;
  scene.write_resolved(resolved);
  const BuildInfo& build = build_info();
  std::string text = resolved.str() + more;
  text.append(build.version).append(build.commit).append(build.build_type).append(build.compiler);
  add_files(scene, text);
  return fingerprint(text);
}

}  // namespace breccia
