#include "step/material.hpp"

#include "step/material_laws.hpp"

namespace breccia {

namespace {

BulkViscosity read_viscosity(const Settings& material) {
  if (!material.has("bulk_viscosity")) {
    return material.has("eos") ? BulkViscosity{1.5, 0.06} : BulkViscosity{};
  }
  const auto& numbers = material.vector("bulk_viscosity");
  return {numbers.at(0), numbers.at(1)};
}

}  // namespace

std::vector<Material> read_materials(const Settings& scene) {
  std::vector<Material> list;
  for (const Settings& section : scene.children("material")) {
    Material material;
    material.name = section.name();
    material.density = section.number("density");
    material.young = section.number("elastic.young");
    material.poisson = section.number("elastic.poisson");
    material.damping = section.number("damping");
    const MaterialBasis basis{material.density, material.bulk(), material.mu()};
    material.plastic = read_plastic(section, basis);
    if (section.has("eos")) material.eos = read_eos(section.at("eos"), basis);
    material.viscosity = read_viscosity(section);
    list.push_back(material);
  }
  return list;
}

}  // namespace breccia
