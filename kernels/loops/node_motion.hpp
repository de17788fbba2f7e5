#pragma once
#include "base/sums.hpp"
#include "base/views.hpp"

#include <cstdint>

namespace breccia {

/// Number of force classes of which the motion loop books the work: element, interface,
/// contact, load, gravity, constraint, relaxation, absorber (step/ledger.hpp).
inline constexpr int kWorks = 8;

/// Corner force classes besides the element's own; a node has them where its flag bit is set.
inline constexpr int kExtraClasses = 3;

template <int D>
struct NodeMotionIn {
  ConstRanges corners;  ///< per node
  Kokkos::View<const Index*, Memory> corner_list;
  AnyCornerForces<D> element_force;
  Kokkos::Array<ConstCornerForces<D>, kExtraClasses> extra;  ///< interface, contact, load
  Kokkos::Array<std::uint32_t, kExtraClasses> extra_bit;     ///< 0 where the class is absent
  Kokkos::View<const std::uint32_t*, Memory> flags;
  Kokkos::View<const double*, Memory> mass;
  ConstVectors<D> boundary_velocity;
  Kokkos::View<const double*, Memory> added_mass;  ///< kg without weight; empty: none
  Vec<D> gravity;                                  ///< m/s2
  Kokkos::View<const Index*, Memory> absorber;     ///< row of an element in `absorbing`, or none
  ConstCornerMatrices<D> absorbing;                ///< kg/s, at the corners of such elements
  std::uint32_t absorb_bit = 0;                    ///< 0 where no boundary lets waves out
  double resisting = 0;      ///< share of the net force that resists motion (local damping)
  double dt, kick;           ///< s
  std::uint32_t fixed_bits;  ///< mask of the prescribed components in `flags`
  int boundary_shift;
  std::uint32_t rigid_bit = 0;  ///< 0 where no body is rigid
  /// A rigid node moves by dt (velocity + change (X - origin)) with these of its body.
  ConstVectors<D> rigid_velocity, rigid_origin;
  ConstMatrices<D> rigid_change;
  ConstVectors<D> reference;  ///< X, m
};

template <int D>
struct NodeMotionOut {
  Vectors<D> x, v;
  Vectors<D> reaction;     ///< N; empty where nothing is prescribed
  ChunkSums<kWorks> work;  ///< J, adds this step's work of every force class
};

/// Gathers the forces of each node in corner order and moves it:
///   v += kick f / m,  x += dt v,  dW_k = f_k . (v_old + v_new) / 2 kick.
/// Local damping adds -resisting |f_d| sign(v_d) in every component that is free.
/// Boundaries that let waves out resist with -C (v_old + v_new) / 2.
/// Nodes without mass (excavated) stay where they are.
/// Prescribed components take the boundary's velocity, nodes of rigid bodies that of their body;
/// what holds them is their reaction.
template <int D>
void node_motion(Index nodes, const NodeMotionIn<D>& in, const NodeMotionOut<D>& out);

extern template void node_motion<2>(Index, const NodeMotionIn<2>&, const NodeMotionOut<2>&);
extern template void node_motion<3>(Index, const NodeMotionIn<3>&, const NodeMotionOut<3>&);

}  // namespace breccia
