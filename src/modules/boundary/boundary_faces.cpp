// What acts on faces: tractions, pressures, boundaries that let waves out.
#include "modules/boundary/boundary.hpp"
#include "point/absorbing.hpp"
#include "step/selection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace breccia {

namespace {

/// Outward normal times reference area of a face, m2 (length times thickness in the plane).
template <int D>
Vec<D> face_area(const Model<D>& model, const ElementFace& face) {
  Vec<D> x[D];
  for (int j = 0; j < D; ++j) {
    const Index n = model.mesh.element[face.element][face_node<D>(face.face, j)];
    for (int d = 0; d < D; ++d) x[j][d] = model.mesh.point[n][d];
  }
  return area_vector(x) * model.thickness;
}

/// rho c_p and rho c_s of an element, kg/(m2 s).
template <int D>
struct Impedance {
  double p, s;
  Impedance(const Model<D>& model, Index element) {
    const Index material = model.body_material[model.mesh.body[element]];
    const double density = model.materials[material].density;
    p = std::sqrt(density * model.p_wave_modulus(material));
    s = std::sqrt(density * model.materials[material].mu());
  }
};

/// Traction that the initial stress of an element exerts on its surface, times the area, N.
template <int D>
Vec<D> initial_force(const Model<D>& model, const ElementFace& face) {
  if (model.initial_stress.empty()) return Vec<D>::zero();
  const Vec<D> area = face_area(model, face);
  Vec<D> force = Vec<D>::zero();
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) force[i] += model.initial_stress[face.element](i, j) * area[j];
  return force;
}

}  // namespace

template <int D>
Vec<D> Boundary<D>::dead_force(const Model<D>& model, const Settings& section,
                               const ElementFace& face) const {
  Vec<D> given = Vec<D>::zero();
  const Vec<D> area = face_area(model, face);
  if (section.has("traction")) {
    for (int d = 0; d < D; ++d) given[d] = section.vector("traction")[d];
    return given * norm(area);
  }
  if (!section.has("input")) return given;
  for (int d = 0; d < D; ++d) given[d] = section.vector("input")[d];
  const Impedance<D> z(model, face.element);
  // eq:boundary-3: what comes in carries half of it, the resistance of the boundary takes the rest.
  return (absorbing_matrix(area * (1 / norm(area)), norm(area), z.p, z.s) * given) * 2.0;
}

template <int D>
void Boundary<D>::load(const Model<D>& model, Index law, const Region& region,
                       const Settings& section) {
  bool none = true;
  const bool absorbs = section.has("non_reflecting"), held = section.has("held");
  for (const ElementFace& face : region.faces) {
    if (!std::binary_search(model.topology.free.begin(), model.topology.free.end(), face)) continue;
    none = false;
    if (absorbs) let_out(model, law, face, section);
    if (absorbs || held) {
      const Vec<D> force = initial_force(model, face);
      if (norm(force) > 0) face_loads_[face].push_back({constant_, force});
    }
    if (!held && (!absorbs || section.has("input"))) {
      FaceLoad load = pressure_on(model, law, face);
      load.dead = dead_force(model, section, face);
      face_loads_[face].push_back(load);
    }
  }
  if (section.has("on_new_faces")) start_spreading(model, law, region, section);
  if (none && !model.mesh.partial)
    throw section.error(
        "", "a traction or pressure needs free faces and none lies there",
        "choose a side of a body (such as \"disc.rim\"), or a plane on its surface");
  if (held && model.initial_stress.empty())
    throw section.error("held", "the scene has no [[initial_stress]] to hold");
}

template <int D>
void Boundary<D>::let_out(const Model<D>& model, Index law, const ElementFace& face,
                          const Settings& section) {
  const auto [other, fresh] = absorbing_.try_emplace(face, law);
  if (!fresh)
    throw section.error("non_reflecting",
                        fmt::format("a face of element {} lets waves out twice", face.element),
                        fmt::format("make this boundary and the one at {} apart",
                                    model.scene->list("boundary")[other->second].place()));
}

template <int D>
void Boundary<D>::make_absorbers(Model<D>& model) {
  const auto row = Kokkos::create_mirror_view(model.store.template get<ElementAbsorber>());
  Kokkos::deep_copy(row, kNone);
  const auto damping = Kokkos::create_mirror_view(model.store.template get<AbsorberDamping<D>>());
  Kokkos::deep_copy(damping, 0.0);
  Index rows = 0;
  for (const auto& [face, law] : absorbing_) {
    if (row(face.element) == kNone) row(face.element) = rows++;
    const Vec<D> area = face_area(model, face);
    const Impedance<D> z(model, face.element);
    const Sym<D> c = absorbing_matrix(area * (1 / norm(area)), norm(area) / D, z.p, z.s);
    for (int j = 0; j < D; ++j)
      for (int i = 0; i < Sym<D>::size; ++i)
        damping(row(face.element), face_node<D>(face.face, j), i) += c.s[i];
  }
  Kokkos::deep_copy(model.store.template get<ElementAbsorber>(), row);
  Kokkos::deep_copy(model.store.template get<AbsorberDamping<D>>(), damping);
}

template <int D>
void Boundary<D>::make_faces() {
  std::vector<Index> element, face, law;
  std::vector<Vec<D>> dead;
  std::vector<std::array<double, 2>> reaches;
  std::vector<std::array<Index, 2>> range;
  for (const auto& [where, loads] : face_loads_) {
    if (element.empty() || element.back() != where.element) {
      element.push_back(where.element);
      range.push_back({static_cast<Index>(face.size()), static_cast<Index>(face.size())});
    }
    for (const FaceLoad& load : loads) {
      face.push_back(where.face);
      law.push_back(load.law);
      dead.push_back(load.dead);
      reaches.push_back({load.share, load.delay});
    }
    range.back()[1] = static_cast<Index>(face.size());
  }
  load_.element = to_device("breccia::boundary::element", element);
  load_.face = to_device("breccia::boundary::face", face);
  load_.face_law = to_device("breccia::boundary::face_law", law);
  const Vectors<2> reach("breccia::boundary::reach", reaches.size());
  const auto host_reach = Kokkos::create_mirror_view(reach);
  for (std::size_t i = 0; i < reaches.size(); ++i)
    for (int j = 0; j < 2; ++j) host_reach(i, j) = reaches[i][j];
  Kokkos::deep_copy(reach, host_reach);
  load_.reach = reach;
  const Vectors<D> forces("breccia::boundary::dead", dead.size());
  const auto host_forces = Kokkos::create_mirror_view(forces);
  for (std::size_t i = 0; i < dead.size(); ++i)
    for (int d = 0; d < D; ++d) host_forces(i, d) = dead[i][d];
  Kokkos::deep_copy(forces, host_forces);
  load_.dead = forces;
  Ranges ranges("breccia::boundary::faces", range.size());
  const auto host = Kokkos::create_mirror_view(ranges);
  for (std::size_t i = 0; i < range.size(); ++i)
    for (int j = 0; j < 2; ++j) host(i, j) = range[i][j];
  Kokkos::deep_copy(ranges, host);
  load_.faces = ranges;
}

template class Boundary<2>;
template class Boundary<3>;

}  // namespace breccia
