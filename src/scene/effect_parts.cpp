#include "scene/effect_parts.hpp"

#include "fields/common_fields.hpp"
#include "fields/solid_fields.hpp"
#include "modules/fracture/fracture_fields.hpp"
#include "scene/catalog.hpp"
#include "step/friction_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace breccia {

namespace {

std::size_t bytes_of(const Store& store, const std::vector<std::string>& fields) {
  std::size_t sum = 0;
  for (const Store::Block& block : store.blocks())
    if (std::find(fields.begin(), fields.end(), block.info.name) != fields.end())
      sum += block.bytes;
  return sum;
}

/// Names the materials that have something: "steel, scene.toml:14; rock, scene.toml:20".
template <int D>
std::string materials_with(const Model<D>& model, const std::function<bool(const Material&)>& has) {
  std::string text;
  for (std::size_t m = 0; m < model.materials.size(); ++m) {
    const Material& material = model.materials[m];
    const bool used =
        std::any_of(model.blocks.begin(), model.blocks.end(),
                    [m](const Block& block) { return block.material == static_cast<Index>(m); });
    if (!used || material.rigid || !has(material)) continue;
    const Settings* section = model.scene->find("material", material.name);
    text += fmt::format("{}material.{}{}", text.empty() ? "" : "; ", material.name,
                        section != nullptr ? ", " + line_of(section->place()) : "");
  }
  return text;
}

template <int D>
void add_solid_parts(const Model<D>& model, std::vector<EffectPart>& parts) {
  const auto add = [&](const char* name, const std::function<bool(const Material&)>& has,
                       const std::vector<std::string>& fields) {
    const std::string why = materials_with(model, has);
    if (!why.empty()) parts.push_back({"solid", name, why, bytes_of(model.store, fields)});
  };
  add("damping", [](const Material& m) { return m.damping > 0; }, {});
  add("bulk viscosity", [](const Material& m) { return m.viscosity.on(); },
      {std::string(ElementModulus::info.name)});
  add("directions", [](const Material& m) { return m.stiffness.has_value(); }, {});
  add("yielding", [](const Material& m) { return m.yields(); },
      {std::string(ElementElastic<D>::info.name), std::string(ElementHistory::info.name)});
  // The memory is the same, and counted once.
  add("equation of state", [](const Material& m) { return m.eos.has_value() && !m.yields(); },
      {std::string(ElementElastic<D>::info.name), std::string(ElementHistory::info.name)});
  const bool composites = std::any_of(model.blocks.begin(), model.blocks.end(),
                                      [](const Block& block) { return block.group > 1; });
  if (composites)
    parts.push_back({"solid", "composites", "mesh.element",
                     bytes_of(model.store, {std::string(ElementCauchy<D>::info.name)})});
}

template <int D>
void add_field_part(const Model<D>& model, const char* effect, const char* name, std::string why,
                    const std::vector<std::string>& fields, std::vector<EffectPart>& parts) {
  const std::size_t bytes = bytes_of(model.store, fields);
  if (bytes > 0) parts.push_back({effect, name, std::move(why), bytes});
}

}  // namespace

template <int D>
std::vector<EffectPart> parts_of(const Model<D>& model) {
  std::vector<EffectPart> parts;
  add_solid_parts(model, parts);
  const Settings& scene = *model.scene;
  const Settings& run = scene.at("run");
  if (run.has("mass_scaling"))
    add_field_part(model, "motion", "mass scaling",
                   "run.mass_scaling, " + line_of(run.at("mass_scaling").place()),
                   {std::string(NodeAddedMass::info.name)}, parts);
  add_field_part(model, "boundary", "waves let out", "[[boundary]] with absorb",
                 {"element_absorber", "absorber_damping"}, parts);
  if (scene.has("contact") && contact_remembers(scene)) {
    const std::string why =
        "friction other than Coulomb's, " + line_of(scene.at("contact").place());
    add_field_part(model, "contact", "memory of friction", why, {"contact_rubbed"}, parts);
    add_field_part(model, "fracture", "memory of friction", why, {"interface_rubbed"}, parts);
  }
  if (model.store.template has<InterfaceFaults<D>>()) {
    const auto& list = scene.list("fractures");
    parts.push_back(
        {"fracture", "faults",
         list.empty() ? "closed fractures" : "[[fractures]], " + line_of(list.front().place()),
         bytes_of(model.store, {std::string(InterfaceFaults<D>::info.name)})});
  }
  return parts;
}

template std::vector<EffectPart> parts_of(const Model<2>&);
template std::vector<EffectPart> parts_of(const Model<3>&);

}  // namespace breccia
