#include "modules/rigid/rigid.hpp"

#include "fields/rigid_fields.hpp"
#include "step/node_forces.hpp"

#include <algorithm>

namespace breccia {

template <int D>
bool Rigid<D>::wanted(const Settings& scene) {
  const auto& bodies = scene.list("body");
  return std::any_of(bodies.begin(), bodies.end(),
                     [](const Settings& body) { return body.flag("rigid"); });
}

template <int D>
void Rigid<D>::declare(Model<D>& model) {
  for (const Settings& body : model.scene->list("body"))
    if (body.flag("rigid")) bodies_.push_back(find_body(model.mesh, body.name()));
  drives_.resize(bodies_.size());
  Store& s = model.store;
  const auto n = static_cast<Index>(bodies_.size());
  s.set_size(Entity::rigid, n, n);
  s.add<RigidCentre<D>>(key());
  s.add<RigidVelocity<D>>(key());
  s.add<RigidTurn>(key());
  s.add<RigidMomentum>(key());
  s.add<RigidSpin>(key());
  s.add<RigidLoad>(key());
  s.add<RigidUnbalance>(key());
  s.add<RigidChange<D>>(key());
  s.add<RigidOrigin<D>>(key());
  s.add<NodeReaction<D>>(key());
  read_turning(model);
}

template <int D>
void Rigid<D>::bind(Model<D>& model) {
  const auto nodes = find_nodes(model);
  refuse_digging(model, nodes);
  const auto flags = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{},
                                                         model.store.template get<NodeFlags>());
  for (std::size_t b = 0; b < bodies_.size(); ++b) drives_[b] = drive_of(model, b, nodes[b]);
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    for (const Index n : nodes[b]) {
      const std::uint32_t number = static_cast<std::uint32_t>(b) << node_flag::boundary_shift;
      const std::uint32_t fixed = (1u << D) - 1;
      const std::uint32_t kept = flags(n) & ((1u << node_flag::boundary_shift) - 1);
      flags(n) = kept | fixed | node_flag::rigid | number;
    }
  Kokkos::deep_copy(model.store.template get<NodeFlags>(), flags);
  const auto turn = Kokkos::create_mirror_view(model.store.template get<RigidTurn>());
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    for (int i = 0; i < 4; ++i) turn(b, i) = i == 0 ? 1 : 0;
  Kokkos::deep_copy(model.store.template get<RigidTurn>(), turn);
  measure(model, nodes);
  Kokkos::deep_copy(model.store.template get<RigidCentre<D>>(),
                    model.store.template get<RigidOrigin<D>>());
  take_over(model, nodes);
}

template <int D>
void Rigid<D>::resume(Model<D>& model) {
  splits_seen_ = model.splits;
  measure(model, find_nodes(model));
}

template <int D>
void Rigid<D>::enlist(Model<D>& model, Plan& plan) {
  plan.add(Stage::assemble, "rigid::motion", key(),
           [this, &model](const Clock& clock) { move(model, clock); })
      .template reading<NodePosition<D>, NodeMass, NodeFlags, ElementForce<D>>()
      .template writing<RigidCentre<D>, RigidVelocity<D>, RigidTurn, RigidMomentum>();
}

template <int D>
void Rigid<D>::move(Model<D>& model, const Clock& clock) {
  if (splits_seen_ != model.splits) answer_split(model);
  const Store& s = model.store;
  force_.nodes = forces_on_nodes(model);
  force_.x = s.get<NodePosition<D>>();
  force_.centre = s.get<RigidCentre<D>>();
  rigid_forces(static_cast<Index>(part_load_.extent(0)), force_, part_load_);
  motion_.part_load = part_load_;
  motion_.boundary_velocity = s.get_or_empty<BoundaryVelocity<D>>();
  motion_.dt = clock.dt;
  motion_.kick = clock.kick();
  motion_.middle = clock.middle();
  rigid_motion(static_cast<Index>(bodies_.size()), motion_,
               {s.get<RigidCentre<D>>(), s.get<RigidVelocity<D>>(), s.get<RigidTurn>(),
                s.get<RigidMomentum>(), s.get<RigidSpin>(), s.get<RigidLoad>(),
                s.get<RigidUnbalance>(), s.get<RigidChange<D>>()});
}

template <int D>
void Rigid<D>::add_stiffness(Model<D>& model, const Array<double>& stiffness) const {
  const Store& s = model.store;
  rigid_pace<D>(static_cast<Index>(part_load_.extent(0)), force_, motion_.body,
                s.get<RigidVelocity<D>>(), s.get<RigidSpin>(), s.get<NodeMass>(), stiffness);
}

template <int D>
void Rigid<D>::observe(Model<D>& model, const Clock& clock, Moment moment, Row& row) {
  const auto host = [&](const auto& view) {
    return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, view);
  };
  const Store& s = model.store;
  const auto centre = host(s.get<RigidCentre<D>>()), velocity = host(s.get<RigidVelocity<D>>());
  const auto spin = host(s.get<RigidSpin>());
  const auto load = host(s.get<RigidLoad>());
  // Velocities at t^n lie between the half steps in the ratio of their lengths.
  const double all = clock.dt_before + clock.dt;
  const double old = clock.dt_before == 0 ? 1 : all > 0 ? clock.dt / all : 0;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const std::string& name = model.mesh.body_names[static_cast<std::size_t>(bodies_[b])];
    const auto put = [&, moment](const std::string& what, double now) {
      const std::string column = name + "." + what;
      if (moment == Moment::before)
        row.set(column, now);
      else
        row.set(column, old * row.get(column) + (1 - old) * now);
    };
    const auto axis = [](int d) { return std::string(1, "xyz"[d]); };
    const auto about = [&](int d) { return D == 2 ? std::string() : "_" + axis(d); };
    if (moment == Moment::before)
      for (int d = 0; d < D; ++d) row.set(name + "." + axis(d), centre(b, d));
    for (int d = 0; d < D; ++d) put("v" + axis(d), velocity(b, d));
    for (int d = D == 2 ? 2 : 0; d < 3; ++d) put("spin" + about(d), spin(b, d));
    // The force at t^n is known after the step only.
    const double known = moment == Moment::before ? 0 : 1;
    for (int d = 0; d < D; ++d) row.set(name + ".f" + axis(d), known * load(b, d));
    for (int d = D == 2 ? 2 : 0; d < 3; ++d)
      row.set(name + ".torque" + about(d), known * load(b, 3 + d));
  }
}

template <int D>
std::size_t Rigid<D>::bytes() const {
  return part_load_.span() * sizeof(double) +
         (force_.list.span() + 3 * force_.body.span()) * sizeof(Index);
}

template <int D>
void Rigid<D>::archive(Archive& archive) {
  std::vector<std::int64_t> numbers;
  for (const Drive& drive : drives_)
    numbers.insert(numbers.end(), {drive.boundary, drive.components});
  archive.integers("rigid.drives", numbers);
  for (std::size_t b = 0; b < drives_.size(); ++b)
    drives_[b] = {numbers[2 * b], numbers[2 * b + 1]};
}

template class Rigid<2>;
template class Rigid<3>;

}  // namespace breccia
