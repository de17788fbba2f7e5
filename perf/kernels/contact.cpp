// The loops of contact: forces with their gather, and the search with the surface that it needs.
#include "fields/common_fields.hpp"
#include "harness/report.hpp"
#include "harness/scenes.hpp"
#include "loops/contact_force.hpp"
#include "loops/contact_gather.hpp"
#include "loops/contact_search.hpp"
#include "loops/contact_surface.hpp"
#include "point/simplex_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace breccia::perf {
namespace {

constexpr double kOverlap = 1e-5;    // m
constexpr double kStiffness = 1e10;  // Pa/m

/// A stack of layers of one row of elements, 1 m and 0.9 m wide by turns, that do not match.
template <int D>
std::string stack(int layers, int cells) {
  std::string text = "[run]\ndimension = " + std::to_string(D) + "\nduration = 1\n";
  const double height = 1.0 / cells;
  for (int i = 0; i < layers; ++i) {
    const bool wide = i % 2 == 0;
    const std::string at = wide ? "0" : "0.0503", size = wide ? "1" : "0.9",
                      across = std::to_string(wide ? cells : cells - 1),
                      low = std::to_string(i * height), high = std::to_string(height);
    text += "[[body]]\nname = \"b" + std::to_string(i) + "\"\nmaterial = \"rock\"\nshape = { ";
    if (D == 2)
      text += "rectangle = { corner = [" + at + ", " + low + "], size = [" + size + ", " + high +
              "] } }\nmesh = { generator = \"structured\", cells = [" + across + ", 1] }\n";
    else
      text += "box = { corner = [" + at + ", " + at + ", " + low + "], size = [" + size + ", " +
              size + ", " + high + "] } }\nmesh = { generator = \"structured\", cells = [" +
              across + ", " + across + ", 1] }\n";
  }
  return text + "[material.rock]\ndensity = 2650\nelastic = { young = 60e9, poisson = 0.25 }\n";
}

/// Layers pressed into each other by the same overlap, and all that the loops need.
template <int D>
class PressedLayers {
 public:
  PressedLayers(int layers, int cells) : scene(stack<D>(layers, cells)), layers_(layers) {
    Model<D>& model = scene.simulation->model();
    const Index elements = model.elements();
    const Array<Index> body = to_device("breccia::perf::body", model.mesh.body);
    const auto x = model.store.template get<NodePosition<D>>();
    const auto nodes = model.store.template get<ElementNodes<D>>();
    const auto reference = model.store.template get<NodeReference<D>>();
    for_each(
        "breccia::perf::press", elements, KOKKOS_LAMBDA(Index e) {
          for (int a = 0; a <= D; ++a) {
            const Index n = nodes(e, a);
            Kokkos::atomic_store(&x(n, D - 1), reference(n, D - 1) - kOverlap * body(e));
          }
        });
    std::vector<Index> free;
    for (const ElementFace& f : model.topology.free) free.push_back(f.element * (D + 1) + f.face);
    in_.nodes = model.nodes();
    in_.elements = elements;
    in_.element_nodes = nodes;
    in_.reference = reference;
    in_.corners = model.store.template get<NodeCorners>();
    in_.corner_list = model.store.template get<CornerList>();
    in_.free_facet = to_device("breccia::perf::free", free);
    skin_ = 0.2 / cells;
    make_surface();
    search();
    prepare_forces();
  }

  void make_surface() { update_contact_surface(in_, scratch_, surface); }
  void search() {
    take_contact_places<D>(store().template get<NodePosition<D>>(), surface);
    search_contacts(surface, skin_, search_scratch_, pairs);
    refresh_point_nodes(surface, pairs);
  }
  void force() {
    contact_force<D>(force_in_, {history_, signals_, lost_});
    gather_contact<D>(surface, pairs, force_);
  }

