#pragma once
#include "loops/star_balance.hpp"

namespace breccia {

/// Tips are nodes where one more inserted face opens the star: ends of cracks and of locked faces,
/// and notches. The mean stress of the elements beside them says little there; what the node would
/// hand to the new corners does.
namespace tip {
inline constexpr std::uint8_t notch = 2;   ///< re-entrant corner of the mesh: always looked at
inline constexpr std::uint8_t locked = 1;  ///< has a corner of an inserted face that is not open
}  // namespace tip

/// What the check at tips looks at.
template <int D>
struct TipOnsetIn {
  StarMap<D> map;
  ConstArray<Index> of_face;  ///< interface of a face
  CornerFlags<D> active;
  Kokkos::Array<AnyCornerForces<D>, kCornerForceClasses> force;  ///< N; empty where absent
  CornerMass<D> corner_mass;
  ConstArray<Index> family;         ///< of nodes
  ConstArray<std::uint32_t> flags;  ///< of nodes
  std::uint32_t fixed;              ///< any prescribed component
  ConstVectors<D> velocity;
  ConstArray<std::uint16_t> law_of;
  ConstArray<InterfaceLaw> laws;
  double thickness;
};

/// Renews the flag tip::locked of families list(0) ... list(count - 1), or of families 0 ... count
/// - 1 where the list is empty.
template <int D>
void flag_tips(const TipOnsetIn<D>& in, const ConstArray<Index>& list, Index count,
               const Array<std::uint8_t>& flag);

/// At each of the listed tips the bonded face whose first tractions, those of the exact balance
/// (ALGORITHMS ), are farthest beyond its onset; each face once, in the order of the tips.
/// `choice` has room for a face per tip, `tip_of` the number of each listed family, or none.
template <int D>
Index find_tip_onset(const TipOnsetIn<D>& in, const ConstArray<Index>& tips, Index count,
                     const ConstArray<Index>& tip_of, const Array<Index>& choice,
                     const Array<Index>& found);

extern template void flag_tips<2>(const TipOnsetIn<2>&, const ConstArray<Index>&, Index,
                                  const Array<std::uint8_t>&);
extern template Index find_tip_onset<2>(const TipOnsetIn<2>&, const ConstArray<Index>&, Index,
                                        const ConstArray<Index>&, const Array<Index>&,
                                        const Array<Index>&);

}  // namespace breccia
