// The keys of [material.NAME], and what must hold between them.
#include "core/text.hpp"
#include "scene/schema_rules.hpp"
#include "step/material.hpp"
#include "step/material_laws.hpp"

namespace breccia {

namespace {

void declare_basis(Schema& schema) {
  auto s = schema.section("material.*")
               .required()
               .effect("solid")
               .doc("A material; [[body]] material names it.");
  s.number("density", unit::density)
      .above(0)
      .required()
      .doc("Mass per volume.")
      .example("2650 kg/m3");
  s.number("damping", unit::none)
      .between(0, 2)
      .by_default(0.0)
      .doc("Kelvin damping as a share of critical at the highest mode of each element.")
      .example("0.02");
  s.numbers("bulk_viscosity", unit::none)
      .between(0, 100)
      .doc(
          "Shock viscosity, quadratic and linear coefficient; [1.5, 0.06] where the material has "
          "an equation of state, none where it has not.")
      .example("[1.5, 0.06]");
  auto elastic = schema.section("material.*.elastic").required().doc("Isotropic elasticity.");
  elastic.number("young", unit::pressure)
      .above(0)
      .required()
      .doc("Young's modulus.")
      .example("60 GPa");
  elastic.number("poisson", unit::none)
      .above(-1)
      .below(0.5)
      .required()
      .doc("Poisson's ratio.")
      .example("0.25");
}

void declare_plastic(Schema& schema) {
  std::vector<std::string> words;
  for (const PlasticKeys& keys : plastic_keys()) {
    auto section = schema.section(std::string("material.*.") + keys.word);
    section.doc(keys.doc);
    keys.declare(section);
    words.emplace_back(keys.word);
  }
  if (words.size() > 1) schema.section("material.*").at_most_one_of(words);
}

void declare_eos(Schema& schema) {
  auto eos = schema.section("material.*.eos")
                 .doc(
                     "Equation of state: pressure from density and energy, in place of that of "
                     "the elastic constants.");
  std::vector<std::string> words;
  for (const EosKeys& keys : eos_keys()) {
    auto section = schema.section(std::string("material.*.eos.") + keys.word);
    section.doc(keys.doc);
    keys.declare(section);
    words.emplace_back(keys.word);
  }
  eos.exactly_one_of(words);
}

void check_laws(const Settings& material, Problems& problems) {
  const double young = material.number("elastic.young"), nu = material.number("elastic.poisson");
  const MaterialBasis basis{material.number("density"), young / (3 * (1 - 2 * nu)),
                            young / (2 * (1 + nu))};
  try {
    read_plastic(material, basis);
  } catch (const Error& e) {
    problems.add(e);
  }
  if (!material.has("eos")) return;
  try {
    read_eos(material.at("eos"), basis);
  } catch (const Error& e) {
    problems.add(e);
  }
}

}  // namespace

void declare_material_keys(Schema& schema) {
  declare_basis(schema);
  declare_plastic(schema);
  declare_eos(schema);
}

void check_material_rules(const Settings& scene, Problems& problems) {
  const bool plane_stress = scene.at("run").text_or("plane", "strain") == "stress";
  for (const Settings& material : scene.children("material")) {
    if (material.has("bulk_viscosity") && material.vector("bulk_viscosity").size() != 2) {
      problems.add(material.error("bulk_viscosity", "wants two numbers, quadratic and linear",
                                  "for example: bulk_viscosity = [1.5, 0.06]"));
      continue;
    }
    check_laws(material, problems);
    for (const PlasticKeys& keys : plastic_keys()) {
      if (!plane_stress || !material.has(keys.word)) continue;
      problems.add(material.at(keys.word).error("", "laws of yielding are for plane strain",
                                                "write run.plane = \"strain\""));
    }
    if (plane_stress && material.has("eos")) {
      problems.add(material.at("eos").error("", "equations of state are for plane strain",
                                            "write run.plane = \"strain\""));
    }
  }
}

}  // namespace breccia
