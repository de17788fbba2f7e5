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

std::vector<EffectState> effects_of(const Settings& scene) {
  return {{"solid", true},
          {"motion", true},
          {"excavation", ExcavationModule<2>::wanted(scene)},
          {"gravity", Gravity<2>::wanted(scene)},
          {"boundary", Boundary<2>::wanted(scene)},
          {"fracture", Fracture<2>::wanted(scene)},
          {"contact", Contact<2>::wanted(scene)},
          {"rigid", Rigid<2>::wanted(scene)},
          {"rest", RestModule<2>::wanted(scene)},
          {"sensor", Sensor<2>::wanted(scene)}};
}

template std::vector<std::unique_ptr<Module<2>>> make_modules<2>(const Settings&);
template std::vector<std::unique_ptr<Module<3>>> make_modules<3>(const Settings&);

}  // namespace breccia
