// The loops over nodes: forces gathered and nodes moved, the stable step.
#include "harness/broken_block.hpp"
#include "harness/report.hpp"
#include "loops/node_rest.hpp"
#include "step/node_forces.hpp"

#include <cmath>

namespace breccia::perf {
namespace {

template <int D>
NodeMotionIn<D> motion_in(const Model<D>& model) {
  const Store& s = model.store;
  NodeMotionIn<D> in;
  in.corners = s.get<NodeCorners>();
  in.corner_list = s.get<CornerList>();
  in.element_force = element_forces<D>(s);
  in.extra[0] = s.get<InterfaceForce<D>>();
  in.extra_bit = {node_flag::interface, 0, 0};
  in.flags = s.get<NodeFlags>();
  in.mass = s.get<NodeMass>();
  in.gravity = Vec<D>::zero();
  in.dt = in.kick = 1e-9;
  in.fixed_bits = node_flag::fixed_any;
  in.boundary_shift = node_flag::boundary_shift;
  return in;
}

template <int D, class Force>
void push(const Force& force) {
  for_each(
      "breccia::perf::push", static_cast<Index>(force.extent(0)), KOKKOS_LAMBDA(Index e) {
        for (int a = 0; a <= D; ++a)
          for (int d = 0; d < D; ++d) force(e, a, d) = d == 0 ? 1 : 0;
      });
}

/// One newton along x per corner and class: the momentum that all nodes gain, the work on them.
template <int D>
void verify(benchmark::State& state, const Model<D>& model, const NodeMotionIn<D>& in,
            const NodeMotionOut<D>& out) {
  const Store& s = model.store;
  push<D>(s.get_or_empty<ElementForce<D>>());
  push<D>(s.get_or_empty<ElementForceSingle<D>>());
  push<D>(s.get<InterfaceForce<D>>());
  const auto momentum = [&] {
    const auto mass = s.get<NodeMass>();
    const auto v = s.get<NodeVelocity<D>>();
    const ChunkSums<1> rows("breccia::perf::momentum", chunks_of(model.nodes()));
    for_each_summed<1>(
        "breccia::perf::momentum", model.nodes(), rows,
        KOKKOS_LAMBDA(Index n, Sums<1> & sum) { sum[0] += mass(n) * v(n, 0); });
    return total_of(rows)[0];
  };
  Kokkos::deep_copy(s.get<NodeVelocity<D>>(), 0.0);
  const double corners = static_cast<double>(model.elements()) * (D + 1);
  // Nodes on the border of a broken block are interfaces' as well, but for single corners.
  node_motion(model.nodes(), in, out);
  const double gained = momentum() / in.kick / corners;
  if (!(gained > 1.9) || !(gained <= 2 + 1e-12))
    state.SkipWithError("the nodes did not gain the momentum of the forces");
}

template <int D>
void motion(benchmark::State& state) {
  const bool mixed = state.range(1) != 0;
  BrokenBlock<D> block(static_cast<double>(state.range(0)), breakable(0), mixed);
  const Model<D>& model = block.simulation->model();
  const NodeMotionIn<D> in = motion_in(model);
  const NodeMotionOut<D> out{model.store.template get<NodePosition<D>>(),
                             model.store.template get<NodeVelocity<D>>(),
                             {},
                             ChunkSums<kWorks>("breccia::perf::work", chunks_of(model.nodes()))};
  verify(state, model, in, out);
  for (auto _ : state) node_motion(model.nodes(), in, out);
  // Range, flags, mass, position and velocity read and written; one corner per node: its number and
  // the forces of two classes. In mixed precision one of them is single.
  report(state, model.nodes(), 8 + 4 + 8 + 4 * 8.0 * D + 4 + (mixed ? 12.0 : 16.0) * D);
}

/// The same loop where every corner belongs to a boundary that lets waves out, at worst.
template <int D>
void absorbing_motion(benchmark::State& state) {
  BrokenBlock<D> block(static_cast<double>(state.range(0)));
  const Model<D>& model = block.simulation->model();
  NodeMotionIn<D> in = motion_in(model);
  const auto elements = static_cast<std::size_t>(model.elements());
  const Array<Index> row("breccia::perf::absorber", elements);
  const CornerMatrices<D> damping("breccia::perf::absorbing", 1);
  for_each(
      "breccia::perf::rows", model.elements(), KOKKOS_LAMBDA(Index e) { row(e) = 0; });
  for_each(
      "breccia::perf::damping", D + 1, KOKKOS_LAMBDA(Index a) {
        for (int i = 0; i < D; ++i) damping(0, a, i) = 1e-9;
      });
  in.absorber = row;
  in.absorbing = damping;
  in.absorb_bit = node_flag::absorb;
  const Array<std::uint32_t> flags("breccia::perf::flags", model.store.capacity(Entity::node));
  Kokkos::deep_copy(flags, node_flag::absorb);
  in.flags = flags;
  const ChunkSums<kWorks> work("breccia::perf::work", chunks_of(model.nodes()));
  const auto v = model.store.template get<NodeVelocity<D>>();
  for_each(
      "breccia::perf::start", model.nodes(), KOKKOS_LAMBDA(Index n) {
        for (int d = 0; d < D; ++d) v(n, d) = 1;
      });
  const NodeMotionOut<D> out{model.store.template get<NodePosition<D>>(), v, {}, work};
  node_motion(model.nodes(), in, out);
  if (!(total_of(work)[7] < 0)) state.SkipWithError("the boundary took no energy");
  for (auto _ : state) node_motion(model.nodes(), in, out);
  // As above with one class, and row and matrix of each corner.
  report(state, model.nodes(), 8 + 4 + 8 + 4 * 8.0 * D + 4 + 8.0 * D + 4 + 4.0 * D * (D + 1));
}

/// The energy that run.rest watches in every step; of unit velocities it is half the mass.
template <int D>
void kinetic(benchmark::State& state) {
  BrokenBlock<D> block(static_cast<double>(state.range(0)));
  const Model<D>& model = block.simulation->model();
  const auto v = model.store.template get<NodeVelocity<D>>();
  const auto mass = model.store.template get<NodeMass>();
  const ChunkSums<1> rows("breccia::perf::rows", chunks_of(model.nodes()));
  const auto energy = [&] { return kinetic_energy<D>(model.nodes(), mass, v, rows); };
  for_each(
      "breccia::perf::unit", model.nodes(), KOKKOS_LAMBDA(Index n) {
        for (int d = 0; d < D; ++d) v(n, d) = d == 0 ? 1.0 : 0.0;
      });
  const double one = energy();
  for_each(
      "breccia::perf::heavier", model.nodes(), KOKKOS_LAMBDA(Index n) { mass(n) *= 4; });
  if (!(one > 0) || energy() != 4 * one)
    state.SkipWithError("the kinetic energy does not follow the mass");
  for (auto _ : state) benchmark::DoNotOptimize(energy());
  report(state, model.nodes(), 8 + 8.0 * D);
}

/// Four times the mass is to give twice the step, to the last bit.
template <int D>
void step_length(benchmark::State& state) {
  BrokenBlock<D> block(static_cast<double>(state.range(0)));
  Simulation<D>& simulation = *block.simulation;
  Model<D>& model = simulation.model();
  const double light = simulation.stable(true).dt;
  const auto mass = model.store.template get<NodeMass>();
  for_each(
      "breccia::perf::heavier", model.nodes(), KOKKOS_LAMBDA(Index n) { mass(n) *= 4; });
  if (!(light > 0) || simulation.stable(true).dt != 2 * light)
    state.SkipWithError("the stable step does not follow the mass");
  for (auto _ : state) benchmark::DoNotOptimize(simulation.stable(true).dt);
  // Nodes: range, corner and rate of its element, stiffness cleared, summed and read, mass.
  // Elements: nodes, shape, material, positions and velocities of its own nodes, rate written.
  const double node = 8 + 4 + 8 + 4 * 8 + 8;
  const double element = 4.0 * (D + 1) + 8.0 * D * D + 4 + 2 * 8.0 * D * (D + 1) + 2 * 8;
  report(state, model.nodes(), node + element / (D + 1));
}

/// In double and in mixed precision.
void both_precisions(benchmark::internal::Benchmark* b) {
  b->ArgNames({"elements", "mixed"})->Unit(benchmark::kMillisecond)->UseRealTime();
  b->ArgsProduct({{smoke() ? 2000 : 30000}, {0, 1}});
}

BENCHMARK(motion<2>)->Name("node_motion.plane")->Apply(both_precisions);
BENCHMARK(motion<3>)->Name("node_motion.space")->Apply(both_precisions);
BENCHMARK(absorbing_motion<2>)->Name("node_motion.absorbing.plane")->Apply(one_size);
BENCHMARK(absorbing_motion<3>)->Name("node_motion.absorbing.space")->Apply(one_size);
BENCHMARK(kinetic<2>)->Name("kinetic_energy.plane")->Apply(one_size);
BENCHMARK(kinetic<3>)->Name("kinetic_energy.space")->Apply(one_size);
BENCHMARK(step_length<2>)->Name("stable_step.tri3")->Apply(one_size);
BENCHMARK(step_length<3>)->Name("stable_step.tet4")->Apply(one_size);

}  // namespace
}  // namespace breccia::perf
