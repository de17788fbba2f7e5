#include "modules/fracture/existing_laws.hpp"

#include "mesh/geometry.hpp"
#include "modules/fracture/face_grades.hpp"
#include "step/friction_keys.hpp"
#include "step/stress_view.hpp"

#include <algorithm>

namespace breccia {

namespace {

InterfaceLaw fault_of(const Settings& s) {
  InterfaceLaw law;
  law.fault = true;
  law.friction = read_friction(s, "coefficient");
  law.stiffness_factor = s.number("stiffness_factor");
  law.damping = s.number("damping");
  law.onset.tension = law.onset.cohesion = 1e30;  // its tips do not weaken their neighbours
  if (s.has("stress")) law.load = stress_of(s.vector("stress"));
  return law;
}

Index append_fault(InterfaceLaws& laws, const Settings& section, const InterfaceLaw& law) {
  laws.laws.push_back(law);
  laws.sections.push_back(&section);
  laws.grades.push_back(1);
  laws.correlation.push_back(0);
  return static_cast<Index>(laws.laws.size()) - 1;
}

/// A patch is the law of its fault with what it says otherwise.
InterfaceLaw patch_of(const Settings& patch, InterfaceLaw law) {
  if (patch.has("coefficient")) law.friction.at_rest = patch.number("coefficient");
  if (patch.has("dynamic")) law.friction.sliding = patch.number("dynamic");
  if (patch.has("stress")) law.load = stress_of(patch.vector("stress"));
  return law;
}

template <int D>
bool lies_in(const Settings& patch, const Point<D>& x) {
  const auto &lower = patch.vector("lower"), &upper = patch.vector("upper");
  for (int d = 0; d < D; ++d)
    if (x[d] < lower[d] || x[d] > upper[d]) return false;
  return true;
}

template <int D>
Point<D> middle_of(const Mesh<D>& mesh, const ElementFace& face) {
  Point<D> x{};
  for (int i = 0; i < D; ++i)
    x = along(x, 1.0 / D, mesh.point[mesh.element[face.element][face_node<D>(face.face, i)]]);
  return x;
}

}  // namespace

bool has_existing_laws(const Settings& scene) {
  const auto& list = scene.list("fractures");
  return std::any_of(list.begin(), list.end(),
                     [](const Settings& s) { return s.text("kind") != "open"; });
}

void read_existing_laws(const Settings& scene, InterfaceLaws& laws) {
  for (const Settings& section : scene.children("fracture"))
    if (section.has("grains"))
      laws.grain_laws.push_back(
          {&section.at("grains"), section.name(), append_laws(laws, section.at("grains"))});
  for (const Settings& section : scene.list("fractures")) {
    if (section.text("kind") == "open") continue;
    ExistingLaw entry{&section, kNone, {}};
    if (section.text("kind") == "healed") {
      entry.law = append_laws(laws, section.at("law"));
    } else {
      const InterfaceLaw law = fault_of(section.at("friction"));
      entry.law = append_fault(laws, section.at("friction"), law);
      for (const Settings& patch : section.list("patch"))
        entry.patches.emplace_back(&patch, append_fault(laws, patch, patch_of(patch, law)));
    }
    laws.existing.push_back(entry);
  }
}

template <int D>
void put_grain_laws(const InterfaceLaws& laws, const Model<D>& model, std::vector<Index>& law) {
  const FaceGrades grades(laws);
  for (const GrainLaw& grains : laws.grain_laws) {
    const std::string& name = grains.section->text("field");
    const auto field = model.mesh.fields.find(name);
    if (field == model.mesh.fields.end() || field->second.components != 1)
      throw grains.section->error("field", "no mesh has a number \"" + name + "\" per element",
                                  "write it into the mesh file as $ElementData");
    const std::vector<double>& grain = field->second.values;
    const auto is_of = [&](Index e) {
      return model.materials[model.body_material[model.mesh.body[e]]].name == grains.material;
    };
    for (std::size_t f = 0; f < law.size(); ++f) {
      const SharedFace& face = model.topology.shared[f];
      if (grain[face.left] == grain[face.right] || !is_of(face.left) || !is_of(face.right))
        continue;
      law[f] = grains.law + grades.of<D>(grains.law, model.part.face_number(static_cast<Index>(f)),
                                         model.mesh, {face.left, face.left_face});
    }
  }
}

template <int D>
void put_existing_laws(const InterfaceLaws& laws, const Model<D>& model, std::vector<Index>& law) {
  put_grain_laws(laws, model, law);
  if (laws.existing.empty()) return;
  const std::vector<Index> number = face_numbers<D>(model.topology);
  const FaceGrades grades(laws);
  for (const ExistingLaw& entry : laws.existing) {
    const std::string name = entry.section->text("body") + "." + entry.section->name();
    const Region* region = find_region(model.mesh, name);
    if (region == nullptr)
      throw entry.section->error("", "the mesh has no faces on it", "check its place");
    for (const ElementFace& face : region->faces) {
      const Index n = number[static_cast<std::size_t>(face.element * (D + 1) + face.face)];
      if (n < 0) continue;  // on the surface
      Index chosen =
          entry.law + grades.of<D>(entry.law, model.part.face_number(n), model.mesh, face);
      const Point<D> x = middle_of(model.mesh, face);
      for (const auto& [patch, of_patch] : entry.patches)
        if (lies_in<D>(*patch, x)) chosen = of_patch;
      law[static_cast<std::size_t>(n)] = chosen;
    }
  }
}

std::vector<Index> weakest_existing(const InterfaceLaws& laws) {
  std::vector<Index> list;
  for (const ExistingLaw& entry : laws.existing) list.push_back(entry.law);
  for (const GrainLaw& grains : laws.grain_laws) list.push_back(grains.law);
  return list;
}

template void put_existing_laws(const InterfaceLaws&, const Model<2>&, std::vector<Index>&);
template void put_existing_laws(const InterfaceLaws&, const Model<3>&, std::vector<Index>&);

}  // namespace breccia
