// The elastic step: plain, with damping, and with fracture that may happen and does not.
#include "harness/machine.hpp"
#include "harness/scenes.hpp"

#include <benchmark/benchmark.h>

#include <cmath>

namespace breccia::perf {
namespace {

/// Bytes that one element (with its share of nodes) moves through memory per step when the nodes
/// of neighbouring elements stay in cache. Element loop: connectivity, reference matrix, nodes,
/// corner forces written (and fetched before). Node loop: ranges, list, forces, flags, mass,
/// positions and velocities read and written. In mixed precision forces are floats.
template <int D>
double bytes_per_element(double nodes_per_element, bool mixed) {
  const double real = mixed ? 4 : 8;
  const double element = 4.0 * (D + 1) + 8.0 * D * D + 2 * real * (D + 1) * D;
  const double corners = (4.0 + real * D) * (D + 1);
  const double node = 8.0 + 4.0 + 8.0 + 4 * 8.0 * D + 8.0 * D;
  return element + corners + nodes_per_element * node;
}

/// The block turns rigidly: after some steps its energy must still be what it was.
template <int D>
void verify(benchmark::State& state, RunningScene<D>& scene) {
  Ledger ledger;
  scene.simulation->book_before(ledger);
  const double start = scene.simulation->motion().kinetic_energy(scene.simulation->model());
  for (int i = 0; i < 20; ++i) scene.simulation->step(1.0, {});
  Ledger later;
  double drift = 0;
  const typename Simulation<D>::Watchers watchers{[&] { scene.simulation->book_before(later); },
                                                  [&] {
                                                    scene.simulation->book_after(later);
                                                    drift = std::max(later.residual_1(),
                                                                     later.residual_2());
                                                  }};
  scene.simulation->step(1.0, watchers);
  if (!(start > 0) || !(drift < 1e-3)) state.SkipWithError("the energy is not conserved");
}

/// Sections that a variant adds: none; damping; fracture that may happen and does not.
const std::string extras[] = {
    "", "damping = 0.02\n",
    "[fracture.rock]\ntensile_strength = 8e6\ncohesion = 24e6\nfriction_angle = 0.7\n"
    "energy_tension = 4000\nenergy_shear = 40000\n"};

template <int D>
void elastic_step(benchmark::State& state) {
  const auto elements = static_cast<double>(state.range(0));
  BlockKind kind;
  kind.mixed = state.range(2) != 0;
  RunningScene<D> scene(shaking_block<D>(elements, extras[state.range(1)], kind));
  verify(state, scene);
  for (auto _ : state) scene.simulation->step(1.0, {});
  Kokkos::fence("breccia::perf::elastic");
  const Model<D>& model = scene.simulation->model();
  const double n = model.elements(), per = model.nodes() / n;
  const double rate = n * static_cast<double>(state.iterations());
  state.counters["elements/s"] = benchmark::Counter(rate, benchmark::Counter::kIsRate);
  state.counters["bytes/element"] = bytes_per_element<D>(per, kind.mixed);
  state.counters["memory/element"] = static_cast<double>(model.store.bytes()) / n;
  state.counters["of bandwidth"] = benchmark::Counter(
      rate * bytes_per_element<D>(per, kind.mixed) / bandwidth(), benchmark::Counter::kIsRate);
}

void sizes(benchmark::internal::Benchmark* b) {
  b->ArgNames({"elements", "variant", "mixed"})->Unit(benchmark::kMillisecond)->UseRealTime();
  if (smoke()) {
    b->ArgsProduct({{2000}, {0, 1, 2}, {0, 1}});
    return;
  }
  b->ArgsProduct({{10000, 100000, 1000000}, {0, 2}, {0, 1}});
  b->ArgsProduct({{100000}, {1}, {0, 1}});
}

BENCHMARK(elastic_step<2>)->Name("elastic_step.tri3")->Apply(sizes);
BENCHMARK(elastic_step<3>)->Name("elastic_step.tet4")->Apply(sizes);

}  // namespace
}  // namespace breccia::perf
