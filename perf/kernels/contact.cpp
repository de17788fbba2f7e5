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
std::string stack(int layers, int cells) {
  std::string text = "[run]\ndimension = 2\nduration = 1\n";
  const double height = 1.0 / cells;
  for (int i = 0; i < layers; ++i) {
    const bool wide = i % 2 == 0;
    text += "[[body]]\nname = \"b" + std::to_string(i) +
            "\"\nmaterial = \"rock\"\nshape = { rectangle = { corner = [" +
            (wide ? "0" : "0.0503") + ", " + std::to_string(i * height) + "], size = [" +
            (wide ? "1" : "0.9") + ", " + std::to_string(height) +
            "] } }\nmesh = { generator = \"structured\", cells = [" +
            std::to_string(wide ? cells : cells - 1) + ", 1] }\n";
  }
  return text + "[material.rock]\ndensity = 2650\nelastic = { young = 60e9, poisson = 0.25 }\n";
}

/// Layers pressed into each other by the same overlap, and all that the loops need.
class PressedLayers {
 public:
  PressedLayers(int layers, int cells) : scene(stack(layers, cells)), layers_(layers) {
    Model<2>& model = scene.simulation->model();
    const Index elements = model.elements();
    const Array<Index> body = to_device("breccia::perf::body", model.mesh.body);
    const auto x = model.store.get<NodePosition<2>>();
    const auto nodes = model.store.get<ElementNodes<2>>();
    const auto reference = model.store.get<NodeReference<2>>();
    for_each(
        "breccia::perf::press", elements, KOKKOS_LAMBDA(Index e) {
          for (int a = 0; a <= 2; ++a) {
            const Index n = nodes(e, a);
            Kokkos::atomic_store(&x(n, 1), reference(n, 1) - kOverlap * body(e));
          }
        });
    std::vector<Index> free;
    for (const ElementFace& f : model.topology.free) free.push_back(f.element * 3 + f.face);
    in_.nodes = model.nodes();
    in_.elements = elements;
    in_.element_nodes = nodes;
    in_.reference = reference;
    in_.corners = model.store.get<NodeCorners>();
    in_.corner_list = model.store.get<CornerList>();
    in_.free_facet = to_device("breccia::perf::free", free);
    skin_ = 0.2 / cells;
    make_surface();
    search();
    prepare_forces();
  }

  void make_surface() { update_contact_surface(in_, scratch_, surface); }
  void search() {
    take_contact_places<2>(store().get<NodePosition<2>>(), surface);
    search_contacts(surface, skin_, search_scratch_, pairs);
    refresh_point_nodes(surface, pairs);
  }
  void force() {
    contact_force<2>(force_in_, {history_, signals_, lost_});
    gather_contact<2>(surface, pairs, force_);
  }

  /// The topmost layer stands on the one below it: stiffness, overlap, the narrow layer's width.
  /// Points of the wide one count by their number, and corners are not square: to two elements.
  bool stands(int cells) {
    const auto force = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, force_);
    const auto& body = scene.simulation->model().mesh.body;
    double up = 0, all = 0;
    for (Index e = 0; e < in_.elements; ++e)
      for (int a = 0; a <= 2; ++a) {
        all += force(e, a, 1);
        if (body[e] == layers_ - 1) up += force(e, a, 1);
      }
    const double expected = kStiffness * kOverlap * 0.9;
    return std::abs(up / expected - 1) < 2.0 / cells && std::abs(all) < 1e-9 * expected * layers_;
  }

  /// Every 97th point has as many candidates as there are targets near it.
  bool finds_all() {
    const auto begin = to_host(pairs.pair_begin, pairs.points + 1);
    const auto place = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, surface.place);
    const auto nodes = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, surface.nodes);
    const auto at =
        Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, store().get<NodePosition<2>>());
    const auto own = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, pairs.nodes);
    const auto point = to_host(pairs.point, pairs.points);
    for (Index a = 0; a < pairs.points; a += 97) {
      Vec<2> q = Vec<2>::zero();
      for (int k = 0; k < 2; ++k)
        q += row<2>(at, own(a, k)) * face_weight<2>(point[a] % kFacePoints<2>, k);
      Index near = 0;
      for (Index t = 0; t < surface.targets; ++t) {
        Vec<2> x[3];
        bool joined = false;
        for (int k = 0; k < 3; ++k) {
          x[k] = {{place(t, k, 0), place(t, k, 1)}};
          joined = joined || nodes(t, k) == own(a, 0) || nodes(t, k) == own(a, 1);
        }
        double l[3];
        if (!joined && square_distance_to_simplex<2>(x, q, l) <= skin_ * skin_) ++near;
      }
      if (near != begin[a + 1] - begin[a]) return false;
    }
    return true;
  }

  Index hits() const {
    const auto hit = to_host(pairs.hit, pairs.pairs);
    return static_cast<Index>(std::count(hit.begin(), hit.end(), 1));
  }

  RunningScene<2> scene;
  ContactSurface<2> surface;
  ContactPairs<2> pairs;

 private:
  const Store& store() { return scene.simulation->model().store; }

  void prepare_forces() {
    const Array<Index> material = store().get<ElementMaterial>();
    ContactStiffness<2> rule;
    rule.fixed = kStiffness;
    const Kokkos::View<double* [2], Rows, Memory> moduli("breccia::perf::moduli", 1);
    Kokkos::deep_copy(moduli, 1.0);
    rule.material = moduli;
    set_contact_points<2>(surface, pairs, material, rule, point_);
    history_.element = decltype(history_.element)("breccia::perf::element", pairs.points);
    Kokkos::deep_copy(history_.element, kNone);
    history_.state = decltype(history_.state)("breccia::perf::state", pairs.points);
    lost_ = ChunkSums<3>("breccia::perf::lost", chunks_of(pairs.points));
    signals_.value = Array<Index>("breccia::perf::signals", ContactSignals::count);
    force_ = CornerForces<2>("breccia::perf::force", in_.elements);
    const ContactTable table("breccia::perf::table", 1);
    for_each(
        "breccia::perf::table", 1, KOKKOS_LAMBDA(Index) {
          table(0, 0) = 0.3;
          table(0, 1) = 1;
          table(0, 2) = 0.3;
        });
    force_in_.surface = surface;
    force_in_.pairs = pairs;
    force_in_.point = point_;
    force_in_.x = store().get<NodePosition<2>>();
    force_in_.v = store().get<NodeVelocity<2>>();
    force_in_.element_nodes = in_.element_nodes;
    force_in_.element_material = material;
    force_in_.table = table;
    force_in_.materials = 1;
  }

  int layers_;
  double skin_ = 0;
  ContactSurfaceIn<2> in_;
  ContactScratch<2> scratch_;
  ContactSearchScratch<2> search_scratch_;
  ContactPointData<2> point_;
  ContactForceIn<2> force_in_;
  ContactHistory<2> history_;
  ContactSignals signals_;
  ChunkSums<3> lost_;
  CornerForces<2> force_;
};

