#include "scene/scene.hpp"

#include "io/scene_reader.hpp"
#include "scene/catalog.hpp"
#include "scene/commands.hpp"
#include "scene/schema_general.hpp"

namespace breccia {

void declare_schema(Schema& schema) {
  declare_general_keys(schema);
  declare_module_keys(schema);
}

Scene read_and_resolve(const std::filesystem::path& named,
                       const std::vector<std::string>& options) {
  Schema schema;
  declare_schema(schema);
  const std::filesystem::path file = find_scene_file(named);
  Scene scene;
  scene.settings = schema.resolve(read_scene(file, options));
  scene.folder = file.parent_path();
  scene.name = file.stem() == "scene" ? std::filesystem::absolute(file).parent_path().filename()
                                      : file.stem();
  return scene;
}

}  // namespace breccia
