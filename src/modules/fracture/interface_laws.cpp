#include "modules/fracture/interface_laws.hpp"

#include "core/log.hpp"
#include "mesh/geometry.hpp"
#include "modules/fracture/existing_laws.hpp"
#include "modules/fracture/strength_grades.hpp"
#include "point/cohesive_encode.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace breccia {

namespace {

/// Least share of critical damping that keeps kinks quiet (ALGORITHMS ).
constexpr double kLeastDamping = 0.005;

InterfaceLaw read_law(const Settings& s) {
  InterfaceLaw law;
  const double friction = std::tan(s.number("friction_angle"));
  law.strength = {s.number("tensile_strength"),
                  s.number("cohesion"),
                  friction,
                  s.has("residual_friction") ? s.number("residual_friction") : friction,
                  s.number("energy_tension"),
                  s.number("energy_shear")};
  law.onset = {law.strength.tension, law.strength.cohesion, friction, s.number("alpha"),
               s.text("criterion") == "elliptic"};
  if (s.has("rate_reference")) {
    if (law.onset.alpha == 0)
      throw s.error("rate_reference", "with alpha = 0 faces are interfaces before anything moves",
                    "take an alpha above 0, or leave the rate out");
    law.onset.rate_reference = s.number("rate_reference");
    law.onset.rate_exponent = s.number("rate_exponent");
    law.onset.rate_limit = s.number("rate_limit");
  }
  law.stiffness_factor = s.number("stiffness_factor");
  law.damping = s.number("damping");
  law.z_curve = s.text("softening") == "z_curve";
  law.at_start = law.onset.alpha == 0 || law.strength.tension == 0 || law.strength.cohesion == 0;
  if (law.damping < kLeastDamping)
    log::warning(fmt::format(
        "{}: {}.damping = {} is below {}: interfaces that open and close may feed energy into the "
        "motion; raise it, or take run.step_factor of 0.2 at most and watch res_2",
        s.place("damping"), s.path(), law.damping, kLeastDamping));
  return law;
}

Index material_named(const std::vector<Material>& materials, const std::string& name) {
  for (std::size_t m = 0; m < materials.size(); ++m)
    if (materials[m].name == name) return static_cast<Index>(m);
  return kNone;
}

Index require_material(const std::vector<Material>& materials, const Settings& section,
                       const std::string& key, const std::string& name) {
  const Index m = material_named(materials, name);
  if (m == kNone)
    throw section.error(key, fmt::format("there is no [material.{}]", name),
                        "name a material of this scene");
  return m;
}

void put(InterfaceLaws& laws, const Settings& section, const std::string& key, Index a, Index b) {
  const auto at = [&](Index i, Index j) -> Index& {
    return laws.of_materials[static_cast<std::size_t>(i * laws.materials + j)];
  };
  if (at(a, b) != kNone)
    throw section.error(
        key, "faces between these materials have a law already",
        fmt::format("keep one of this and the one at {}", laws.sections[at(a, b)]->place()));
  at(a, b) = at(b, a) = append_laws(laws, section);
}

/// Heights h_f of the faces of a law, m.
struct Heights {
  double least = 1e300, most = 0;
  Index material_left = 0, material_right = 0;  ///< of the tallest
};

template <int D>
std::vector<Heights> face_heights(const InterfaceLaws& laws, const Model<D>& model) {
  std::vector<Heights> heights(laws.laws.size());
  const std::vector<Index> law_of_face = law_of_faces(laws, model);
  for (std::size_t f = 0; f < law_of_face.size(); ++f) {
    const Index law = law_of_face[f];
    if (law == kNone) continue;
    const SharedFace& face = model.topology.shared[f];
    const Index l = model.body_material[model.mesh.body[face.left]];
    const Index r = model.body_material[model.mesh.body[face.right]];
    const auto x = corners<D>(model.mesh, face.left);
    const double area = length(face_normal_area<D>(x, face.left_face));
    const double volume = std::abs(signed_volume<D>(x)) +
                          std::abs(signed_volume<D>(corners<D>(model.mesh, face.right)));
    const double h = volume / (2 * area);
    Heights& all = heights[static_cast<std::size_t>(law)];
    all.least = std::min(all.least, h);
    if (h > all.most) all = {all.least, h, l, r};
  }
  return heights;
}

[[noreturn]] void refuse_energy(const Settings& section, const char* key, double given,
                                double needed, double height) {
  throw section.error(
      key,
      fmt::format(
          "{:.4g} J/m2 is less than an interface stores at its peak on this mesh, where the "
          "largest elements ask for {:.4g} J/m2",
          given, needed),
      fmt::format("take elements of at most {:.3g} m instead of {:.3g} m, a larger "
                  "stiffness_factor, a larger energy, or a smaller strength",
                  2 * height * given / needed, 2 * height));
}

void check_energies(const InterfaceLaw& law, const Settings& section, const CohesiveSprings& k,
                    double height) {
  const double area = law.z_curve ? ZCurve::area : LinearSoftening::area;
  const double steepest = law.z_curve ? ZCurve::steepest : LinearSoftening::steepest;
  CohesiveStrength s = law.strength;
  s.tension *= law.onset.rate_limit;  // as strong as a rate may make it
  s.cohesion *= law.onset.rate_limit;
  // Least G_soft over all tractions at insertion is at T0 = c_S f_t (eq:cohesive-16).
  const double tension =
      s.tension * s.tension / k.normal * (0.5 * (1 + area * area) + kLeastOpeningReach * area);
  if (s.tension > 0 && s.energy_tension <= tension)
    refuse_energy(section, "energy_tension", s.energy_tension, tension, height);
  const double shear = kLeastSlipReach * steepest * area * s.cohesion * s.cohesion / k.shear;
  if (s.cohesion > 0 && s.energy_shear <= shear)
    refuse_energy(section, "energy_shear", s.energy_shear, shear, height);
}

}  // namespace

