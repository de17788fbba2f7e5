#pragma once
#include "base/mat.hpp"
#include "core/settings.hpp"
#include "fields/common_fields.hpp"
#include "fields/store.hpp"
#include "mesh/mesh.hpp"
#include "mesh/topology.hpp"
#include "step/material.hpp"
#include "step/part.hpp"

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace breccia {

/// How far a stress may go before an interface could open on some plane; the numbers of
/// point/stress_watch.hpp. All zero: nobody wants to know.
struct Onset {
  double per_tension = 0;   ///< 1 / (alpha f_t), 1/Pa
  double per_cohesion = 0;  ///< 1 / (alpha c_0), 1/Pa
  double friction = 0;      ///< tangent of the friction angle
};

/// Elements [begin, end) of one material and one kind: one law per block, chosen on the host.
struct Block {
  Index begin = 0, end = 0;
  Index material = 0;
  /// Sub-elements of each composite (base/composite.hpp), contiguous from `begin` on; 1: simple.
  int group = 1;
  /// Number of the [[excavate]] that takes these elements out, or none.
  Index excavation = kNone;
  /// Set by whoever wants to know which elements come near an interface's strength.
  Onset watch;
};

/// Why a run must end before its time; found in a step, reported by the run loop.
struct Stop {
  bool raised = false;
  std::string cause;  ///< what happened, where and when, and the likely cause
};

/// A run that is to come to rest ([run.rest]).
struct Rest {
  bool wanted = false, reached = false;
  bool stops = false;  ///< the run ends where rest is reached
  /// Raised before the forces of a step: velocities are brought to t^n, taken away, and the step
  /// begins with half a kick, like the first one.
  bool due = false;
  double share = 0;      ///< of the net force on a node that resists its motion
  double time = 0;       ///< s, when rest was reached
  double unbalance = 0;  ///< largest net force over mean corner force at the last look
  double motion = 0;     ///< kinetic over stored energy when it was looked at last
  double taken = 0;      ///< J, kinetic energy of nodes that were held still
};

/// How far an excavation has come.
struct Excavation {
  double share = 1;  ///< of their stress and mass that its elements still have
  bool gone =
      false;  ///< the share is zero and the forces that belong to it are known: no work left
};

/// Everything that modules share: the scene, the mesh on the host, the fields on the device.
template <int D>
struct Model {
  const Settings* scene = nullptr;
  Mesh<D> mesh;          ///< reference mesh in locality order, blocks contiguous
  Topology<D> topology;  ///< of the reference mesh
  std::vector<Material> materials;
  std::vector<Index> body_material;  ///< material of each body
  std::vector<Block> blocks;
  double thickness = 1;  ///< m, 2D; 1 in 3D
  bool plane_stress = false;
  bool mixed = false;  ///< elements are computed in single precision where their law allows it
  Vec<D> gravity = Vec<D>::zero();  ///< m/s2
  /// Cauchy stress of each element before anything moves, Pa; empty: none anywhere.
  std::vector<Sym<3>> initial_stress;
  /// Material axes of each element as columns; empty: those of the coordinates.
  std::vector<Mat<D>> axes;
  Store store;
  Part part;

  // Events that other modules answer to; they count up.
  std::int64_t splits = 0;           ///< steps in which nodes split: corner lists and nodes changed
  std::int64_t releases = 0;         ///< steps in which faces were released: new surface
  std::int64_t surface_changes = 0;  ///< excavations that have begun, and that are complete
  /// Raised by whoever makes the stable step smaller (insertion, new contact candidates).
  bool step_is_stale = true;
  Stop stop;
  Rest rest;
  double added_mass = 0;                  ///< share of the whole mass that mass scaling has added
  std::function<double()> stored_energy;  ///< of all modules now, J; not for every step
  std::function<double(std::size_t)> stored_in;  ///< energy of the elements of a block now, J
  std::vector<Excavation> excavations;
  double left_with_mass = 0;  ///< J, kinetic energy of what was excavated

  /// True for a block whose elements are no longer there.
  bool gone(const Block& block) const {
    return block.excavation != kNone &&
           excavations[static_cast<std::size_t>(block.excavation)].gone;
  }
  /// True for a block whose elements carry all of their stress.
  bool whole(const Block& block) const {
    return block.excavation == kNone ||
           excavations[static_cast<std::size_t>(block.excavation)].share == 1;
  }
  Index nodes() const { return store.count(Entity::node); }
  Index elements() const { return mesh.elements(); }
  const Material& material_of_body(Index body) const { return materials[body_material[body]]; }
  /// P-wave modulus and density that the time step and penalties use.
  double p_wave_modulus(Index material) const {
    return materials[material].p_wave_modulus(D == 2 && plane_stress);
  }
};

}  // namespace breccia
