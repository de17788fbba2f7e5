#include "step/material_laws.hpp"

#include "core/text.hpp"

namespace breccia {

namespace {

/// Compresses the material at rest by half, slowly: it must stay stiff on the way.
void check_stiffness(const Eos& eos, const Settings& section) {
  EosState state = eos.start();
  const int steps = 200;
  for (int i = 0; i <= steps; ++i) {
    const double rho = eos.rho0 * (1 + 0.5 * i / steps);
    eos.advance(state, rho, 0);
    const EosPoint q = eos.at(rho, state.e, state.alpha);
    const double modulus = rho * q.p_rho + q.p / rho * q.p_e;
    if (modulus > 0) continue;
    throw section.error("",
                        "pressure falls as the material is compressed to " + number_text(rho) +
                            " kg/m3: rho c^2 is " + number_text(modulus) + " Pa",
                        "look at the constants of the equation of state");
  }
}

}  // namespace

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
  MaterialBasis solid = basis;
  if (section.has("pores")) {
    eos.pores = read_pores(section.at("pores"));
    solid.density *= eos.pores.alpha;
  }
  for (const EosKeys& keys : eos_keys()) {
    if (section.has(keys.word)) keys.read(section.at(keys.word), solid, eos);
  }
  if (section.has("pores") && eos.energy0 > 0) {
    throw section.at("pores").error("", "pores are for solids", "leave them out");
  }
  const EosPoint rest = eos.at(eos.rho0, eos.energy0, eos.pores.alpha);
  eos.modulus0 = eos.rho0 * rest.p_rho + rest.p / eos.rho0 * rest.p_e;
  check_stiffness(eos, section);
  return eos;
}

std::optional<double> tension_of_bulk(const PlasticLaw& law) {
  return std::visit(
      [](const auto& l) -> std::optional<double> {
        if constexpr (requires { l.uniaxial_tension(); }) {
          return l.uniaxial_tension();
        } else {
          return std::nullopt;
        }
      },
      law);
}

}  // namespace breccia
