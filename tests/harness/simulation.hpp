#pragma once
#include "io/scene_reader.hpp"
#include "scene/commands.hpp"
#include "scene/simulation.hpp"
#include "step/ledger.hpp"

#include <string>
#include <vector>

namespace breccia {

/// The settings of a scene given as text.
inline Settings resolved_scene(const std::string& text,
                               const std::vector<std::string>& options = {}) {
  Schema schema;
  declare_schema(schema);
  return schema.resolve(read_scene_text(text, "test", options));
}

/// A scene given as text, running in memory: for tests that look inside.
template <int D>
class SceneWorld {
 public:
  explicit SceneWorld(const std::string& scene, const std::vector<std::string>& options = {})
      : settings_(resolved_scene(scene, options)), simulation(settings_, ".") {}

 private:
  Settings settings_;  // before the simulation, which refers to it

 public:
  Simulation<D> simulation;

  Model<D>& model() { return simulation.model(); }
  Store& store() { return simulation.model().store; }
  double time() const { return simulation.clock().time; }

  /// One step, no longer than to `end`.
  void step(double end = 1e30) { simulation.step(end, {}); }
  void steps(int n) {
    for (int i = 0; i < n; ++i) step();
  }
  /// One step with the energies at its start.
  Ledger step_and_book(double end = 1e30) {
    Ledger ledger;
    simulation.step(
        end, {[&] { simulation.book_before(ledger); }, [&] { simulation.book_after(ledger); }});
    return ledger;
  }

  /// A field on the host; where host and device are one, the field itself.
  template <class Field>
  auto host() {
    return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, store().template get<Field>());
  }
  template <class Field, class View>
  void put(const View& view) {
    Kokkos::deep_copy(store().template get<Field>(), view);
  }
};

}  // namespace breccia
