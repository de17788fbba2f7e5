#pragma once
#include "base/mat.hpp"
#include "base/simplex.hpp"
#include "base/views.hpp"
#include "point/cohesive.hpp"
#include "point/cohesive_onset.hpp"
#include "point/fault.hpp"
#include "point/interface_springs.hpp"

#include <cstdint>

namespace breccia {

/// Law of all faces between two materials.
struct InterfaceLaw {
  CohesiveStrength strength;
  CohesiveOnset onset;
  double stiffness_factor = 5;  ///< kf: k_n = kf M / h_f
  double damping = 0.01;        ///< xi, share of critical
  bool z_curve = false;
  bool at_start = false;         ///< inserted before the first step
  bool fault = false;            ///< without strength, inserted with the first forces
  FrictionLaw friction;          ///< of a fault
  Sym<3> load = Sym<3>::zero();  ///< Pa, stands on the fault but not in the elements
};

/// What an inserted face keeps besides the states of its corners.
struct InterfaceRecord {
  Index face, law;
  double area;  ///< of the reference face, m2 (times thickness in the plane)
  CohesiveSprings springs;
  double dynamic_share;  ///< of its strengths at rest, as it was at insertion
};

/// Energies of a corner so far, J/m2. `encoded` is that of the slip it was born with.
struct CornerEnergy {
  double tension, shear, friction, viscous, encoded;
};

/// Life of an inserted face. It leaves when contact takes over, or when it is broken and its two
/// sides have moved apart by more than a face; its last force acts until the step after.
namespace interface_life {
inline constexpr std::uint8_t acting = 0, broken = 1, leaving = 2, gone = 3;
}  // namespace interface_life

template <int D>
using CornerStates = Kokkos::View<CohesiveState<D>* [D], Rows, Memory>;
template <int D>
using FaultStates = Kokkos::View<FaultState<D>* [D], Rows, Memory>;  ///< empty without faults
template <int D>
using ConstFaultStates = Kokkos::View<const FaultState<D>* [D], Rows, Memory>;
template <int D>
using CornerEnergies = Kokkos::View<CornerEnergy* [D], Rows, Memory>;
template <int D>
using CornerFlags = Kokkos::View<std::uint8_t* [D], Rows, Memory>;
/// One vector per corner of an interface: (interface, corner, component).
template <int D>
using PairForces = Kokkos::View<double* [D][D], Rows, Memory>;
template <int D>
using ConstCornerStates = Kokkos::View<const CohesiveState<D>* [D], Rows, Memory>;
template <int D>
using ConstCornerEnergies = Kokkos::View<const CornerEnergy* [D], Rows, Memory>;
template <int D>
using ConstCornerFlags = Kokkos::View<const std::uint8_t* [D], Rows, Memory>;
/// Slip so far, slip rate and theta of the corners (interface, corner, 3), see Rubbed.
template <int D>
using CornerRubbed = Kokkos::View<double* [D][3], Rows, Memory>;
template <int D>
using ConstPairForces = Kokkos::View<const double* [D][D], Rows, Memory>;
template <class T>
using ConstArray = Kokkos::View<const T*, Memory>;

/// Faces between two elements. Corner c of a face is node c of the left element's face.
template <int D>
struct FaceMap {
  ConstRanges elements;  ///< left, right
  ConstArray<std::uint8_t> code;
  ConstConnectivity<D> of_element;  ///< face at each local face, or none

  struct Corner {
    Index element;
    int node;  ///< local
  };

  KOKKOS_FUNCTION
  Corner left(Index face, int c) const {
    return {elements(face, 0), face_node<D>(code(face) & 3, c)};
  }

  KOKKOS_FUNCTION
  Corner right(Index face, int c) const {
    const int turn = code(face) >> 4;
    return {elements(face, 1), face_node<D>((code(face) >> 2) & 3, opposite_face_node<D>(turn, c))};
  }

  /// Corner of the face that is local node `node` of `element`.
  KOKKOS_FUNCTION
  int corner_at(Index face, Index element, int node) const {
    for (int c = 0; c < D; ++c) {
      const Corner at = element == elements(face, 0) ? left(face, c) : right(face, c);
      if (at.node == node) return c;
    }
    return kNone;
  }

  /// The element on the other side.
  KOKKOS_FUNCTION
  Index across(Index face, Index element) const {
    const Index l = elements(face, 0);
    return l == element ? elements(face, 1) : l;
  }
};

/// Position of a face's corners on the left (0) or right (1), m.
template <int D, class Nodes>
KOKKOS_FUNCTION
Vec<D> face_point(const FaceMap<D>& faces, const Nodes& nodes, const ConstVectors<D>& x, Index face,
                  int side, int c) {
  const auto corner = side == 0 ? faces.left(face, c) : faces.right(face, c);
  return row<D>(x, nodes(corner.element, corner.node));
}

/// Inserted faces as elements and nodes look them up.
template <int D>
struct InterfaceMap {
  FaceMap<D> faces;
  ConstArray<Index> of_face;  ///< interface of each face, or none
  ConstCornerFlags<D> active;
  ConstArray<InterfaceRecord> record;
  ConstArray<std::uint8_t> life;

  /// The interface at a local face of an element, or none.
  KOKKOS_FUNCTION
  Index at(Index element, int f) const {
    const Index face = faces.of_element(element, f);
    const Index i = face == kNone ? kNone : of_face(face);
    return i != kNone && life(i) != interface_life::gone ? i : kNone;
  }
};

}  // namespace breccia
