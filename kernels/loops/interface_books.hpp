#pragma once
#include "base/sums.hpp"
#include "loops/interface_views.hpp"

namespace breccia {

/// Kind of an interface law, as loops over all of them look it up.
namespace law_kind {
inline constexpr std::uint8_t linear = 0, z_curve = 1, fault = 2;
}  // namespace law_kind

/// Sums over interfaces, J and m2.
struct InterfaceSums {
  double stored = 0, tension = 0, shear = 0, friction = 0, viscous = 0;
  double broken_area = 0;
  double count = 0;  ///< of the interfaces
};

/// Stiffness and energies of the inserted faces.
template <int D>
struct InterfaceBooks {
  InterfaceMap<D> map;

  /// Sum of 2 k A / D of the springs at each node of the listed families, N/m: twice, because
  /// |a - b|^2 <= 2 a^2 + 2 b^2.
  void stiffness(const ConstArray<Index>& families, Index count, const ConstRanges& family_corners,
                 const ConstArray<Index>& corner_list, const ConstConnectivity<D>& nodes,
                 const Array<double>& stiffness) const;

  /// Energies of interfaces [0, count), in a fixed order. `kind`: per law. What was broken before
  /// the start counts to no area. `own`: per element; only faces count whose left element has a 1
  /// there; empty: all.
  InterfaceSums energies(const ConstCornerStates<D>& state, const ConstFaultStates<D>& fault,
                         const ConstCornerEnergies<D>& energy, const ConstArray<std::uint8_t>& kind,
                         const ConstArray<std::uint8_t>& own, Index count) const;
};

extern template struct InterfaceBooks<2>;
extern template struct InterfaceBooks<3>;

}  // namespace breccia
