#include "modules/solid/solid.hpp"

#include "fields/solid_fields.hpp"
#include "loops/element_laws.hpp"
#include "mesh/geometry.hpp"
#include "step/anisotropy.hpp"
#include "step/stress_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

namespace breccia {

namespace {

/// Below this ratio of volumes an element counts as collapsed (ALGORITHMS ).
constexpr double kSmallestJacobian = 0.1;
constexpr Index kNobody = std::numeric_limits<Index>::max();

/// The law of a block that remembers: that of its material, or none for an elastic one that begins
/// under stress.
PlasticLaw law_of(const Material& material) {
  if (material.yields()) return material.plastic;
  NoYield elastic;
  elastic.bulk = material.bulk();
  elastic.shear = material.mu();
  return elastic;
}

/// The initial stress of an element along its material axes.
template <int D>
Sym<3> along_axes(const Model<D>& model, Index e) {
  const Sym<3>& stress = model.initial_stress[e];
  if (model.axes.empty()) return stress;
  Mat<3> back = Mat<3>::identity();
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) back(j, i) = model.axes[e](i, j);
  return congruent(back, stress);
}

/// Elastic strain of the initial stress along material axes.
template <int D>
Sym<3> start_strain(const Model<D>& model, Index e, const Material& material) {
  if (model.initial_stress.empty()) return Sym<3>::zero();
  const Sym<3> stress = along_axes(model, e);
  if (material.stiffness) return strain_of(*material.stiffness, stress);
  const double mean = trace(stress) / 3;
  Sym<3> strain = stress * (0.5 / material.mu());
  for (int i = 0; i < 3; ++i)
    strain.s[i] += mean * (1 / (3 * material.bulk()) - 0.5 / material.mu());
  return strain;
}

Sym<3> exponential(const Sym<3>& a) {
  Principal<3> p = principal_of(a);
  for (double& value : p.value) value = std::exp(value);
  return p.with(p.value);
}

void archive_rows(Archive& archive, std::size_t block, ElementSums& rows) {
  const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, rows);
  std::vector<double> values(host.data(), host.data() + host.size());
  archive.sums(fmt::format("solid.sums.{}", block), values, element_sum::count);
  if (!archive.loading()) return;
  rows = ElementSums("breccia::solid::sums", values.size() / element_sum::count);
  const auto mirror = Kokkos::create_mirror_view(rows);
  std::copy(values.begin(), values.end(), mirror.data());
  Kokkos::deep_copy(rows, mirror);
}

}  // namespace

template <int D>
bool Solid<D>::remembers(const Model<D>& model, const Block& block) const {
  const Material& material = model.materials[block.material];
  if (material.rigid) return false;
  return material.yields() || material.eos || !model.initial_stress.empty();
}

template <int D>
void Solid<D>::declare(Model<D>& model) {
  Store& s = model.store;
  s.add<MaterialLame>(key());
  bool stress = s.has<ElementShare>(), memory = false, modulus = false;
  for (const Block& block : model.blocks) {
    const Material& material = model.materials[block.material];
    memory = memory || remembers(model, block);
    stress = stress || memory || material.stiffness || block.group > 1;
    modulus = modulus || material.eos || material.viscosity.on();
  }
  if (stress) s.add<ElementCauchy<D>>(key());
  if (memory) s.add<ElementElastic<D>>(key());
  if (memory) s.add<ElementHistory>(key());
  if (modulus) s.add<ElementModulus>(key());
  model.stored_in = [this, &model](std::size_t block) { return stored(model, block); };
}

template <int D>
void Solid<D>::bind(Model<D>& model) {
  sums_.clear();
  for (const Block& block : model.blocks)
    sums_.emplace_back("breccia::solid::sums", chunks_of(block.end - block.begin));
  if (model.store.template has<ElementElastic<D>>()) set_start(model);
  resume(model);
}

/// Elements at rest: no plastic flow, the elastic strain of the initial stress, the equation of
/// state at its start.
template <int D>
void Solid<D>::set_start(Model<D>& model) {
  const auto elastic = Kokkos::create_mirror_view(model.store.template get<ElementElastic<D>>());
  const auto history = Kokkos::create_mirror_view(model.store.template get<ElementHistory>());
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const Block& block = model.blocks[b];
    const Material& material = model.materials[block.material];
    if (material.rigid) continue;
    double stored = 0;
    for (Index e = block.begin; e < block.end; ++e) {
      if (material.eos) {
        const EosState start = material.eos->start();
        history(e, eos_place::energy) = start.e;
        history(e, eos_place::pressure) = start.p;
        history(e, eos_place::distension) = start.alpha;
        history(e, eos_place::density) = start.rho;
      }
      const Sym<3> strain = start_strain(model, e, material);
      const Sym<3> metric = material.stiffness ? strain : exponential(strain * 2.0);
      for (int i = 0; i < FullSym<D>::size; ++i)
        elastic(e, i) = metric.s[D == 3 ? i : i == 2 ? 5 : i == 3 ? 2 : i];
      if (!model.initial_stress.empty())
        stored += 0.5 * contract(along_axes(model, e), strain) * model.thickness *
                  signed_volume<D>(corners(model.mesh, e));
    }
    const auto sums = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, sums_[b]);
    sums(0, element_sum::stored) = stored;
    Kokkos::deep_copy(sums_[b], sums);
  }
  Kokkos::deep_copy(model.store.template get<ElementElastic<D>>(), elastic);
  Kokkos::deep_copy(model.store.template get<ElementHistory>(), history);
}

