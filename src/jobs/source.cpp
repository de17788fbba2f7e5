#include "jobs/source.hpp"

#include "core/error.hpp"
#include "core/text.hpp"
#include "io/scene_reader.hpp"

namespace breccia {

namespace fs = std::filesystem;

SceneSource::SceneSource(std::string section, const fs::path& named, const Options& options)
    : word_(std::move(section)), file_(find_scene_file(named)), scene_(file_) {
  Options of_section, others;
  for (const std::string& option : options)
    (trimmed(option).rfind(word_ + ".", 0) == 0 ? of_section : others).push_back(option);
  const Config own = read_scene(file_, of_section);
  const Config* found = own.find(word_);
  if (found == nullptr) {
    throw Error(file_.string(), "the scene has no [" + word_ + "]",
                "docs/" + word_ + ".md shows one; breccia help " + word_ + " lists its keys");
  }
  about_ = *found;
  if (const Config* scene = about_.find("scene"); scene != nullptr) refer(own, *scene);
  add_set();
  shared_.insert(shared_.end(), others.begin(), others.end());
}

Config SceneSource::read(const Options& options) const {
  Options all = shared_;
  all.insert(all.end(), options.begin(), options.end());
  Config scene = read_scene(scene_, all);
  std::erase_if(scene.table(), [](const Config::Entry& entry) {
    return entry.first == "study" || entry.first == "batch";
  });
  return scene;
}

Config SceneSource::whole() const {
  Config scene = read({});
  scene.table().emplace_back(word_, about_);
  return scene;
}

std::string SceneSource::name() const {
  return file_.stem() == "scene" ? fs::absolute(file_).parent_path().filename() : file_.stem();
}

void SceneSource::refer(const Config& own, const Config& named) {
  if (!named.is(Config::Kind::text)) return;  // the schema says what is wrong
  for (const auto& [key, value] : own.table()) {
    if (key == word_ || key == "title") continue;
    throw Error(
        value.place().text(),
        key + ": " + word_ + ".scene names another file, so this one holds [" + word_ + "] alone",
        "put the change into " + word_ + ".set, or leave " + word_ + ".scene out");
  }
  scene_ = find_scene_file((file_.parent_path() / named.text()).lexically_normal());
}

/// Whether `set` is a list of texts is for the schema to say.
void SceneSource::add_set() {
  const Config* set = about_.find("set");
  if (set == nullptr || !set->is(Config::Kind::array)) return;
  for (const Config& option : set->array())
    if (option.is(Config::Kind::text)) shared_.push_back(option.text());
}

}  // namespace breccia
