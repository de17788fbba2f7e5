// The keys of [material.NAME], and what must hold between them.
#include "core/text.hpp"
#include "scene/material_axes.hpp"
#include "scene/schema_rules.hpp"
#include "step/anisotropy.hpp"
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
  s.exactly_one_of({"elastic", "orthotropic", "transversely_isotropic", "stiffness"});
  auto elastic = schema.section("material.*.elastic").doc("Isotropic elasticity.");
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
  auto pores = schema.section("material.*.eos.pores")
                   .doc("Pores that close under pressure and do not open again (P-alpha).");
  declare_pores(pores);
}

MaterialBasis basis_of(const Settings& material) {
  const double young = material.number("elastic.young"), nu = material.number("elastic.poisson");
  return {material.number("density"), young / (3 * (1 - 2 * nu)), young / (2 * (1 + nu))};
}

/// Laws of yielding and of pressure know one bulk and one shear modulus.
void check_anisotropic(const Settings& material, int dimension, Problems& problems) {
  try {
    read_anisotropy(material, dimension);
  } catch (const Error& e) {
    problems.add(e);
  }
  std::vector<std::string> isotropic{"eos"};
  for (const PlasticKeys& keys : plastic_keys()) isotropic.emplace_back(keys.word);
  for (const std::string& word : isotropic)
    if (material.has(word))
      problems.add(material.at(word).error("", "needs a material that is alike in all directions",
                                           "give the material [elastic], or leave this out"));
}

void check_laws(const Settings& material, Problems& problems) {
  try {
    read_plastic(material, basis_of(material));
  } catch (const Error& e) {
    problems.add(e);
  }
  if (!material.has("eos")) return;
  try {
    read_eos(material.at("eos"), basis_of(material));
  } catch (const Error& e) {
    problems.add(e);
  }
}

/// A-1.7e: cracks belong to the interfaces, so the bulk must bear the tension that opens them.
void check_tension(const Settings& face, const Settings& material, Problems& problems) {
  if (!material.has("elastic")) return;  // anisotropic and elastic for ever
  const double wanted = face.number("tensile_strength");
  const auto borne = tension_of_bulk(read_plastic(material, basis_of(material)));
  if (borne && *borne < wanted) {
    problems.add(face.error(
        "tensile_strength",
        "the bulk of " + material.name() + " yields in simple tension at " + number_text(*borne) +
            " Pa, below these " + number_text(wanted) + " Pa; the faces would never open",
        "raise the strength of the bulk (its tension cut-off first), or lower this one"));
  }
  if (!material.has("eos")) return;
  for (const EosKeys& keys : eos_keys()) {
    const std::string section = std::string("eos.") + keys.word;
    if (!material.has(section) || !material.has(section + ".spall")) continue;
    const double spall = material.number(section + ".spall");
    if (3 * spall >= wanted) continue;
    problems.add(
        face.error("tensile_strength",
                   "the bulk of " + material.name() + " bears a mean tension of " +
                       number_text(spall) + " Pa (" + section +
                       ".spall), too little for this in simple tension; the faces would never open",
                   "raise or leave out spall"));
  }
}

void check_tension_of_faces(const Settings& scene, Problems& problems) {
  for (const Settings& face : scene.children("fracture")) {
    const Settings* material = scene.find("material", face.name());
    if (material != nullptr) check_tension(face, *material, problems);
  }
  for (const Settings& face : scene.list("interface")) {
    for (const std::string& name : face.texts("between")) {
      const Settings* material = scene.find("material", name);
      if (material != nullptr) check_tension(face, *material, problems);
    }
  }
}

}  // namespace

void declare_material_keys(Schema& schema) {
  declare_basis(schema);
  declare_anisotropy(schema);
  declare_plastic(schema);
  declare_eos(schema);
  declare_axes(schema);
}

void check_material_rules(const Settings& scene, Problems& problems) {
  const bool plane_stress = scene.at("run").text_or("plane", "strain") == "stress";
  for (const Settings& material : scene.children("material")) {
    if (material.has("bulk_viscosity") && material.vector("bulk_viscosity").size() != 2) {
      problems.add(material.error("bulk_viscosity", "wants two numbers, quadratic and linear",
                                  "for example: bulk_viscosity = [1.5, 0.06]"));
      continue;
    }
    if (!material.has("elastic")) {
      check_anisotropic(material, static_cast<int>(scene.at("run").integer("dimension")), problems);
      continue;
    }
    check_laws(material, problems);
    if (!plane_stress) continue;
    for (const PlasticKeys& keys : plastic_keys()) {
      if (!material.has(keys.word)) continue;
      problems.add(material.at(keys.word).error("", "laws of yielding are for plane strain",
                                                "write run.plane = \"strain\""));
    }
    if (material.has("eos")) {
      problems.add(material.at("eos").error("", "equations of state are for plane strain",
                                            "write run.plane = \"strain\""));
    }
  }
  if (problems.empty()) check_tension_of_faces(scene, problems);
}

}  // namespace breccia