  /// The topmost layer stands on the one below it: stiffness, overlap, the narrow layer's width.
  /// Points of the wide one count by their number, and corners are not square: to two elements.
  bool stands(int cells) {
    const auto force = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, force_);
    const auto& body = scene.simulation->model().mesh.body;
    double up = 0, all = 0;
    for (Index e = 0; e < in_.elements; ++e)
      for (int a = 0; a <= D; ++a) {
        all += force(e, a, D - 1);
        if (body[e] == layers_ - 1) up += force(e, a, D - 1);
      }
    const double expected = kStiffness * kOverlap * (D == 2 ? 0.9 : 0.81);
    return std::abs(up / expected - 1) < 2.0 * (D - 1) / cells &&
           std::abs(all) < 1e-9 * expected * layers_;
  }

  /// Every 97th point has as many candidates as there are targets near it.
  bool finds_all() {
    const auto begin = to_host(pairs.pair_begin, pairs.points + 1);
    const auto place = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, surface.place);
    const auto nodes = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, surface.nodes);
    const auto at = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{},
                                                        store().template get<NodePosition<D>>());
    const auto own = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, pairs.nodes);
    const auto point = to_host(pairs.point, pairs.points);
    for (Index a = 0; a < pairs.points; a += 97) {
      Vec<D> q = Vec<D>::zero();
      for (int k = 0; k < D; ++k)
        q += row<D>(at, own(a, k)) *
             face_weight<D>(point[a] % kFacePoints<D>, k, surface.own_weight);
      Index near = 0;
      for (Index t = 0; t < surface.targets; ++t) {
        Vec<D> x[D + 1];
        bool joined = false;
        for (int k = 0; k <= D; ++k) {
          for (int d = 0; d < D; ++d) x[k][d] = place(t, k, d);
          for (int n = 0; n < D; ++n) joined = joined || nodes(t, k) == own(a, n);
        }
        double l[D + 1];
        if (!joined && square_distance_to_simplex<D>(x, q, l) <= skin_ * skin_) ++near;
      }
      if (near != begin[a + 1] - begin[a]) return false;
    }
    return true;
  }

  Index hits() const {
    const auto hit = to_host(pairs.hit, pairs.pairs);
    return static_cast<Index>(std::count(hit.begin(), hit.end(), 1));
  }

  RunningScene<D> scene;
  ContactSurface<D> surface;
  ContactPairs<D> pairs;

 private:
  const Store& store() { return scene.simulation->model().store; }

  void prepare_forces() {
    const Array<Index> material = store().template get<ElementMaterial>();
    ContactStiffness<D> rule;
    rule.fixed = kStiffness;
    const Kokkos::View<double* [2], Rows, Memory> moduli("breccia::perf::moduli", 1);
    Kokkos::deep_copy(moduli, 1.0);
    rule.material = moduli;
    set_contact_points<D>(surface, pairs, material, rule, point_);
    history_.element = decltype(history_.element)("breccia::perf::element", pairs.points);
    Kokkos::deep_copy(history_.element, kNone);
    history_.state = decltype(history_.state)("breccia::perf::state", pairs.points);
    lost_ = ChunkSums<3>("breccia::perf::lost", chunks_of(pairs.points));
    signals_.value = Array<Index>("breccia::perf::signals", ContactSignals::count);
    force_ = CornerForces<D>("breccia::perf::force", in_.elements);
    const ContactTable table("breccia::perf::table", 1);
    for_each(
        "breccia::perf::table", 1, KOKKOS_LAMBDA(Index) {
          table(0, 0) = 0.3;
          table(0, 1) = 1;
          table(0, 2) = 0.3;
          table(0, 3) = 1;
        });
    force_in_.surface = surface;
    force_in_.pairs = pairs;
    force_in_.point = point_;
    force_in_.x = store().template get<NodePosition<D>>();
    force_in_.v = store().template get<NodeVelocity<D>>();
    force_in_.element_nodes = in_.element_nodes;
    force_in_.element_material = material;
    force_in_.table = table;
    force_in_.materials = 1;
  }

  int layers_;
  double skin_ = 0;
  ContactSurfaceIn<D> in_;
  ContactScratch<D> scratch_;
  ContactSearchScratch<D> search_scratch_;
  ContactPointData<D> point_;
  ContactForceIn<D> force_in_;
  ContactHistory<D> history_;
  ContactSignals signals_;
  ChunkSums<3> lost_;
  CornerForces<D> force_;
};

