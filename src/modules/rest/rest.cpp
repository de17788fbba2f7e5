#include "modules/rest/rest.hpp"

#include "core/log.hpp"
#include "fields/rigid_fields.hpp"
#include "step/node_forces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace breccia {

namespace {

/// Steps between two looks at the balance of forces.
constexpr std::int64_t kLook = 20;
/// Kinetic over stored energy at rest (ALGORITHMS ).
constexpr double kMotion = 1e-6;

/// When the last ramp, table or excavation of the scene has ended, s.
double end_of_ramps(const Settings& scene) {
  double end = 0;
  const auto take = [&end](const Settings& section) {
    if (section.has("ramp")) end = std::max(end, section.number("ramp"));
    if (section.has("table")) end = std::max(end, section.points("table").back()[0]);
  };
  if (scene.has("gravity")) take(scene.at("gravity"));
  for (const Settings& boundary : scene.list("boundary")) take(boundary);
  for (const Settings& excavation : scene.list("excavate"))
    end = std::max(end, excavation.number("at") + excavation.number("release"));
  return end;
}

double share(double part, double whole) {
  if (part == 0) return 0;
  return whole > 0 ? part / whole : std::numeric_limits<double>::infinity();
}

}  // namespace

template <int D>
void RestModule<D>::declare(Model<D>& model) {
  const Settings& rest = model.scene->at("run.rest");
  by_kinetic_ = rest.text("method") == "kinetic";
  then_stop_ = rest.text("then") == "stop";
  tolerance_ = rest.number("tolerance");
  after_ = rest.has("after") ? rest.number("after") : end_of_ramps(*model.scene);
  model.rest.wanted = true;
  if (!by_kinetic_) model.rest.share = rest.has("share") ? rest.number("share") : 0.8;
  model_ = &model;
}

template <int D>
void RestModule<D>::resume(Model<D>& model) {
  size_rows(std::max(model.store.capacity(Entity::node), model.store.count(Entity::corner)));
}

template <int D>
void RestModule<D>::size_rows(Index entities) {
  const auto chunks = static_cast<std::size_t>(chunks_of(entities));
  if (rows_.extent(0) < chunks) rows_ = ChunkSums<1>("breccia::rest::rows", chunks);
}

template <int D>
void RestModule<D>::enlist(Model<D>& model, Plan& plan) {
  if (by_kinetic_) {
    plan.add(Stage::search, "rest::watch", key(), [this, &model](const Clock&) { watch(model); })
        .template reading<NodeMass, NodeVelocity<D>>();
    plan.add(Stage::observe, "rest::take", key(), [this, &model](const Clock&) { take(model); })
        .template writing<NodeVelocity<D>>();
  }
  plan.add(Stage::split, "rest::look", key(),
           [this, &model](const Clock& clock) { look(model, clock); })
      .template reading<ElementForce<D>, NodeMass>();
}

template <int D>
double RestModule<D>::kinetic(const Model<D>& model) {
  size_rows(model.store.capacity(Entity::node));
  return kinetic_energy<D>(model.nodes(), model.store.template get<NodeMass>(),
                           model.store.template get<NodeVelocity<D>>(), rows_);
}

template <int D>
void RestModule<D>::watch(Model<D>& model) {
  if (model.rest.reached) return;
  const double now = kinetic(model);
  model.rest.due = now < before_;
  before_ = model.rest.due ? 0 : now;
}

template <int D>
void RestModule<D>::take(Model<D>& model) {
  if (!model.rest.due) return;
  model.rest.taken += kinetic(model);
  const Store& s = model.store;
  hold_still<D>(model.nodes(), s.get<NodeVelocity<D>>());
  if (s.has<RigidVelocity<D>>()) {
    Kokkos::deep_copy(s.get<RigidVelocity<D>>(), 0.0);
    Kokkos::deep_copy(s.get<RigidMomentum>(), 0.0);
    Kokkos::deep_copy(s.get<RigidSpin>(), 0.0);
  }
  model.rest.due = false;
}

template <int D>
void RestModule<D>::look(Model<D>& model, const Clock& clock) {
  Rest& rest = model.rest;
  if (rest.reached || clock.step % kLook != 0 || clock.time < after_) return;
  const Store& s = model.store;
  NodeBalance balance =
      node_balance(model.nodes(), s.count(Entity::corner), forces_on_nodes(model), rows_);
  if (s.has<RigidUnbalance>())
    for (const double f : to_host(s.get<RigidUnbalance>(), s.count(Entity::rigid)))
      balance.largest = std::max(balance.largest, f);
  rest.unbalance = share(balance.largest, balance.corner);
  if (!(rest.unbalance < tolerance_)) return;
  rest.motion = share(kinetic(model), model.stored_energy());
  if (!(rest.motion < kMotion)) return;
  rest.reached = true;
  rest.stops = then_stop_;
  rest.time = clock.time;
  rest.share = 0;
  log::info(
      fmt::format("at rest after {:.6g} s (step {}): largest net force {:.2g} of the mean "
                  "force on a corner, kinetic energy {:.2g} of the stored",
                  clock.time, clock.step, rest.unbalance, rest.motion));
}

template <int D>
void RestModule<D>::archive(Archive& archive) {
  Rest& rest = model_->rest;
  std::int64_t reached = rest.reached ? 1 : 0;
  archive.integer("rest.reached", reached);
  rest.reached = reached != 0;
  if (rest.reached) rest.share = 0;
  archive.number("rest.time", rest.time);
  archive.number("rest.unbalance", rest.unbalance);
  archive.number("rest.motion", rest.motion);
  archive.number("rest.taken", rest.taken);
  archive.number("rest.before", before_);
}

template class RestModule<2>;
template class RestModule<3>;

}  // namespace breccia
