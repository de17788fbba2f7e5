#pragma once
#include "io/scene_reader.hpp"
#include "modules/boundary/boundary.hpp"
#include "modules/fracture/fracture.hpp"
#include "modules/fracture/fracture_fields.hpp"
#include "modules/motion/motion.hpp"
#include "modules/solid/solid.hpp"
#include "scene/commands.hpp"
#include "scene/model_builder.hpp"

#include <functional>
#include <string>
#include <vector>

namespace breccia {

/// A small scene whose steps a test takes apart: stages one by one, fields on the host.
template <int D>
class FractureWorld {
 public:
  using Edit = std::function<void(Model<D>&)>;

  /// `edit` may change the mesh's bodies before fields are made.
  explicit FractureWorld(const std::string& scene, const Edit& edit = {}) {
    Schema schema;
    declare_schema(schema);
    settings_ = schema.resolve(read_scene_text(scene, "test"));
    build_model(settings_, ".", model);
    if (edit) edit(model);
    for (Module<D>* module : modules()) module->declare(model);
    for (Module<D>* module : modules()) module->enlist(model, plan);
    std::vector<std::string> initial;
    for (const auto& block : model.store.blocks()) initial.emplace_back(block.info.name);
    plan.finish(initial);
  }

  void start() {
    for (Module<D>* module : modules()) module->bind(model);
    choose_step();
  }

  /// Everything up to the forces of t^n, then the split; `step` is both and the motion.
  void forces() { plan.run(Stage::search, Stage::node_force, clock); }
  void split() {
    plan.run(Stage::split, Stage::split, clock);
    if (model.step_is_stale) choose_step();
  }
  void move() {
    plan.run(Stage::assemble, Stage::observe, clock);
    clock.time += clock.dt;
    clock.dt_before = clock.dt;
    ++clock.step;
  }
  void step() {
    forces();
    split();
    move();
  }

  /// The same with the energies at t^n.
  Ledger step_and_book() {
    Ledger ledger;
    forces();
    split();
    for (Module<D>* module : modules()) module->book(model, ledger);
    motion.book_before(model, ledger);
    plan.run(Stage::assemble, Stage::observe, clock);
    motion.book_after(model, clock, ledger);
    clock.time += clock.dt;
    clock.dt_before = clock.dt;
    ++clock.step;
    ledger.kinetic_start = kinetic_start;
    return ledger;
  }

  void choose_step() {
    stiffness_ = Array<double>("breccia::test::stiffness", model.store.capacity(Entity::node));
    for (Module<D>* module : modules()) module->add_stiffness(model, stiffness_);
    const double dt = motion.stable(model, stiffness_, {0.9, 0.5}, true).dt * step_share;
    clock.dt = clock.dt > 0 ? std::min(clock.dt, dt) : dt;
    model.step_is_stale = false;
  }

  /// Velocity of every node, v(X).
  void set_velocity(const std::function<Vec<D>(const Vec<D>&)>& v) {
    const auto x = host<NodeReference<D>>();
    const auto velocity = host<NodeVelocity<D>>();
    for (Index n = 0; n < model.nodes(); ++n) set_row<D>(velocity, n, v(row<D>(x, n)));
    Kokkos::deep_copy(model.store.template get<NodeVelocity<D>>(), velocity);
    kinetic_start = motion.kinetic_energy(model);
  }

  template <class Field>
  auto host() {
    return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{},
                                               model.store.template get<Field>());
  }

  /// Acceleration of the node at every corner, (element * (D + 1) + a) * D + d, m/s2.
  std::vector<double> corner_acceleration() {
    const auto nodes = host<ElementNodes<D>>();
    const auto mass = host<NodeMass>();
    const auto element = host<ElementForce<D>>();
    const auto interface = host<InterfaceForce<D>>();
    std::vector<double> sum(static_cast<std::size_t>(model.nodes()) * D, 0.0);
    for (Index e = 0; e < model.elements(); ++e)
      for (int a = 0; a <= D; ++a)
        for (int d = 0; d < D; ++d)
          sum[static_cast<std::size_t>(nodes(e, a)) * D + d] +=
              (element(e, a, d) + interface(e, a, d)) / mass(nodes(e, a));
    std::vector<double> at_corner;
    for (Index e = 0; e < model.elements(); ++e)
      for (int a = 0; a <= D; ++a)
        for (int d = 0; d < D; ++d)
          at_corner.push_back(sum[static_cast<std::size_t>(nodes(e, a)) * D + d]);
    return at_corner;
  }

  std::vector<Module<D>*> modules() { return {&motion, &solid, &boundary, &fracture}; }

 private:
  Settings settings_;

 public:
  Model<D> model;
  Motion<D> motion;
  Solid<D> solid;
  Boundary<D> boundary;
  Fracture<D> fracture;
  Plan plan;
  Clock clock;
  double step_share = 1;
  double kinetic_start = 0;

 private:
  Array<double> stiffness_;
};

/// Rock with keys that a test may add to or repeat; structured block of `cells` of 0.5 mm.
std::string block_scene(int dimension, const std::string& pattern, const std::string& cells,
                        const std::string& size, const std::string& law,
                        const std::string& rest = "");

}  // namespace breccia