template <int D>
void Solid<D>::resume(Model<D>& model) {
  const auto lame = Kokkos::create_mirror_view(model.store.template get<MaterialLame>());
  anisotropic_.resize(model.materials.size());
  for (std::size_t m = 0; m < model.materials.size(); ++m) {
    const Material& material = model.materials[m];
    lame(m, 0) = D == 2 && model.plane_stress ? material.lambda_plane_stress() : material.lambda();
    lame(m, 1) = material.mu();
    if (material.rigid) lame(m, 0) = lame(m, 1) = 0;  // neither stress nor a limit of the step
    // The time step looks at lambda + 2 mu.
    if (!material.stiffness) continue;
    anisotropic_[m] = anisotropic_state(model, material);
    lame(m, 0) = anisotropic_[m].modulus - 2 * material.mu();
  }
  Kokkos::deep_copy(model.store.template get<MaterialLame>(), lame);
  for (std::size_t b = 0; b < sums_.size(); ++b) {
    const auto rows =
        static_cast<std::size_t>(chunks_of(model.blocks[b].end - model.blocks[b].begin));
    if (sums_[b].extent(0) < rows) Kokkos::resize(sums_[b], rows);
    if (!model.part.whole())
      Kokkos::deep_copy(Kokkos::subview(sums_[b], Kokkos::ALL, int(element_sum::stored)), 0.0);
  }
  bad_ = Array<Index>("breccia::solid::bad", 1);
  Kokkos::deep_copy(bad_, kNobody);
}

template <int D>
void Solid<D>::enlist(Model<D>& model, Plan& plan) {
  plan.add(Stage::element_force, "solid::element_force", key(),
           [this, &model](const Clock& clock) { forces(model, clock); })
      .template reading_ghosts<NodePosition<D>, NodeVelocity<D>>()
      .template writing<ElementForce<D>, ElementHot>();
}

template <int D>
ElementForceIn<D> Solid<D>::input(const Model<D>& model, const Block& block,
                                  const Clock& clock) const {
  const Store& s = model.store;
  const Material& material = model.materials[block.material];
  const bool flat = D == 2 && model.plane_stress;
  ElementForceIn<D> in;
  in.nodes = s.get<ElementNodes<D>>();
  in.x = s.get<NodePosition<D>>();
  in.v = s.get<NodeVelocity<D>>();
  in.reference = s.get<ElementReference<D>>();
  in.begin = block.begin;
  in.end = block.end;
  in.group = block.group;
  in.law = {flat ? material.lambda_plane_stress() : material.lambda(), material.mu()};
  in.flat = flat;
  in.density = material.density;
  in.shock_quadratic = material.viscosity.quadratic;
  in.shock_linear = material.viscosity.linear;
  if (!model.whole(block)) in.share = s.get<ElementShare>();
  in.wave_speed = std::sqrt(model.p_wave_modulus(block.material) / material.density);
  in.damping = material.damping;
  in.kick = clock.kick();
  in.lag = 0.5 * clock.dt_before;
  in.dt = clock.dt_before;
  in.thickness = model.thickness;
  in.smallest_jacobian = kSmallestJacobian;
  in.own = model.part.own;
  // An upper bound stays one if strengths are lower by more than single precision rounds.
  const double cautious = model.mixed ? 1 + 1e-5 : 1;
  in.watch = StressWatch<D>(block.watch.per_tension * cautious, block.watch.per_cohesion * cautious,
                            block.watch.friction);
  return in;
}

template <int D>
AnisotropicState<D> Solid<D>::anisotropic_state(const Model<D>& model,
                                                const Material& material) const {
  const bool flat = D == 2 && model.plane_stress;
  const Anisotropic law = flat ? plane_stress_of(*material.stiffness) : *material.stiffness;
  FullTensors<D> initial;
  if (!model.initial_stress.empty()) initial = model.store.template get<ElementElastic<D>>();
  return {law, fastest_modulus(law, D), initial};
}

