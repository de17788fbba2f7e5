#include "scene/catalog.hpp"

#include "modules/boundary/boundary.hpp"
#include "modules/contact/contact.hpp"
#include "modules/excavation/excavation.hpp"
#include "modules/fracture/fracture.hpp"
#include "modules/gravity/gravity.hpp"
#include "modules/motion/motion.hpp"
#include "modules/rest/rest.hpp"
#include "modules/rigid/rigid.hpp"
#include "modules/sensor/sensor.hpp"
#include "modules/solid/solid.hpp"

#include <fmt/format.h>

namespace breccia {

template <int D>
std::vector<std::unique_ptr<Module<D>>> make_modules(const Settings& scene) {
  std::vector<std::unique_ptr<Module<D>>> list;
  list.push_back(std::make_unique<Motion<D>>());
  // Before the elements, which keep their stresses where some carry a share of them only.
  if (ExcavationModule<D>::wanted(scene)) list.push_back(std::make_unique<ExcavationModule<D>>());
  list.push_back(std::make_unique<Solid<D>>());
  if (Gravity<D>::wanted(scene)) list.push_back(std::make_unique<Gravity<D>>());
  if (Boundary<D>::wanted(scene)) list.push_back(std::make_unique<Boundary<D>>());
  if (Fracture<D>::wanted(scene)) list.push_back(std::make_unique<Fracture<D>>());
  if (Contact<D>::wanted(scene)) list.push_back(std::make_unique<Contact<D>>());
  if (Rigid<D>::wanted(scene)) list.push_back(std::make_unique<Rigid<D>>());
  // Behind all that exert forces: it looks at their sum.
  if (RestModule<D>::wanted(scene)) list.push_back(std::make_unique<RestModule<D>>());
  if (Sensor<D>::wanted(scene)) list.push_back(std::make_unique<Sensor<D>>());
  return list;
}

void declare_module_keys(Schema& schema) {
  declare_fracture_keys(schema);
  declare_contact_keys(schema);
  declare_rest_keys(schema);
  declare_excavation_keys(schema);
  declare_rigid_keys(schema);
}

namespace {

/// First section of a list or of a family of named ones, or nullptr.
const Settings* first(const std::vector<Settings>& sections) {
  return sections.empty() ? nullptr : &sections.front();
}

const Settings* fracture_section(const Settings& scene) {
  if (const Settings* s = first(scene.children("fracture"))) return s;
  if (const Settings* s = first(scene.list("interface"))) return s;
  return first(scene.list("fractures"));
}

const Settings* rigid_body(const Settings& scene) {
  for (const Settings& body : scene.list("body"))
    if (body.flag("rigid")) return &body;
  return nullptr;
}

/// `by` is what switches the effect on; `words` how a scene would write it.
EffectState state_of(const char* name, bool on, const char* words, const Settings* by) {
  if (!on) return {name, false, fmt::format("no {}", words)};
  return {name, true,
          by != nullptr ? fmt::format("{}, {}", by->path(), line_of(by->place())) : words};
}

}  // namespace

std::string line_of(const std::string& place) {
  const auto colon = place.rfind(':');
  if (colon == std::string::npos) return place;
  return "line " + place.substr(colon + 1);
}

std::vector<EffectState> effects_of(const Settings& scene) {
  const Settings& run = scene.at("run");
  const auto single = [](const Settings& in, const char* key) {
    return in.has(key) ? &in.at(key) : nullptr;
  };
  return {state_of("motion", true, "every scene", nullptr),
          state_of("excavation", ExcavationModule<2>::wanted(scene), "[[excavate]]",
                   first(scene.list("excavate"))),
          state_of("solid", true, "every scene", nullptr),
          state_of("gravity", Gravity<2>::wanted(scene), "[gravity]", single(scene, "gravity")),
          state_of("boundary", Boundary<2>::wanted(scene), "[[boundary]]",
                   first(scene.list("boundary"))),
          state_of("fracture", Fracture<2>::wanted(scene),
                   "[fracture.*], [[interface]] or closed [[fractures]]", fracture_section(scene)),
          state_of("contact", Contact<2>::wanted(scene), "[contact]", single(scene, "contact")),
          state_of("rigid", Rigid<2>::wanted(scene), "body with rigid = true", rigid_body(scene)),
          state_of("rest", RestModule<2>::wanted(scene), "[run.rest]", single(run, "rest")),
          state_of("sensor", Sensor<2>::wanted(scene), "[[sensor]]", first(scene.list("sensor")))};
}

template std::vector<std::unique_ptr<Module<2>>> make_modules<2>(const Settings&);
template std::vector<std::unique_ptr<Module<3>>> make_modules<3>(const Settings&);

}  // namespace breccia
