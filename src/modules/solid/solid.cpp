#include "modules/solid/solid.hpp"

#include "loops/element_force.hpp"
#include "loops/element_stress.hpp"

#include <fmt/format.h>

#include <cmath>

namespace breccia {

namespace {

/// Below this ratio of volumes an element counts as collapsed (ALGORITHMS ).
constexpr double kSmallestJacobian = 0.1;
constexpr Index kNobody = std::numeric_limits<Index>::max();

template <int D>
ElementStress<D> stress_of(const Model<D>& model) {
  const Store& s = model.store;
  return {s.get<ElementNodes<D>>(), s.get<NodePosition<D>>(), s.get<ElementReference<D>>(),
          s.get<ElementMaterial>(), s.get<MaterialLame>(),    model.thickness};
}

void archive_rows(Archive& archive, std::size_t block, ChunkSums<1>& rows) {
  const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, rows);
  std::vector<double> values(host.data(), host.data() + host.size());
  archive.numbers(fmt::format("solid.viscous.{}", block), values);
  if (!archive.loading()) return;
  rows = ChunkSums<1>("breccia::solid::viscous", values.size());
  const auto mirror = Kokkos::create_mirror_view(rows);
  std::copy(values.begin(), values.end(), mirror.data());
  Kokkos::deep_copy(rows, mirror);
}

}  // namespace

template <int D>
void Solid<D>::declare(Model<D>& model) {
  model.store.template add<MaterialLame>(key());
}

template <int D>
void Solid<D>::bind(Model<D>& model) {
  viscous_.clear();
  for (const Block& block : model.blocks)
    viscous_.emplace_back("breccia::solid::viscous", chunks_of(block.end - block.begin));
  resume(model);
}

template <int D>
void Solid<D>::resume(Model<D>& model) {
  const auto lame = Kokkos::create_mirror_view(model.store.template get<MaterialLame>());
  for (std::size_t m = 0; m < model.materials.size(); ++m) {
    const Material& material = model.materials[m];
    lame(m, 0) = D == 2 && model.plane_stress ? material.lambda_plane_stress() : material.lambda();
    lame(m, 1) = material.mu();
  }
  Kokkos::deep_copy(model.store.template get<MaterialLame>(), lame);
  bad_ = Array<Index>("breccia::solid::bad", 1);
  Kokkos::deep_copy(bad_, kNobody);
}

template <int D>
void Solid<D>::enlist(Model<D>& model, Plan& plan) {
  plan.add(Stage::element_force, "solid::element_force", key(),
           [this, &model](const Clock& clock) { forces(model, clock); })
      .template reading<NodePosition<D>, NodeVelocity<D>>()
      .template writing<ElementForce<D>, ElementHot>();
}

template <int D>
void Solid<D>::forces(Model<D>& model, const Clock& clock) {
  const Store& s = model.store;
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const Block& block = model.blocks[b];
    const Material& material = model.materials[block.material];
    const double lambda =
        D == 2 && model.plane_stress ? material.lambda_plane_stress() : material.lambda();
    ElementForceIn<D> in;
    in.nodes = s.get<ElementNodes<D>>();
    in.x = s.get<NodePosition<D>>();
    in.v = s.get<NodeVelocity<D>>();
    in.reference = s.get<ElementReference<D>>();
    in.begin = block.begin;
    in.end = block.end;
    in.law = {lambda, material.mu()};
    in.wave_speed = std::sqrt(model.p_wave_modulus(block.material) / material.density);
    in.damping = material.damping;
    in.kick = clock.kick();
    in.lag = 0.5 * clock.dt_before;
    in.thickness = model.thickness;
    in.smallest_jacobian = kSmallestJacobian;
    in.watch = {block.watch.per_tension, block.watch.per_cohesion, block.watch.friction};
    element_force(in, ElementForceOut<D>{s.get<ElementForce<D>>(), s.get_or_empty<ElementHot>(),
                                         bad_, viscous_[b]});
  }
  // The flag is read each step where that is free, now and then where it waits for a device.
  if (kOnDevice && clock.step % 32 != 0) return;
  const Index bad = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, bad_)(0);
  if (bad != kNobody) stop_at(model, bad, clock);
}