PressedLayers layers_of(benchmark::State& state, int& cells) {
  const int layers = smoke() ? 4 : 20;
  // Four elements per cell; about as many contact points, two on each of two sides.
  cells = static_cast<int>(static_cast<double>(state.range(0)) / (4.0 * layers));
  return PressedLayers(layers, cells);
}

void contact_forces(benchmark::State& state) {
  int cells = 0;
  PressedLayers layers = layers_of(state, cells);
  layers.force();
  if (!layers.stands(cells)) state.SkipWithError("the layers do not stand on each other");
  for (auto _ : state) layers.force();
  const double points = layers.pairs.points, pairs = layers.pairs.pairs / points,
               hits = layers.hits() / points, elements = layers.pairs.elements / points;
  // Point: number, pairs, nodes with positions and velocities, constants, material, memory read and
  // written, force. Pair: target, nodes, positions in cache, mark. Touch: potential, velocities,
  // force and weights. Gather: ranges, number, target, forces written and fetched before; pairs.
  const double point = 4 + 4 + 8 + 2 * 32 + 16 + 4 + 2 * 8 + 16;
  const double touch = 24 + 24 + 48 + 16 + 24 + 2.0 * 8 * ContactHistory<2>::kNumbers;
  const double gather = 8 + 4 + 4 + 2 * 48;
  report(state, points,
         point + pairs * (4 + 12 + 1 + 4 + 1) + hits * (touch + 40) + elements * gather + 4 + 16);
}

void contact_search(benchmark::State& state) {
  int cells = 0;
  PressedLayers layers = layers_of(state, cells);
  if (!layers.finds_all()) state.SkipWithError("the search does not find all candidates");
  for (auto _ : state) layers.search();
  // Places of the targets taken, boxes of them counted and filled (three passes), cells written;
  // points look twice: place of their face, cells, targets. Lists per element.
  const double points = layers.pairs.points, targets = layers.surface.targets / points,
               pairs = layers.pairs.pairs / points;
  report(state, points, targets * (12 + 5 * 48 + 2 * 12) + 2 * (12 + 32) + pairs * (2 * 64 + 24));
}

/// Facets, levels, depths and gradients, all of them anew.
void contact_surface(benchmark::State& state) {
  int cells = 0;
  PressedLayers layers = layers_of(state, cells);
  layers.force();
  if (!layers.stands(cells)) state.SkipWithError("the layers do not stand on each other");
  for (auto _ : state) layers.make_surface();
  // Per target: marks, heights, nodes, places, bubbles, then depth, gradient and potential.
  report(state, layers.surface.targets, 3 * 9 + 3 * 12 + 3 * 48 + 2 * 24 + 3 * 24 + 96);
}

BENCHMARK(contact_forces)->Name("contact_force.edge2")->Apply(one_size);
BENCHMARK(contact_search)->Name("contact_search.edge2")->Apply(one_size);
BENCHMARK(contact_surface)->Name("contact_surface.edge2")->Apply(one_size);

}  // namespace
}  // namespace breccia::perf
