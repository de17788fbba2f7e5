// Steps of elements and materials that are more than hyperelastic triangles and tetrahedra.
#include "harness/machine.hpp"
#include "harness/scenes.hpp"

#include <benchmark/benchmark.h>

#include <cmath>

namespace breccia::perf {
namespace {

enum Material { hyperelastic, layered, quiet, flowing, shocked };

std::string extra_of(int material) {
  switch (material) {
    case quiet:  // may yield and does not
      return "j2 = { yield = 1e12 }\n";
    case flowing:  // every element yields
      return "j2 = { yield = 1.0, hardening = 6e10 }\n";
    case shocked:
      return "j2 = { yield = 1e12 }\n[material.rock.eos.linear]\n";
    default:
      return "";
  }
}

std::string elastic_of(int material) {
  if (material == layered)
    return "transversely_isotropic = { young = 60e9, young_axis = 40e9, poisson = 0.25, "
           "poisson_axis = 0.2, shear_axis = 18e9 }\n";
  return "elastic = { young = 60e9, poisson = 0.25 }\n";
}

/// Bytes that one simplex moves per step when the nodes of neighbours stay in cache: element loop
/// (connectivity of the group, reference matrices, corner forces written and fetched before,
/// state read, stress written and fetched before) and node loop. In mixed precision forces
/// are floats.
template <int D>
double bytes_per_element(int group, int material, bool mixed, double nodes_per_element) {
  constexpr double kTensor = 8.0 * (D == 2 ? 4 : 6);
  const bool state = material >= quiet, stress = state || material == layered || group > 1;
  const double force = mixed ? 4 : 8;
  const double indices = group == 1 ? D + 1 : (D == 2 ? 6.0 : 10.0) / group;
  const double element = 4.0 * indices + 8.0 * D * D + 2 * force * (D + 1) * D +
                         (state ? kTensor + 8.0 : 0.0) + (stress ? 2 * kTensor : 0.0);
  const double corners = (4.0 + force * D) * (D + 1);
  const double node = 8.0 + 4.0 + 8.0 + 4 * 8.0 * D + 8.0 * D;
  return element + corners + nodes_per_element * node;
}

/// The block turns rigidly; after some steps the books must still close.
template <int D>
void verify(benchmark::State& state, RunningScene<D>& scene) {
  for (int i = 0; i < 20; ++i) scene.simulation->step(1.0, {});
  Ledger later;
  double drift = 0;
  scene.simulation->step(1.0, {[&] { scene.simulation->book_before(later); },
                               [&] {
                                 scene.simulation->book_after(later);
                                 drift = std::max(later.residual_1(), later.residual_2());
                               }});
  if (!(drift < 1e-3)) state.SkipWithError("the energy is not conserved");
}

template <int D>
void solid_step(benchmark::State& state) {
  const auto elements = static_cast<double>(state.range(0));
  const auto group = static_cast<int>(state.range(1)), material = static_cast<int>(state.range(2));
  BlockKind kind;
  kind.mixed = state.range(3) != 0;
  kind.group = group;
  if (group > 1) kind.element = D == 2 ? "tri6c" : (group == 8 ? "tet10c" : "tet10c12");
  kind.elastic = elastic_of(material);
  RunningScene<D> scene(shaking_block<D>(elements, extra_of(material), kind));
  verify(state, scene);
  for (auto _ : state) scene.simulation->step(1.0, {});
  Kokkos::fence("breccia::perf::solids");
  const Model<D>& model = scene.simulation->model();
  const double n = model.elements(),
               bytes = bytes_per_element<D>(group, material, kind.mixed, model.nodes() / n);
  const double rate = n * static_cast<double>(state.iterations());
  state.counters["elements/s"] = benchmark::Counter(rate, benchmark::Counter::kIsRate);
  state.counters["bytes/element"] = bytes;
  state.counters["memory/element"] = static_cast<double>(model.store.bytes()) / n;
  state.counters["of bandwidth"] =
      benchmark::Counter(rate * bytes / bandwidth(), benchmark::Counter::kIsRate);
}

template <int D>
void kinds(benchmark::internal::Benchmark* b) {
  b->ArgNames({"elements", "group", "material", "mixed"})
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
  const int n = smoke() ? 2000 : 100000;
  for (const int group : D == 2 ? std::vector<int>{1, 4} : std::vector<int>{1, 8, 12})
    for (const int material : {hyperelastic, layered, quiet, flowing, shocked})
      for (const int mixed : {0, 1}) b->Args({n, group, material, mixed});
}

BENCHMARK(solid_step<2>)->Name("solid_step.plane")->Apply(kinds<2>);
BENCHMARK(solid_step<3>)->Name("solid_step.space")->Apply(kinds<3>);

}  // namespace
}  // namespace breccia::perf
