#include "step/material.hpp"

namespace breccia {

std::vector<Material> read_materials(const Settings& scene) {
  std::vector<Material> list;
  for (const Settings& section : scene.children("material")) {
    Material material;
    material.name = section.name();
    material.density = section.number("density");
    material.young = section.number("elastic.young");
    material.poisson = section.number("elastic.poisson");
    material.damping = section.number("damping");
    list.push_back(material);
  }
  return list;
}

}  // namespace breccia
