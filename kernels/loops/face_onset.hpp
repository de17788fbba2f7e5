#pragma once
#include "loops/element_stress.hpp"
#include "loops/interface_views.hpp"

namespace breccia {

/// What the insertion check looks at.
template <int D>
struct FaceOnsetIn {
  FaceMap<D> faces;
  ConstArray<std::uint8_t> status;  ///< 0: bonded (fields/common_fields.hpp)
  ElementStress<D> stress;
  ConstArray<BitWord> hot;           ///< a bit per element
  ConstArray<std::uint16_t> law_of;  ///< law of each face that has one
  ConstArray<InterfaceLaw> laws;
  ConstArray<Index> family;   ///< of nodes
  ConstArray<Index> of_face;  ///< interface of a face
  CornerFlags<D> active;      ///< corners whose node has split
  ConstArray<InterfaceRecord> record;
  ConstVectors<D> velocity;      ///< m/s, of nodes
  Array<std::uint8_t> strained;  ///< families where a locked face is beyond its strength
};

/// Share of its strength at which a face joins a locked one that is beyond its own.
constexpr double kJoining = 0.5;

/// An inserted face whose node has not split is locked: it bears what the solid bears. Flags the
/// families where one that an element of the list has bears its whole strength or more; returns how
/// many there are, each as often as it was found.
template <int D>
Index flag_strained(const FaceOnsetIn<D>& in, const ConstArray<Index>& elements, Index count);

/// Bonded faces of the listed elements whose traction reaches the onset (ALGORITHMS ), or
/// kJoining of the strength beside a locked face that is beyond its own; each once, by element and
/// local face. `mark` and `found` have room for D + 1 entries per element.
template <int D>
Index find_onset(const FaceOnsetIn<D>& in, const ConstArray<Index>& elements, Index count,
                 const Array<std::uint8_t>& mark, const Array<Index>& found);

extern template Index flag_strained<2>(const FaceOnsetIn<2>&, const ConstArray<Index>&, Index);
extern template Index flag_strained<3>(const FaceOnsetIn<3>&, const ConstArray<Index>&, Index);
extern template Index find_onset<2>(const FaceOnsetIn<2>&, const ConstArray<Index>&, Index,
                                    const Array<std::uint8_t>&, const Array<Index>&);
extern template Index find_onset<3>(const FaceOnsetIn<3>&, const ConstArray<Index>&, Index,
                                    const Array<std::uint8_t>&, const Array<Index>&);

}  // namespace breccia