template <int D>
void Solid<D>::stop_at(Model<D>& model, Index element, const Clock& clock) const {
  const auto x = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{},
                                                     model.store.template get<NodePosition<D>>());
  const auto nodes = Kokkos::create_mirror_view_and_copy(
      Kokkos::HostSpace{}, model.store.template get<ElementNodes<D>>());
  std::string place;
  bool finite = true;
  for (int d = 0; d < D; ++d) {
    double centre = 0;
    for (int a = 0; a <= D; ++a) centre += x(nodes(element, a), d) / (D + 1);
    finite = finite && std::isfinite(centre);
    place += fmt::format("{}{:.6g}", d ? ", " : "", centre);
  }
  const std::string& body = model.mesh.body_names[model.mesh.body[element]];
  model.stop.raised = true;
  model.stop.cause =
      finite ? fmt::format(
                   "element {} of body '{}' at ({}) m has less than {:.0f} % of its volume "
                   "at time {:.6g} s (step {}): it is about to invert; likely causes are "
                   "a load beyond what the mesh can follow, missing [contact] between "
                   "bodies, or elements too large for the deformation",
                   element, body, place, 100 * kSmallestJacobian, clock.time, clock.step)
             : fmt::format(
                   "element {} of body '{}' has a non-finite position at time {:.6g} s "
                   "(step {}): the state blew up; likely causes are a step that is not "
                   "stable (run.step, run.step_factor) or a load that is not finite",
                   element, body, clock.time, clock.step);
}

template <int D>
void Solid<D>::book(Model<D>& model, Ledger& ledger) const {
  ledger.add("IE_elastic", EnergyKind::stored, strain_energy(stress_of(model), model.elements()));
  double viscous = 0;
  bool damped = false;
  for (std::size_t b = 0; b < viscous_.size(); ++b) {
    damped = damped || model.materials[model.blocks[b].material].damping > 0;
    viscous += total_of(viscous_[b])[0];
  }
  if (damped) ledger.add("D_viscous", EnergyKind::dissipated, viscous);
}

template <int D>
void Solid<D>::draw(Model<D>& model, Picture& picture) const {
  const auto sigma = Kokkos::create_mirror_view_and_copy(
      Kokkos::HostSpace{}, cauchy_stress(stress_of(model), model.elements()));
  PictureField stress{"stress", "Pa", 6, {}};
  PictureField mises{"von_mises", "Pa", 1, {}};
  for (Index e = 0; e < model.elements(); ++e) {
    const double poisson = model.material_of_body(model.mesh.body[e]).poisson;
    Sym<3> s = Sym<3>::zero();
    for (int i = 0; i < D; ++i)
      for (int j = i; j < D; ++j) s(i, j) = sigma(e, Sym<D>::at(i, j));
    if (D == 2 && !model.plane_stress) s(2, 2) = poisson * (s(0, 0) + s(1, 1));
    for (const double value : {s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(1, 2), s(0, 2)})
      stress.values.push_back(value);
    const double mean = trace(s) / 3;
    for (int i = 0; i < 3; ++i) s(i, i) -= mean;
    mises.values.push_back(std::sqrt(1.5 * contract(s, s)));
  }
  picture.element_fields.push_back(std::move(stress));
  picture.element_fields.push_back(std::move(mises));
}

template <int D>
void Solid<D>::archive(Archive& archive) {
  std::int64_t blocks = static_cast<std::int64_t>(viscous_.size());
  archive.integer("solid.blocks", blocks);
  viscous_.resize(static_cast<std::size_t>(blocks));
  for (std::size_t b = 0; b < viscous_.size(); ++b) archive_rows(archive, b, viscous_[b]);
}

template class Solid<2>;
template class Solid<3>;

}  // namespace breccia