template <int D>
void Solid<D>::forces(Model<D>& model, const Clock& clock) {
  const Store& s = model.store;
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const Block& block = model.blocks[b];
    if (model.gone(block)) continue;
    const Material& material = model.materials[block.material];
    if (material.rigid) continue;
    const ElementForceIn<D> in = input(model, block, clock);
    const ElementForceOut<D> out{s.get_or_empty<ElementForce<D>>(),
                                 s.get_or_empty<ElementForceSingle<D>>(),
                                 s.get_or_empty<ElementHot>(),
                                 bad_,
                                 sums_[b],
                                 s.get_or_empty<ElementCauchy<D>>(),
                                 s.get_or_empty<ElementModulus>()};
    if (material.stiffness && model.mixed)
      anisotropic_force_single(in, out, anisotropic_[block.material]);
    else if (material.stiffness)
      anisotropic_force(in, out, anisotropic_[block.material]);
    else if (remembers(model, block))
      inelastic_force(in, out, law_of(material),
                      {s.get<ElementElastic<D>>(), s.get<ElementHistory>(),
                       material.eos.has_value(), material.eos.value_or(Eos{})});
    else if (model.mixed)
      element_force_single(in, out);
    else
      element_force(in, out);
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
double Solid<D>::stored(const Model<D>& model, std::size_t b) const {
  const Block& block = model.blocks[b];
  if (model.gone(block)) return 0;
  return remembers(model, block) || model.materials[block.material].stiffness
             ? total_of(sums_[b])[element_sum::stored]
             : strain_energy(stress_of(model), block.begin, block.end, block.group);
}

template <int D>
void Solid<D>::book(Model<D>& model, Ledger& ledger) const {
  double elastic = 0, viscous = 0, plastic = 0, shock = 0;
  bool damped = false, yields = false, shocked = false;
  for (std::size_t b = 0; b < sums_.size(); ++b) {
    const Block& block = model.blocks[b];
    const Material& material = model.materials[block.material];
    if (material.rigid) continue;
    const Sums<element_sum::count> sums = total_of(sums_[b]);
    elastic += stored(model, b);
    damped = damped || material.damping > 0;
    viscous += sums[element_sum::viscous];
    // With an equation of state the heat of flow and of shocks is in the stored energy.
    if (material.eos) continue;
    yields = yields || material.yields();
    plastic += sums[element_sum::plastic];
    shocked = shocked || material.viscosity.on();
    shock += sums[element_sum::shock];
  }
  ledger.add("IE_elastic", EnergyKind::stored, elastic);
  if (damped) ledger.add("D_viscous", EnergyKind::dissipated, viscous);
  if (yields) ledger.add("D_plastic", EnergyKind::dissipated, plastic);
  if (shocked) ledger.add("D_bulkq", EnergyKind::dissipated, shock);
}

template <int D>
void Solid<D>::draw(Model<D>& model, Picture& picture) const {
  const auto sigma = Kokkos::create_mirror_view_and_copy(
      Kokkos::HostSpace{}, cauchy_stress(stress_of(model), model.elements()));
  PictureField stress{"stress", "Pa", 6, {}};
  PictureField mises{"von_mises", "Pa", 1, {}};
  for (Index e = 0; e < model.elements(); ++e) {
    Sym<3> s = Sym<3>::zero();
    for (int i = 0; i < D; ++i)
      for (int j = i; j < D; ++j) s(i, j) = sigma(e, Sym<D>::at(i, j));
    if (D == 2) s(2, 2) = sigma(e, 3);
    for (const double value : {s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(1, 2), s(0, 2)})
      stress.values.push_back(value);
    const double mean = trace(s) / 3;
    for (int i = 0; i < 3; ++i) s(i, i) -= mean;
    mises.values.push_back(std::sqrt(1.5 * contract(s, s)));
  }
  picture.element_fields.push_back(std::move(stress));
  picture.element_fields.push_back(std::move(mises));
  draw_history(model, picture);
}

/// What laws remember, by name; zero where a material does not know the name.
template <int D>
void Solid<D>::draw_history(const Model<D>& model, Picture& picture) const {
  if (!model.store.template has<ElementHistory>()) return;
  const auto history = Kokkos::create_mirror_view_and_copy(
      Kokkos::HostSpace{}, model.store.template get<ElementHistory>());
  const std::size_t first = picture.element_fields.size();
  for (const Block& block : model.blocks)
    std::visit(
        [&](const auto& law) {
          for (std::size_t k = 0; k < law.kHistoryEntries.size(); ++k) {
            const HistoryEntry& entry = law.kHistoryEntries[k];
            auto field =
                std::find_if(picture.element_fields.begin() + first, picture.element_fields.end(),
                             [&](const PictureField& f) { return f.name == entry.name; });
            if (field == picture.element_fields.end())
              field = picture.element_fields.insert(
                  field, {entry.name, entry.unit, 1, std::vector<double>(model.elements(), 0.0)});
            for (Index e = block.begin; e < block.end; ++e)
              field->values[static_cast<std::size_t>(e)] = history(e, k);
          }
        },
        model.materials[block.material].plastic);
}

template <int D>
void Solid<D>::archive(Archive& archive) {
  std::int64_t blocks = static_cast<std::int64_t>(sums_.size());
  archive.integer("solid.blocks", blocks);
  sums_.resize(static_cast<std::size_t>(blocks));
  for (std::size_t b = 0; b < sums_.size(); ++b) archive_rows(archive, b, sums_[b]);
}

template class Solid<2>;
template class Solid<3>;

}  // namespace breccia
