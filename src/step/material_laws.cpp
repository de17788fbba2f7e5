#include "step/material_laws.hpp"

namespace breccia {

PlasticLaw read_plastic(const Settings& material, const MaterialBasis& basis) {
  for (const PlasticKeys& keys : plastic_keys()) {
    if (!material.has(keys.word)) continue;
    PlasticLaw law = keys.read(material.at(keys.word), basis);
    std::visit(
        [&](auto& l) {
          l.bulk = basis.bulk;
          l.shear = basis.shear;
        },
        law);
    return law;
  }
  return NoYield{basis.bulk, basis.shear};
}

Eos read_eos(const Settings& section, const MaterialBasis& basis) {
  Eos eos;
  eos.rho0 = basis.density;
  for (const EosKeys& keys : eos_keys()) {
    if (section.has(keys.word)) keys.read(section.at(keys.word), basis, eos);
  }
  const EosPoint rest = eos.at(eos.rho0, eos.energy0);
  eos.modulus0 = eos.rho0 * rest.p_rho + rest.p / eos.rho0 * rest.p_e;
  return eos;
}

}  // namespace breccia
