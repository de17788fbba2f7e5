#include "step/material.hpp"

#include "step/anisotropy.hpp"
#include "step/material_laws.hpp"

#include <algorithm>

namespace breccia {

namespace {

BulkViscosity read_viscosity(const Settings& material) {
  if (!material.has("bulk_viscosity")) {
    return material.has("eos") ? BulkViscosity{1.5, 0.06} : BulkViscosity{};
  }
  const auto& numbers = material.vector("bulk_viscosity");
  return {numbers.at(0), numbers.at(1)};
}

void read_elasticity(const Settings& scene, const Settings& section, Material& material) {
  const auto dimension = static_cast<int>(scene.at("run").integer("dimension"));
  material.stiffness = read_anisotropy(section, dimension);
  if (!material.stiffness) {
    material.young = section.number("elastic.young");
    material.poisson = section.number("elastic.poisson");
    return;
  }
  const double modulus = fastest_modulus(*material.stiffness, dimension);
  const double shear = std::min(mean_shear(*material.stiffness), 0.45 * modulus);
  const double lambda = modulus - 2 * shear;
  material.young = shear * (3 * lambda + 2 * shear) / (lambda + shear);
  material.poisson = lambda / (2 * (lambda + shear));
}

}  // namespace

Material rigid_material(const Material& material) {
  Material rigid;
  rigid.name = material.name;
  rigid.density = material.density;
  rigid.young = material.young;
  rigid.poisson = material.poisson;
  rigid.rigid = true;
  return rigid;
}

std::vector<Material> read_materials(const Settings& scene) {
  std::vector<Material> list;
  for (const Settings& section : scene.children("material")) {
    Material material;
    material.name = section.name();
    material.density = section.number("density");
    read_elasticity(scene, section, material);
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
