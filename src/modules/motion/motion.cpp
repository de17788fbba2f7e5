#include "modules/motion/motion.hpp"

#include "base/mat.hpp"
#include "fields/solid_fields.hpp"
#include "modules/motion/motion_fields.hpp"
#include "step/node_forces.hpp"

#include <algorithm>
#include <cmath>

namespace breccia {

// The last class is no force: the nodes do not book it.
static_assert(kWorks + 1 == kForceClasses);

template <int D>
void Motion<D>::declare(Model<D>& model) {
  Store& s = model.store;
  s.add<NodePosition<D>>(key());
  s.add<NodeVelocity<D>>(key());
  s.add<NodeReference<D>>(key());
  s.add<NodeMass>(key());
  s.add<NodeFamily>(key());
  s.add<NodeFlags>(key());
  s.add<NodeCorners>(key());
  s.add<CornerList>(key());
  s.add<FamilyCorners>(key());
  s.add<ElementNodes<D>>(key());
  s.add<ElementReference<D>>(key());
  s.add<ElementMaterial>(key());
  s.add<ElementBody>(key());
  if (model.mixed)
    s.add<ElementForceSingle<D>>(key());
  else
    s.add<ElementForce<D>>(key());
  s.add<ElementRate>(key());
  if (model.scene->at("run").has("mass_scaling")) s.add<NodeAddedMass>(key());
}

namespace {

/// Inverse edge matrices, with edges along material axes, and volumes of the reference mesh.
template <int D>
void fill_reference(const Model<D>& model, std::vector<double>& volume) {
  const auto& view = model.store.template get<ElementReference<D>>();
  const auto host = Kokkos::create_mirror_view(view);
  volume.resize(model.mesh.element.size());
  for (std::size_t e = 0; e < host.extent(0); ++e) {
    // Room behind the last element repeats it, so that a whole pack may be read there.
    const std::size_t from = std::min(e, model.mesh.element.size() - 1);
    Mat<D> g;
    const auto& nodes = model.mesh.element[from];
    for (int j = 0; j < D; ++j)
      for (int i = 0; i < D; ++i)
        g(i, j) = model.mesh.point[nodes[j + 1]][i] - model.mesh.point[nodes[0]][i];
    Mat<D> inverted = inverse(g);
    if (!model.axes.empty()) inverted = inverted * model.axes[from];
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) host(e, i, j) = inverted(i, j);
    if (e < volume.size()) volume[e] = determinant(g) * model.thickness / (D == 2 ? 2.0 : 6.0);
  }
  Kokkos::deep_copy(view, host);
}

}  // namespace

template <int D>
void Motion<D>::bind(Model<D>& model) {
  resume(model);
  make_corners(model);
  Store& s = model.store;
  const Mesh<D>& mesh = model.mesh;
  const auto mass = Kokkos::create_mirror_view(s.get<NodeMass>());
  Kokkos::deep_copy(mass, 0.0);
  for (Index e = 0; e < mesh.elements(); ++e) {
    const double density = model.material_of_body(mesh.body[e]).density;
    for (const Index n : mesh.element[e]) mass(n) += density * volume_[e] / (D + 1);
  }
  Kokkos::deep_copy(s.get<NodeMass>(), mass);
  volume_.clear();

  const auto x = Kokkos::create_mirror_view(s.get<NodePosition<D>>());
  const auto v = Kokkos::create_mirror_view(s.get<NodeVelocity<D>>());
  const auto family = Kokkos::create_mirror_view(s.get<NodeFamily>());
  for (Index n = 0; n < mesh.points(); ++n) {
    family(n) = n;
    for (int d = 0; d < D; ++d) {
      x(n, d) = mesh.point[n][d];
      v(n, d) = initial_.empty() ? 0.0 : initial_[static_cast<std::size_t>(n) * D + d];
    }
  }
  Kokkos::deep_copy(s.get<NodeFamily>(), family);
  Kokkos::deep_copy(s.get<NodePosition<D>>(), x);
  Kokkos::deep_copy(s.get<NodeReference<D>>(), x);
  Kokkos::deep_copy(s.get<NodeVelocity<D>>(), v);
}

template <int D>
void Motion<D>::make_corners(Model<D>& model) {
  Store& s = model.store;
  const Topology<D>& topology = model.topology;
  const auto nodes = Kokkos::create_mirror_view(s.get<ElementNodes<D>>());
  for (std::size_t e = 0; e < nodes.extent(0); ++e)
    for (int a = 0; a <= D; ++a)
      nodes(e, a) = e < model.mesh.element.size() ? model.mesh.element[e][a] : 0;
  const auto range = Kokkos::create_mirror_view(s.get<NodeCorners>());
  for (Index n = 0; n < model.mesh.points(); ++n)
    for (int side = 0; side < 2; ++side) range(n, side) = topology.family_start[n + side];
  const auto list = Kokkos::create_mirror_view(s.get<CornerList>());
  std::copy(topology.family_corner.begin(), topology.family_corner.end(), list.data());
  Kokkos::deep_copy(s.get<ElementNodes<D>>(), nodes);
  Kokkos::deep_copy(s.get<NodeCorners>(), range);
  Kokkos::deep_copy(s.get<CornerList>(), list);
}

