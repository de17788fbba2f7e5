#pragma once
#include "base/sums.hpp"
#include "base/views.hpp"
#include "point/hencky.hpp"
#include "point/stress_watch.hpp"

namespace breccia {

/// What the element loop reads for one block of one material.
template <int D>
struct ElementForceIn {
  ConstConnectivity<D> nodes;
  ConstVectors<D> x;  ///< m, at t^n
  ConstVectors<D> v;  ///< m/s, at t^(n-1/2); read only where damping > 0
  ConstMatrices<D> reference;
  Index begin, end;  ///< elements of the block
  HenckyElastic law;
  double wave_speed;         ///< sqrt(P-wave modulus / density), m/s
  double damping;            ///< fraction of critical at each element's highest mode
  double kick;               ///< s, for the dissipated energy
  double lag;                ///< s, how far the velocities are behind the positions
  double thickness;          ///< m, 1 in 3D
  double smallest_jacobian;  ///< elements below it are reported
  StressWatch watch;
};

template <int D>
struct ElementForceOut {
  CornerForces<D> force;
  Array<std::uint8_t> hot;  ///< written only where the watch is on
  Array<Index> bad;         ///< [0]: smallest element number below smallest_jacobian
  ChunkSums<1> viscous;     ///< J, one row per chunk of the block
};

/// Internal forces of the elements of a block on their corners,
/// f_a = - V0 tau g_a (ALGORITHMS ), with stiffness-proportional damping lagging
/// half a step.
template <int D>
void element_force(const ElementForceIn<D>& in, const ElementForceOut<D>& out);

extern template void element_force<2>(const ElementForceIn<2>&, const ElementForceOut<2>&);
extern template void element_force<3>(const ElementForceIn<3>&, const ElementForceOut<3>&);

}  // namespace breccia
