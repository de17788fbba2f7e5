#pragma once
#include "fields/field.hpp"
#include "loops/interface_views.hpp"

namespace breccia {

struct InterfaceRecords {
  using View = Array<InterfaceRecord>;
  static constexpr FieldInfo info{"interface_record", Entity::interface, "SI", Restart::yes,
                                  "face, law, area and springs"};
};

struct InterfaceLife {
  using View = Array<std::uint8_t>;
  static constexpr FieldInfo info{"interface_life", Entity::interface, "1", Restart::yes,
                                  "0 acting, 1 broken, 2 leaving, 3 gone"};
};

template <int D>
struct InterfaceActive {
  using View = CornerFlags<D>;
  static constexpr FieldInfo info{"interface_active", Entity::interface, "1", Restart::yes,
                                  "1 where the corner's family has split"};
};

template <int D>
struct InterfaceStates {
  using View = CornerStates<D>;
  static constexpr FieldInfo info{"interface_state", Entity::interface, "SI", Restart::yes,
                                  "memory of the cohesive law at each corner"};
};

template <int D>
struct InterfaceFaults {
  using View = FaultStates<D>;
  static constexpr FieldInfo info{"interface_fault", Entity::interface, "SI", Restart::yes,
                                  "memory of the friction at each corner of a fault"};
};

template <int D>
struct InterfaceEnergies {
  using View = CornerEnergies<D>;
  static constexpr FieldInfo info{"interface_energy", Entity::interface, "J/m2", Restart::yes,
                                  "energies spent at each corner"};
};

template <int D>
struct InterfacePairForce {
  using View = PairForces<D>;
  static constexpr FieldInfo info{"interface_pair_force", Entity::interface, "N", Restart::no,
                                  "force on the left corner, the right one gets the opposite"};
};

struct InterfaceBreakTime {
  using View = Array<double>;
  static constexpr FieldInfo info{"interface_break_time", Entity::interface, "s", Restart::yes,
                                  "when the face broke; 0 while it holds"};
};

// What ranks tell one another of faces that they share; there with many ranks only.

/// Life of the face's interface.
struct FaceLife {
  using View = Array<std::uint8_t>;
  static constexpr FieldInfo info{"face_life", Entity::face, "1", Restart::no,
                                  "interface_life of an inserted face"};
};

/// 1 where a face is to be inserted by the mean stress of its elements.
struct FaceOnset {
  using View = Array<std::uint8_t>;
  static constexpr FieldInfo info{"face_onset", Entity::face, "1", Restart::no,
                                  "1 where the face is beyond its onset in this step"};
};

/// 1 where a face is to be inserted at a tip.
struct FaceTipOnset {
  using View = Array<std::uint8_t>;
  static constexpr FieldInfo info{"face_tip_onset", Entity::face, "1", Restart::no,
                                  "1 where a tip opens the face in this step"};
};

struct InterfaceStiffness {
  using View = Array<double>;
  static constexpr FieldInfo info{"interface_stiffness", Entity::node, "N/m", Restart::no,
                                  "twice the stiffness of the interface springs at the node"};
};

}  // namespace breccia