Index append_laws(InterfaceLaws& laws, const Settings& section) {
  const auto first = static_cast<Index>(laws.laws.size());
  const InterfaceLaw mean = read_law(section);
  if (section.has("correlation") && !section.has("scatter"))
    throw section.error("correlation", "strengths that do not scatter have no correlation",
                        "give `scatter` as well, or take this out");
  const std::vector<double> shares =
      section.has("scatter") ? strength_grades(section.number("scatter")) : std::vector<double>{1};
  for (const double share : shares) {
    InterfaceLaw grade = mean;
    grade.strength.tension = grade.onset.tension = mean.strength.tension * share;
    grade.strength.cohesion = grade.onset.cohesion = mean.strength.cohesion * share;
    laws.laws.push_back(grade);
    laws.sections.push_back(&section);
    laws.grades.push_back(static_cast<Index>(shares.size()));
    laws.correlation.push_back(section.has("correlation") ? section.number("correlation") : 0);
  }
  return first;
}

InterfaceLaws read_interface_laws(const Settings& scene, const std::vector<Material>& materials) {
  InterfaceLaws laws;
  laws.materials = static_cast<Index>(materials.size());
  laws.seed = static_cast<int>(scene.at("run").integer("seed"));
  laws.of_materials.assign(materials.size() * materials.size(), kNone);
  for (const Settings& section : scene.children("fracture")) {
    const Index m = require_material(materials, section, "", section.name());
    put(laws, section, "", m, m);
  }
  for (const Settings& section : scene.list("interface")) {
    const std::vector<std::string>& names = section.texts("between");
    if (names.size() != 2 || names[0] == names[1])
      throw section.error("between", "an interface joins two different materials",
                          "write between = [\"one\", \"other\"]; faces inside one material belong "
                          "to its [fracture.NAME]");
    put(laws, section, "between", require_material(materials, section, "between", names[0]),
        require_material(materials, section, "between", names[1]));
  }
  read_existing_laws(scene, laws);
  return laws;
}

template <int D>
std::vector<InterfaceSide> interface_sides(const Model<D>& model) {
  std::vector<InterfaceSide> sides;
  for (std::size_t m = 0; m < model.materials.size(); ++m)
    sides.push_back({model.p_wave_modulus(static_cast<Index>(m)), model.materials[m].mu(),
                     model.materials[m].density});
  return sides;
}

