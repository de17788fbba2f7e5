#pragma once
#include "loops/interface_views.hpp"

namespace breccia {

/// Looks after interfaces [0, count) once their laws have spoken.
template <int D>
struct InterfaceBreaks {
  InterfaceMap<D> map;
  Index count;
  Array<std::uint8_t> status;  ///< of faces

  /// Interfaces whose corners have all broken since the last call, into `broken`; returns how many.
  Index find(const Array<Index>& broken) const;

  /// Those of the n listed ones whose left element has a 1 in `own`, into `counted`; returns how
  /// many.
  Index keep_own(const Array<Index>& broken, Index n, const ConstArray<std::uint8_t>& own,
                 const Array<Index>& counted) const;

  /// How many leave after this step.
  Index leaving() const;

  /// Releases the faces of broken(0) ... broken(n - 1). Where `slip` exists, it gets the elastic
  /// slip of their corners in global components, m; where `rubbed` exists, it gets their slip so
  /// far.
  void release(const Array<Index>& broken, Index n, const ConstConnectivity<D>& nodes,
               const ConstVectors<D>& x, const ConstCornerStates<D>& state,
               const PairForces<D>& slip, const CornerRubbed<D>& rubbed) const;
};

/// Interfaces that were leaving are gone, and their forces with them. `touched` is set at the
/// families of their corners.
template <int D>
struct RetireIn {
  FaceMap<D> faces;
  ConstArray<InterfaceRecord> record;
  ConstConnectivity<D> nodes;
  ConstArray<Index> family;  ///< of nodes
  Array<std::uint8_t> life;
  PairForces<D> force;
  Array<std::uint8_t> touched;
};

template <int D>
void retire_interfaces(Index count, const RetireIn<D>& in);

extern template struct InterfaceBreaks<2>;
extern template struct InterfaceBreaks<3>;
extern template void retire_interfaces<2>(Index, const RetireIn<2>&);
extern template void retire_interfaces<3>(Index, const RetireIn<3>&);

}  // namespace breccia
