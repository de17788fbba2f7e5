#pragma once
#include "base/sums.hpp"
#include "loops/interface_views.hpp"

namespace breccia {

/// Sums over interfaces, J and m2.
struct InterfaceSums {
  double stored = 0, tension = 0, shear = 0, friction = 0, viscous = 0;
  double broken_area = 0;
};

/// Books of the inserted faces: forces, stiffness and energies at the places that others look at.
template <int D>
struct InterfaceBooks {
  InterfaceMap<D> map;

  /// Pair forces on the corners of the listed elements, face by face in local order. Every element
  /// writes its own corners only.
  void forces(const ConstPairForces<D>& pair, const ConstArray<Index>& elements, Index count,
              const CornerForces<D>& force) const;

  /// Adds 2 k A / D of every spring at a node, because |a - b|^2 <= 2 a^2 + 2 b^2, N/m. Only nodes
  /// whose flags have one of `bits` are looked at.
  void stiffness(Index nodes, const ConstRanges& corners, const ConstArray<Index>& corner_list,
                 const ConstArray<std::uint32_t>& flags, std::uint32_t bits,
                 const Array<double>& stiffness) const;

  /// Energies of interfaces [0, count), in a fixed order. `z_curve`: per law.
  InterfaceSums energies(const ConstCornerStates<D>& state, const ConstCornerEnergies<D>& energy,
                         const ConstArray<std::uint8_t>& z_curve, Index count) const;
};

/// Zero on the corners of the listed elements.
template <int D>
void clear_corner_forces(const ConstArray<Index>& elements, Index count,
                         const CornerForces<D>& force);

extern template struct InterfaceBooks<2>;
extern template struct InterfaceBooks<3>;
extern template void clear_corner_forces<2>(const ConstArray<Index>&, Index,
                                            const CornerForces<2>&);
extern template void clear_corner_forces<3>(const ConstArray<Index>&, Index,
                                            const CornerForces<3>&);

}  // namespace breccia