template <int D>
void check_interface_laws(const InterfaceLaws& laws, const Model<D>& model) {
  const std::vector<Heights> heights = face_heights(laws, model);
  const std::vector<InterfaceSide> sides = interface_sides(model);
  for (std::size_t i = 0; i < laws.laws.size(); ++i) {
    const Heights& h = heights[i];
    const InterfaceLaw& law = laws.laws[i];
    const Settings& section = *laws.sections[i];
    if (h.most == 0 && laws.grades[i] > 1) continue;
    if (h.most == 0) {
      log::warning(fmt::format("{}: {} names faces that the mesh does not have", section.place(),
                               section.path()));
      continue;
    }
    const CohesiveSprings k = springs_of(sides[h.material_left], sides[h.material_right], h.most,
                                         law.stiffness_factor, law.damping);
    if (law.fault) continue;
    check_energies(law, section, k, h.most);
    const bool strongest = i + 1 == laws.laws.size() || laws.sections[i + 1] != &section;
    if (law.strength.tension == 0 || !strongest) continue;
    const double young =
        std::min(model.materials[h.material_left].young, model.materials[h.material_right].young);
    const double zone =
        young * law.strength.energy_tension / (3 * law.strength.tension * law.strength.tension);
    if (D * h.most > zone)
      log::warning(fmt::format(
          "{}: elements of {:.3g} m do not resolve the softening zone of {}: E G / (3 f_t^2) is "
          "{:.3g} m; cracks will need more load than they should",
          section.place(), D * h.most, section.path(), zone));
  }
}

// The watch of the element loop has one friction, the least of the material's laws; a law with
// more friction under tension is covered by lowering its cohesion in proportion. The elliptic
// onset lies inside the other one when both strengths are taken at 1/sqrt(2) and friction at alpha.
Onset watch_for(const InterfaceLaws& laws, Index material) {
  Onset watch;
  std::vector<const InterfaceLaw*> list;
  double least = 1e300, most = 0;
  std::vector<Index> candidates = weakest_existing(laws);  // of all bodies: it may be too low
  for (Index other = 0; other < laws.materials; ++other)
    candidates.push_back(laws.between(material, other));  // the first grade is the weakest
  for (const Index i : candidates) {
    if (i == kNone || laws.laws[static_cast<std::size_t>(i)].at_start ||
        laws.laws[static_cast<std::size_t>(i)].fault)
      continue;
    const InterfaceLaw& law = laws.laws[static_cast<std::size_t>(i)];
    list.push_back(&law);
    const double friction = law.onset.friction * (law.onset.elliptic ? law.onset.alpha : 1);
    least = std::min(least, friction);
    most = std::max(most, friction);
  }
  if (list.empty()) return watch;
  watch.friction = least;
  // Without friction to scale, both parts of the bound are doubled instead: their sum covers it.
  const double both = least == 0 && most > 0 ? 2 * std::hypot(1, most) : 1;
  for (const InterfaceLaw* law : list) {
    const double share = law->onset.alpha * (law->onset.elliptic ? std::sqrt(0.5) : 1);
    const double friction = law->onset.friction * (law->onset.elliptic ? law->onset.alpha : 1);
    const double scale = least > 0 ? friction / least : 1;
    const double tension =
        std::max(1 / law->onset.tension, least > 0 ? 0 : friction / law->onset.cohesion);
    watch.per_tension = std::max(watch.per_tension, both * tension / share);
    watch.per_cohesion = std::max(watch.per_cohesion, both * scale / (law->onset.cohesion * share));
  }
  return watch;
}

template std::vector<InterfaceSide> interface_sides<2>(const Model<2>&);
template std::vector<InterfaceSide> interface_sides<3>(const Model<3>&);
template void check_interface_laws<2>(const InterfaceLaws&, const Model<2>&);
template void check_interface_laws<3>(const InterfaceLaws&, const Model<3>&);

}  // namespace breccia