/// As many elements as asked for; about as many contact points, on each of two sides: two to four
/// elements of a cell in the plane, six to six in space.
template <int D>
PressedLayers<D> layers_of(benchmark::State& state, int& cells) {
  const int layers = smoke() ? 4 : (D == 2 ? 20 : 8);
  const double per_layer = static_cast<double>(state.range(0)) / layers;
  cells = static_cast<int>(D == 2 ? per_layer / 4 : std::sqrt(per_layer / 6));
  return PressedLayers<D>(layers, cells);
}

/// A body that stays in the cache of a core, and one that does not.
void small_and_large(benchmark::internal::Benchmark* b) {
  b->ArgName("elements")->Unit(benchmark::kMillisecond)->UseRealTime();
  for (const int n : {6000, 30000}) b->Arg(smoke() ? 400 : n);
}

template <int D>
void contact_forces(benchmark::State& state) {
  int cells = 0;
  PressedLayers<D> layers = layers_of<D>(state, cells);
  layers.force();
  if (!layers.stands(cells)) state.SkipWithError("the layers do not stand on each other");
  for (auto _ : state) layers.force();
  const double points = layers.pairs.points, pairs = layers.pairs.pairs / points,
               hits = layers.hits() / points, elements = layers.pairs.elements / points;
  // Point: number, pairs, nodes with positions and velocities, constants, material, memory read and
  // written, force. Pair: target, nodes, positions in cache, mark. Touch: potential, velocities,
  // force and weights. Gather: ranges, number, target, forces written and fetched before; pairs.
  const double point = 4 + 4 + 8 + D * 16.0 * D + 16 + 4 + 2 * 8 + 8 * D;
  const double touch =
      8 * (D + 1 + kChords<D> + (D + 1) * D + D + D + 1) + 2.0 * 8 * ContactHistory<D>::kNumbers;
  const double gather = 8 + 4 + 4 + 2 * 8 * (D + 1) * D;
  report(state, points,
         point + pairs * (4 + 4 * (D + 1) + 1 + 4 + 1) + hits * (touch + 8 * (2 * D + 1)) +
             elements * gather + 4 + 16);
}

template <int D>
void contact_search(benchmark::State& state) {
  int cells = 0;
  PressedLayers<D> layers = layers_of<D>(state, cells);
  if (!layers.finds_all()) state.SkipWithError("the search does not find all candidates");
  for (auto _ : state) layers.search();
  // Places of the targets taken, boxes of them counted and filled (three passes), cells written;
  // points look twice: place of their face, cells, targets. Lists per element.
  const double points = layers.pairs.points, targets = layers.surface.targets / points,
               pairs = layers.pairs.pairs / points;
  report(state, points,
         targets * (4 * (D + 1) + 5 * 8 * D * (D + 1) + 2 * 12) + 2 * (4 * D + 16 * D) +
             pairs * (2 * (4 * (D + 1) + 8 * D * (D + 1)) + 24));
}

/// Facets, levels, depths and gradients, all of them anew.
template <int D>
void contact_surface(benchmark::State& state) {
  int cells = 0;
  PressedLayers<D> layers = layers_of<D>(state, cells);
  layers.force();
  if (!layers.stands(cells)) state.SkipWithError("the layers do not stand on each other");
  for (auto _ : state) layers.make_surface();
  // Per target: marks, heights, nodes, places, bubbles, then depth, gradient and potential.
  const double corners = D + 1;
  report(state, layers.surface.targets,
         corners * (9 + 4 * corners + 8 * D * corners + 8 * D) + 2 * 8 * kChords<D> + 24 * corners +
             8 * corners * (D + 1));
}

BENCHMARK(contact_forces<2>)->Name("contact_force.edge2")->Apply(small_and_large);
BENCHMARK(contact_forces<3>)->Name("contact_force.face3")->Apply(small_and_large);
BENCHMARK(contact_search<2>)->Name("contact_search.edge2")->Apply(one_size);
BENCHMARK(contact_search<3>)->Name("contact_search.face3")->Apply(one_size);
BENCHMARK(contact_surface<2>)->Name("contact_surface.edge2")->Apply(one_size);
BENCHMARK(contact_surface<3>)->Name("contact_surface.face3")->Apply(one_size);

}  // namespace
}  // namespace breccia::perf
