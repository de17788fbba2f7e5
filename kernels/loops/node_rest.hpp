#pragma once
#include "base/sums.hpp"
#include "base/views.hpp"
#include "loops/node_motion.hpp"

namespace breccia {

/// How far the forces are from holding one another.
struct NodeBalance {
  double largest = 0;  ///< largest net force on a node in its free components, N
  double corner = 0;   ///< mean size of an element's force on a corner, N
};

/// Net forces of the present state, gathered as the motion loop does it; `in` needs no velocity and
/// no step. `rows` is scratch.
template <int D>
NodeBalance node_balance(Index nodes, Index corners, const NodeMotionIn<D>& in,
                         const ChunkSums<1>& rows);

/// sum m v^2 / 2 in a fixed order, J. `rows` is scratch.
template <int D>
double kinetic_energy(Index nodes, const Kokkos::View<const double*, Memory>& mass,
                      const ConstVectors<D>& v, const ChunkSums<1>& rows);

/// Takes all velocities away.
template <int D>
void hold_still(Index nodes, const Vectors<D>& v);

extern template NodeBalance node_balance<2>(Index, Index, const NodeMotionIn<2>&,
                                            const ChunkSums<1>&);
extern template NodeBalance node_balance<3>(Index, Index, const NodeMotionIn<3>&,
                                            const ChunkSums<1>&);
extern template double kinetic_energy<2>(Index, const Kokkos::View<const double*, Memory>&,
                                         const ConstVectors<2>&, const ChunkSums<1>&);
extern template double kinetic_energy<3>(Index, const Kokkos::View<const double*, Memory>&,
                                         const ConstVectors<3>&, const ChunkSums<1>&);
extern template void hold_still<2>(Index, const Vectors<2>&);
extern template void hold_still<3>(Index, const Vectors<3>&);

}  // namespace breccia
