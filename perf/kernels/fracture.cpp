// The loops over interfaces: law, books, onset check, insertion with splitting.
#include "fields/interface_fields.hpp"
#include "harness/broken_block.hpp"
#include "harness/report.hpp"
#include "loops/face_onset.hpp"
#include "loops/interface_books.hpp"
#include "loops/interface_force.hpp"
#include "modules/fracture/insertion.hpp"
#include "step/stress_view.hpp"

#include <cmath>

namespace breccia::perf {
namespace {

template <int D>
InterfaceForceIn<D> law_in(BrokenBlock<D>& block) {
  const Model<D>& model = block.simulation->model();
  const Store& s = model.store;
  InterfaceForceIn<D> in;
  in.x = s.get<NodePosition<D>>();
  in.list = block.lists.list(0);
  in.nodes = block.lists.nodes();
  in.count = block.lists.size(0);
  in.record = s.get<InterfaceRecords>();
  in.active = s.get<InterfaceActive<D>>();
  in.strength = read_interface_laws(*model.scene, model.materials).laws[0].strength;
  in.rate = 0;
  in.leave_broken = true;
  in.thickness = model.thickness;
  return in;
}

template <int D>
InterfaceForceOut<D> law_out(const Store& s) {
  return {s.get<InterfaceStates<D>>(), s.get<InterfaceEnergies<D>>(),
          s.get<InterfacePairForce<D>>(), s.get<InterfaceLife>()};
}

/// What pulling the elements apart stored in the springs, J.
template <int D>
double stored(const Model<D>& model) {
  const Store& s = model.store;
  return InterfaceBooks<D>{interface_map<D>(s)}
      .energies(s.get<InterfaceStates<D>>(), FaultStates<D>{}, s.get<InterfaceEnergies<D>>(),
                Array<std::uint8_t>("breccia::perf::law_kind", 1), {}, s.count(Entity::interface))
      .stored;
}

/// Sum of force times position over all corners, J: minus twice what linear springs store.
template <int D>
double virial(const Model<D>& model) {
  const auto force = model.store.template get<InterfaceForce<D>>();
  const auto nodes = model.store.template get<ElementNodes<D>>();
  const auto x = model.store.template get<NodePosition<D>>();
  const ChunkSums<1> rows("breccia::perf::virial", chunks_of(model.elements()));
  for_each_summed<1>(
      "breccia::perf::virial", model.elements(), rows, KOKKOS_LAMBDA(Index e, Sums<1> & sum) {
        for (int a = 0; a <= D; ++a)
          for (int d = 0; d < D; ++d) sum[0] += force(e, a, d) * x(nodes(e, a), d);
      });
  return total_of(rows)[0];
}

template <int D>
void book(const BrokenBlock<D>& block, const Store& s) {
  book_pair_forces<D>(block.lists.elements(), block.lists.element_count(), block.lists.sources(),
                      s.get<InterfacePairForce<D>>(), s.get<InterfaceForce<D>>());
}

/// Law and books together: the forces do on the way apart what the springs store.
template <int D>
void verify(benchmark::State& state, BrokenBlock<D>& block) {
  const Model<D>& model = block.simulation->model();
  interface_force<D, LinearSoftening>(law_in(block), law_out<D>(model.store));
  book(block, model.store);
  const double energy = stored(model);
  if (!block.is_split() || !(energy > 0) || !(std::abs(virial(model) / energy + 2) < 1e-5))
    state.SkipWithError("forces and energy of the springs do not agree");
}

template <int D>
void interface_law(benchmark::State& state) {
  BrokenBlock<D> block(static_cast<double>(state.range(0)));
  verify(state, block);
  InterfaceForceIn<D> in = law_in(block);
  in.rate = 1e7;
  const auto out = law_out<D>(block.simulation->model().store);
  for (auto _ : state) interface_force<D, LinearSoftening>(in, out);
  // Number, nodes, life, record; positions, as every corner has nodes of its own; state and energy
  // read and written, force written and fetched before.
  const double corner =
      2 * 4 + 2 * 8 * D + 1 + 2.0 * (sizeof(CohesiveState<D>) + sizeof(CornerEnergy) + 8 * D);
  report(state, in.count, 4 + 1 + sizeof(InterfaceRecord) + D * corner);
}

template <int D>
void pair_books(benchmark::State& state) {
  BrokenBlock<D> block(static_cast<double>(state.range(0)));
  verify(state, block);
  const Store& s = block.simulation->model().store;
  for (auto _ : state) book(block, s);
  // Number and sources, each pair force from one of its sides, corner forces written and fetched.
  report(state, block.lists.element_count(),
         4 + 4.0 * (D + 1) * D + 8.0 * (D + 1) * D * D / 2 + 2 * 8.0 * (D + 1) * D);
}

/// The check with all elements under watch. Stretched a little under and a little over the
/// strength, no face may be found, then every one.
template <int D>
void onset_check(benchmark::State& state) {
  RunningScene<D> scene(shaking_block<D>(static_cast<double>(state.range(0)), breakable(1)));
  Model<D>& model = scene.simulation->model();
  const Store& s = model.store;
  const InterfaceLaws laws = read_interface_laws(*model.scene, model.materials);
  const Index n = model.elements(), room = n * (D + 1);
  const Array<Index> hot("breccia::perf::hot", n), found("breccia::perf::found", room);
  const Array<std::uint8_t> mark("breccia::perf::mark", room);
  const FaceOnsetIn<D> in{
      face_map<D>(s),
      s.get<FaceStatus>(),
      stress_of(model),
      s.get<ElementHot>(),
      Array<std::uint16_t>("breccia::perf::law_of", model.topology.shared.size()),
      to_device("breccia::perf::laws", laws.laws),
      s.get<NodeFamily>(),
      s.get<FaceInterface>(),
      s.get<InterfaceActive<D>>(),
      s.get<InterfaceRecords>(),
      s.get<NodeVelocity<D>>(),
      Array<std::uint8_t>("breccia::perf::strained",
                          static_cast<std::size_t>(model.mesh.points()))};
  Kokkos::deep_copy(s.get<ElementHot>(), ~BitWord{0});
  for_each(
      "breccia::perf::all", n, KOKKOS_LAMBDA(Index e) { hot(e) = e; });
  const auto stretch = [&](double factor) {
    const auto x = s.get<NodePosition<D>>();
    for_each(
        "breccia::perf::stretch", model.nodes(),
        KOKKOS_LAMBDA(Index i) { set_row<D>(x, i, row<D>(x, i) * factor); });
  };
  // sigma = D K_D log(stretch) on every plane, K_D = lambda + 2 mu / D.
  const double young = 60e9, nu = 0.25;
  const double lambda = young * nu / ((1 + nu) * (1 - 2 * nu)), mu = young / (2 * (1 + nu));
  const double peak = kTension / (D * lambda + 2 * mu);
  stretch(1 + 0.99 * peak);
  const Index under = find_onset(in, hot, n, mark, found);
  stretch((1 + 1.01 * peak) / (1 + 0.99 * peak));
  const auto faces = static_cast<Index>(model.topology.shared.size());
  if (under != 0 || find_onset(in, hot, n, mark, found) != faces)
    state.SkipWithError("the check does not find the faces above the strength");
  for (auto _ : state) benchmark::DoNotOptimize(find_onset(in, hot, n, mark, found));
  // Elements left and right, code, status, faces of both; nodes, shapes, materials of both sides.
  report(state, faces, 8 + 1 + 1 + 8 + 2 * (4.0 * (D + 1) + 8.0 * D * D + 4 + 1) + 3 * 8.0 * D);
}

/// Every face at once, every node into as many as it has elements.
template <int D>
void insertion_and_split(benchmark::State& state) {
  double faces = 0;
  for (auto _ : state) {
    state.PauseTiming();
    {
      BrokenBlock<D> whole(static_cast<double>(state.range(0)), breakable(1));
      Model<D>& model = whole.simulation->model();
      InterfaceLaws laws = read_interface_laws(*model.scene, model.materials);
      laws.laws[0].at_start = true;
      Insertion<D> insertion;
      insertion.prepare(model, laws);
      state.ResumeTiming();
      faces = insertion.start(model);
      Kokkos::fence("breccia::perf::insertion");
      state.PauseTiming();
      if (!whole.is_split() || faces != static_cast<double>(model.topology.shared.size()))
        state.SkipWithError("not every node has split, or mass was lost");
    }
    state.ResumeTiming();
  }
  // Record, life, flags, states, energies and forces of a face, written and fetched before.
  const double corner = sizeof(CohesiveState<D>) + sizeof(CornerEnergy) + 8 * D + 1;
  report(state, faces, 2 * (sizeof(InterfaceRecord) + 1 + D * corner));
}

BENCHMARK(interface_law<2>)->Name("interface_force.edge2")->Apply(one_size);
BENCHMARK(interface_law<3>)->Name("interface_force.tri3")->Apply(one_size);
BENCHMARK(pair_books<2>)->Name("book_pair_forces.tri3")->Apply(one_size);
BENCHMARK(pair_books<3>)->Name("book_pair_forces.tet4")->Apply(one_size);
BENCHMARK(onset_check<2>)->Name("onset.edge2")->Apply(one_size);
BENCHMARK(onset_check<3>)->Name("onset.tri3")->Apply(one_size);
BENCHMARK(insertion_and_split<2>)->Name("insertion_and_split.edge2")->Apply(one_size);
BENCHMARK(insertion_and_split<3>)->Name("insertion_and_split.tri3")->Apply(one_size);

}  // namespace
}  // namespace breccia::perf
