#pragma once
#include "loops/interface_tables.hpp"

namespace breccia {

/// Interfaces list[0] ... list[count - 1], all of one law; those that are gone do not act.
template <int D>
struct InterfaceForceIn {
  ConstVectors<D> x;  ///< m, at t^n
  ConstArray<Index> list;
  ConstPairNodes<D> nodes;
  Index count;
  ConstArray<InterfaceRecord> record;
  ConstCornerFlags<D> active;
  CohesiveStrength strength;
  double rate;                    ///< one over the last step, 1/s; 0 in the first
  bool leave_broken;              ///< contact takes broken faces over
  double thickness;               ///< m, 1 in 3D
  ConstArray<std::uint8_t> sure;  ///< per face: 1 where all its corners are known; empty: all

  KOKKOS_FUNCTION
  bool knows(Index face) const { return sure.extent(0) == 0 || sure(face) != 0; }
};

/// Middle surface of an interface and the jump from its left to its right corners, m.
template <int D>
struct InterfaceGap {
  Vec<D> middle[D], jump[D];

  KOKKOS_FUNCTION
  InterfaceGap(const InterfaceForceIn<D>& in, Index i) {
    for (int c = 0; c < D; ++c) {
      const Vec<D> l = row<D>(in.x, in.nodes(i, 0, c)), r = row<D>(in.x, in.nodes(i, 1, c));
      middle[c] = (l + r) * 0.5;
      jump[c] = r - l;
    }
  }

  /// All corners are farther apart than this share of the face's size.
  KOKKOS_FUNCTION
  bool wider_than(double share, double area, double thickness) const {
    double nearest = norm2(jump[0]);
    for (int c = 1; c < D; ++c) nearest = Kokkos::min(nearest, norm2(jump[c]));
    const double length = share * (D == 2 ? area / thickness : Kokkos::sqrt(2 * area));
    return nearest > length * length;
  }
};

template <int D>
struct InterfaceForceOut {
  CornerStates<D> state;
  CornerEnergies<D> energy;
  PairForces<D> force;       ///< N on the left corner; the right one gets the opposite
  Array<std::uint8_t> life;  ///< interface_life
};

/// Tractions of inserted faces at their corners, each with 1/D of the reference area
/// (Newton-Cotes). A corner whose family has not split yet carries none. Returns how many lives
/// changed.
template <int D, class Softening>
Index interface_force(const InterfaceForceIn<D>& in, const InterfaceForceOut<D>& out);

extern template Index interface_force<2, LinearSoftening>(const InterfaceForceIn<2>&,
                                                          const InterfaceForceOut<2>&);
extern template Index interface_force<3, LinearSoftening>(const InterfaceForceIn<3>&,
                                                          const InterfaceForceOut<3>&);
extern template Index interface_force<2, ZCurve>(const InterfaceForceIn<2>&,
                                                 const InterfaceForceOut<2>&);
extern template Index interface_force<3, ZCurve>(const InterfaceForceIn<3>&,
                                                 const InterfaceForceOut<3>&);

}  // namespace breccia
