#pragma once
#include "harness/scenes.hpp"
#include "loops/boundary.hpp"
#include "modules/fracture/fracture_fields.hpp"
#include "modules/fracture/interface_lists.hpp"
#include "modules/motion/motion_fields.hpp"

namespace breccia::perf {

inline constexpr double kTension = 8e6;   // Pa
inline constexpr double kStretch = 1e-6;  // below the peak of every face

/// Section of a law; `alpha = 0` inserts every face at the start, so that every node splits.
inline std::string breakable(double alpha) {
  return "[fracture.rock]\ntensile_strength = 8e6\ncohesion = 24e6\nfriction_angle = 0.7\n"
         "energy_tension = 4000\nenergy_shear = 40000\nalpha = " +
         std::to_string(alpha) + "\n";
}

/// A block in which every face is an interface and every element has nodes of its own, drawn apart:
/// elements keep their shape and stand away from the origin by `kStretch` more than before.
template <int D>
struct BrokenBlock : RunningScene<D> {
  InterfaceLists<D> lists;

  explicit BrokenBlock(double elements, const std::string& law = breakable(0), bool mixed = false)
      : RunningScene<D>(shaking_block<D>(elements, law, {.mixed = mixed})) {
    Model<D>& model = this->simulation->model();
    if (model.store.count(Entity::interface) == 0) return;  // not broken yet
    lists.rebuild(model, 1);
    const auto x = model.store.template get<NodePosition<D>>();
    const auto nodes = model.store.template get<ElementNodes<D>>();
    for_each(
        "breccia::perf::draw_apart", model.elements(), KOKKOS_LAMBDA(Index e) {
          Vec<D> middle = Vec<D>::zero();
          for (int a = 0; a <= D; ++a) middle += row<D>(x, nodes(e, a)) * (kStretch / (D + 1));
          for (int a = 0; a <= D; ++a) set_row<D>(x, nodes(e, a), row<D>(x, nodes(e, a)) + middle);
        });
  }

  /// Every corner of an element belongs to a node of its own, and no mass is lost.
  bool is_split() {
    Model<D>& model = this->simulation->model();
    const auto mass = model.store.template get<NodeMass>();
    const ChunkSums<1> rows("breccia::perf::mass", chunks_of(model.nodes()));
    for_each_summed<1>(
        "breccia::perf::mass", model.nodes(), rows,
        KOKKOS_LAMBDA(Index n, Sums<1> & sum) { sum[0] += mass(n); });
    return model.nodes() == model.elements() * (D + 1) &&
           std::abs(total_of(rows)[0] / 2650 - 1) < 1e-9;
  }
};

}  // namespace breccia::perf
