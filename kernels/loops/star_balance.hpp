#pragma once
#include "loops/stars.hpp"

namespace breccia {

/// Number of arrays that hold forces on element corners: element, interface, contact, load.
inline constexpr int kCornerForceClasses = 4;

template <int D>
struct StarBalanceIn {
  StarMap<D> map;
  StarWork<D> work;  ///< with components and owners; the nodes are still the old ones
  Kokkos::Array<AnyCornerForces<D>, kCornerForceClasses> force;  ///< N; empty where absent
  CornerMass<D> corner_mass;
  ConstArray<std::uint32_t> flags;
  std::uint32_t fixed_x;  ///< flag of a prescribed first component; the others follow
  ConstVectors<D> x;
  ConstArray<Index> of_face;
  ConstArray<InterfaceRecord> record;
  ConstArray<InterfaceLaw> laws;
};

template <int D>
struct StarBalanceOut {
  CornerStates<D> state;
  CornerEnergies<D> energy;
  CornerFlags<D> active;
  PairForces<D> force;
  FaultStates<D> fault;
};

/// Activates the interface corners between components that leave a node in this step. Their first
/// forces r_j keep the acceleration a of the node (ALGORITHMS ): with f_c, m_c of component c
///   sum_j B_cj r_j = m_c a - f_c,  sum |r_j|^2 / A_j least,
/// that is r_j = A_j (lam_p - lam_q) with the potential lam of the weighted graph of components.
/// Prescribed components of motion take the mean traction of the face instead.
template <int D>
void balance_stars(const StarBalanceIn<D>& in, const StarBalanceOut<D>& out);

extern template void balance_stars<2>(const StarBalanceIn<2>&, const StarBalanceOut<2>&);
extern template void balance_stars<3>(const StarBalanceIn<3>&, const StarBalanceOut<3>&);

}  // namespace breccia