template <int D>
void Motion<D>::resume(Model<D>& model) {
  fill_reference(model, volume_);
  Store& s = model.store;
  const auto material = Kokkos::create_mirror_view(s.get<ElementMaterial>());
  const auto body = Kokkos::create_mirror_view(s.get<ElementBody>());
  for (Index e = 0; e < model.elements(); ++e) {
    body(e) = model.mesh.body[e];
    material(e) = model.body_material[body(e)];
  }
  Kokkos::deep_copy(s.get<ElementMaterial>(), material);
  Kokkos::deep_copy(s.get<ElementBody>(), body);
  const auto stretch = Kokkos::create_mirror_view(s.get<FamilyCorners>());
  for (Index n = 0; n < model.mesh.points(); ++n)
    for (int side = 0; side < 2; ++side) stretch(n, side) = model.topology.family_start[n + side];
  Kokkos::deep_copy(s.get<FamilyCorners>(), stretch);
  size_work(model);
}

template <int D>
void Motion<D>::size_work(const Model<D>& model) {
  const auto chunks = chunks_of(model.store.capacity(Entity::node));
  if (work_.extent(0) == 0)
    work_ = ChunkSums<kWorks>("breccia::motion::work", static_cast<std::size_t>(chunks));
  else if (static_cast<Index>(work_.extent(0)) < chunks)
    Kokkos::resize(work_, static_cast<std::size_t>(chunks));
  if (damping_.extent(0) > 0) return;
  std::vector<double> damping;
  for (const Material& material : model.materials) damping.push_back(material.damping);
  damping_ = to_device("breccia::motion::damping", damping);
}

template <int D>
void Motion<D>::enlist(Model<D>& model, Plan& plan) {
  plan.add(Stage::advance, "motion::node_motion", key(),
           [this, &model](const Clock& clock) { move(model, clock); })
      .template reading<ElementForce<D>, NodeCorners, CornerList, NodeMass, NodeFlags>()
      .template writing<NodePosition<D>, NodeVelocity<D>>();
}

template <int D>
void Motion<D>::move(Model<D>& model, const Clock& clock) {
  size_work(model);
  const Store& s = model.store;
  NodeMotionIn<D> in = forces_on_nodes(model);
  in.resisting = model.rest.share;
  if (s.has<ElementAbsorber>()) {
    in.absorber = s.get<ElementAbsorber>();
    in.absorbing = s.get<AbsorberDamping<D>>();
    in.absorb_bit = node_flag::absorb;
  }
  in.dt = clock.dt;
  in.kick = clock.kick();
  const NodeMotionOut<D> out{s.get<NodePosition<D>>(), s.get<NodeVelocity<D>>(),
                             s.get_or_empty<NodeReaction<D>>(), work_};
  node_motion(model.nodes(), in, out);
}

template <int D>
StableStep Motion<D>::stable(const Model<D>& model, const Array<double>& stiffness, Factors factors,
                             bool renew) const {
  const Store& s = model.store;
  StableStepIn<D> in;
  in.elements = model.elements();
  in.nodes = model.nodes();
  in.element_nodes = s.get<ElementNodes<D>>();
  in.x = s.get<NodePosition<D>>();
  in.v = s.get<NodeVelocity<D>>();
  in.reference = s.get<ElementReference<D>>();
  in.material = s.get<ElementMaterial>();
  in.lame = s.get<MaterialLame>();
  in.stress = s.get_or_empty<ElementCauchy<D>>();
  in.modulus = s.get_or_empty<ElementModulus>();
  in.damping = damping_;
  in.corners = s.get<NodeCorners>();
  in.corner_list = s.get<CornerList>();
  in.mass = s.get<NodeMass>();
  in.stiffness = stiffness;
  in.share = s.get_or_empty<ElementShare>();
  in.thickness = model.thickness;
  in.factor_bulk = factors.bulk;
  in.factor_springs = factors.springs;
  in.rate = s.get<ElementRate>();
  in.renew_rates = renew;
  return stable_step(in);
}

template <int D>
double Motion<D>::kinetic_energy(const Model<D>& model) const {
  const auto v = model.store.template get<NodeVelocity<D>>();
  const auto mass = model.store.template get<NodeMass>();
  const ChunkSums<1> rows("breccia::motion::kinetic", chunks_of(model.nodes()));
  for_each_summed<1>(
      "breccia::motion::kinetic", model.nodes(), rows,
      KOKKOS_LAMBDA(Index n, Sums<1> & sum) { sum[0] += 0.5 * mass(n) * norm2(row<D>(v, n)); });
  return total_of(rows)[0];
}

