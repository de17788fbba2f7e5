#include "modules/rigid/rigid.hpp"

#include <algorithm>

namespace breccia {

void declare_rigid_keys(Schema& schema) {
  schema.check([](const Settings& scene, Problems& problems) {
    const auto& bodies = scene.list("body");
    const auto is_rigid = [&](const std::string& name) {
      return std::any_of(bodies.begin(), bodies.end(), [&](const Settings& body) {
        return body.name() == name && body.flag("rigid");
      });
    };
    for (const Settings& section : scene.list("boundary")) {
      const char* key = section.has("spin") ? "spin" : section.has("pivot") ? "pivot" : nullptr;
      if (key == nullptr) continue;
      if (!section.has("where") || !is_rigid(section.text("where")))
        problems.add(section.error(key, "only a rigid body can be told how it turns",
                                   "name a [[body]] with rigid = true in `where`"));
      if (!section.has("velocity") && !section.has("fixed"))
        problems.add(section.error(key, "says how a body turns that a boundary moves or holds",
                                   "add `velocity` or `fixed`; free components stay free"));
    }
    for (const Settings& body : bodies)
      if (body.flag("rigid") && body.has("expansion"))
        problems.add(body.error("expansion", "a rigid body does not stretch",
                                "leave one of `rigid` and `expansion` out"));
    const bool any = std::any_of(bodies.begin(), bodies.end(),
                                 [](const Settings& body) { return body.flag("rigid"); });
    if (!any) return;
    const Settings& run = scene.at("run");
    if (run.has("rest") && run.at("rest").text("method") == "local")
      problems.add(run.at("rest").error("method", "rigid bodies know no local damping",
                                        "use method = \"kinetic\""));
  });
}

}  // namespace breccia
