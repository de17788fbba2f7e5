#pragma once
#include "base/sums.hpp"
#include "base/views.hpp"
#include "point/full_sym.hpp"
#include "point/hencky.hpp"
#include "point/stress_watch.hpp"

namespace breccia {

/// Numbers that the element loop adds up, per chunk of groups.
namespace element_sum {
inline constexpr int viscous = 0;  ///< J dissipated by stiffness-proportional damping so far
inline constexpr int plastic = 1;  ///< J dissipated by plastic flow so far
inline constexpr int shock = 2;    ///< J dissipated by bulk viscosity so far
inline constexpr int stored = 3;   ///< J stored now; not kept by blocks that are hyperelastic
inline constexpr int count = 4;
}  // namespace element_sum
using ElementSums = ChunkSums<element_sum::count>;

/// What the element loop reads for one block: elements of one material and one kind.
template <int D>
struct ElementForceIn {
  ConstConnectivity<D> nodes;
  ConstVectors<D> x;  ///< m, at t^n
  ConstVectors<D> v;  ///< m/s, at t^(n-1/2); read only where something is viscous
  ConstMatrices<D> reference;
  Kokkos::View<const double*, Memory>
      share;          ///< of its stress that an element carries; may be empty
  Index begin, end;   ///< elements of the block
  int group;          ///< sub-elements of a composite; 1: single elements
  HenckyElastic law;  ///< plane stress: its in-plane constants
  bool flat;          ///< plane stress
  double density;     ///< kg/m3, in the reference configuration
  double wave_speed;  ///< sqrt(P-wave modulus / density), m/s
  double damping;     ///< fraction of critical at each element's highest mode
  double shock_quadratic = 0, shock_linear = 0;  ///< bulk viscosity, both 0: none
  double kick;                                   ///< s, for the dissipated energy
  double lag;                ///< s, how far the velocities are behind the positions
  double dt;                 ///< s since the last call
  double thickness;          ///< m, 1 in 3D
  double smallest_jacobian;  ///< elements below it are reported
  StressWatch<D> watch;
  Kokkos::View<const std::uint8_t*, Memory> own;  ///< 1 where sums count it; empty: everywhere
};

template <int D>
struct ElementForceOut {
  CornerForces<D> force;
  CornerForcesSingle<D> force_single;  ///< where it exists it takes the forces instead
  Array<BitWord> hot;     ///< bits of elements without room are raised where the watch is on
  Array<Index> bad;       ///< [0]: smallest element number below smallest_jacobian
  ElementSums sums;       ///< one row per chunk of the block
  FullTensors<D> stress;  ///< Cauchy stress, Pa, for other readers; may be empty
  Array<double> modulus;  ///< P-wave modulus for the time step; written with bulk viscosity
};

/// Internal forces of the elements of a block on their corners,
/// f_a = - V0 tau g_a (ALGORITHMS ), with stiffness-proportional damping lagging
/// half a step. Sub-elements of a composite share the volumetric part of their stress.
template <int D>
void element_force(const ElementForceIn<D>& in, const ElementForceOut<D>& out);

/// The same in single precision behind the deformation: C - 1 and J - 1 are formed in double, so
/// that the noise of strains is a share of 6e-8, not 6e-8 itself, also where an element has turned.
template <int D>
void element_force_single(const ElementForceIn<D>& in, const ElementForceOut<D>& out);

extern template void element_force_single<2>(const ElementForceIn<2>&, const ElementForceOut<2>&);
extern template void element_force_single<3>(const ElementForceIn<3>&, const ElementForceOut<3>&);
extern template void element_force<2>(const ElementForceIn<2>&, const ElementForceOut<2>&);
extern template void element_force<3>(const ElementForceIn<3>&, const ElementForceOut<3>&);

}  // namespace breccia