template <int D>
Sums<kWorks> Motion<D>::works(const Model<D>& model) const {
  Sums<kWorks> work = total_of(work_);
  work[static_cast<int>(ForceClass::relaxation)] -= model.rest.taken;
  return work;
}

template <int D>
void Motion<D>::book_before(const Model<D>& model, Ledger& ledger) {
  Store& s = const_cast<Model<D>&>(model).store;
  s.add<NodeVelocityBefore<D>>(key());
  Kokkos::deep_copy(s.get<NodeVelocityBefore<D>>(), s.get<NodeVelocity<D>>());
  const Sums<kWorks> work = works(model);
  for (int k = 0; k < kWorks; ++k) ledger.work_middle[k] = work[k];
  // Mass leaves before the kick, so all of it counts at t^n.
  constexpr int kLeft = static_cast<int>(ForceClass::excavation);
  ledger.work_middle[kLeft] = ledger.work[kLeft] = -model.left_with_mass;
}

template <int D>
void Motion<D>::book_after(const Model<D>& model, const Clock& clock, Ledger& ledger) const {
  const auto before = model.store.template get<NodeVelocityBefore<D>>();
  const auto v = model.store.template get<NodeVelocity<D>>();
  const auto mass = model.store.template get<NodeMass>();
  const ChunkSums<3> rows("breccia::motion::kinetic", chunks_of(model.nodes()));
  for_each_summed<3>(
      "breccia::motion::kinetic", model.nodes(), rows, KOKKOS_LAMBDA(Index n, Sums<3> & sum) {
        const Vec<D> old = row<D>(before, n), now = row<D>(v, n);
        sum[0] += 0.5 * mass(n) * norm2(old);
        sum[1] += 0.5 * mass(n) * dot(old, now);
        sum[2] += 0.5 * mass(n) * norm2(now);
      });
  const Sums<3> kinetic = total_of(rows);
  // The first kick starts at t^n and the closing one ends there.
  const int moment = clock.dt_before == 0 ? 0 : clock.dt == 0 ? 2 : 1;
  ledger.kinetic = kinetic[moment];
  ledger.kinetic_half = kinetic[2];
  const Sums<kWorks> work = works(model);
  for (int k = 0; k < kWorks; ++k) {
    ledger.work[k] = work[k];
    ledger.work_middle[k] += 0.5 * moment * (work[k] - ledger.work_middle[k]);
  }
  const auto spent = [&ledger](ForceClass c) { return -ledger.work_middle[static_cast<int>(c)]; };
  if (model.store.template has<ElementAbsorber>())
    ledger.add("ABSORBED", EnergyKind::dissipated, spent(ForceClass::absorber));
  if (model.rest.wanted) ledger.add("RELAX", EnergyKind::dissipated, spent(ForceClass::relaxation));
}

template <int D>
void Motion<D>::observe(Model<D>& model, const Clock&, Moment moment, Row& row) {
  if (moment == Moment::after) return;
  const auto x = model.store.template get<NodePosition<D>>();
  const auto v = model.store.template get<NodeVelocity<D>>();
  const auto mass = model.store.template get<NodeMass>();
  // With v^(n-1/2) at x^n both momenta are kept to round-off by forces that come in pairs.
  const ChunkSums<7> rows("breccia::motion::momentum", chunks_of(model.nodes()));
  for_each_summed<7>(
      "breccia::motion::momentum", model.nodes(), rows, KOKKOS_LAMBDA(Index n, Sums<7> & sum) {
        Vec<3> at = Vec<3>::zero(), p = Vec<3>::zero();
        for (int d = 0; d < D; ++d) {
          at[d] = x(n, d);
          p[d] = mass(n) * v(n, d);
        }
        const Vec<3> l = cross(at, p);
        sum[0] += mass(n);
        for (int d = 0; d < 3; ++d) {
          sum[1 + d] += p[d];
          sum[4 + d] += l[d];
        }
      });
  const Sums<7> total = total_of(rows);
  row.set("mass", total[0], Merge::sum);
  for (int d = 0; d < D; ++d)
    row.set(std::string("momentum.") + "xyz"[d], total[1 + d], Merge::sum);
  for (int d = D == 2 ? 2 : 0; d < 3; ++d)
    row.set(std::string("angular_momentum.") + "xyz"[d], total[4 + d], Merge::sum);
}

template <int D>
void Motion<D>::archive(Archive& archive) {
  const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, work_);
  std::vector<double> rows(host.data(), host.data() + host.size());
  archive.sums("motion.work", rows, kWorks);
  if (!archive.loading()) return;
  work_ = ChunkSums<kWorks>("breccia::motion::work", rows.size() / kWorks);
  const auto mirror = Kokkos::create_mirror_view(work_);
  std::copy(rows.begin(), rows.end(), mirror.data());
  Kokkos::deep_copy(work_, mirror);
}

template class Motion<2>;
template class Motion<3>;

}  // namespace breccia
