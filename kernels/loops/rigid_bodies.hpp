#pragma once
#include "base/mat.hpp"
#include "loops/node_motion.hpp"
#include "point/ramp.hpp"

namespace breccia {

/// What turns a rigid body.
enum class RigidTurning { free, held, given };

/// A rigid body as its mesh makes it: the masses of its nodes, lumped.
template <int D>
struct RigidBody {
  double mass = 0;           ///< kg
  Vec<3> inverse_inertia;    ///< 1/(kg m2), about the principal axes; in the plane (0, 0, 1/I)
  Mat<3> axes;               ///< principal axes in the reference mesh, as columns
  Vec<D> origin;             ///< centre of mass in the reference mesh, m
  double gyration = 0;       ///< smallest radius of gyration, m
  Index boundary = -1;       ///< row of boundary_velocity that moves its centre, or none
  std::uint32_t driven = 0;  ///< components that it moves
  RigidTurning turning = RigidTurning::free;
  bool pivots = false;  ///< turns freely though a boundary moves its centre
  Vec<3> spin;          ///< rad/s, where it is given
  Ramp ramp;            ///< course of the given spin
};

/// Rows: force on a body's nodes (3) and its torque about the centre of mass (3).
using RigidLoads = Vectors<6>;

template <int D>
struct RigidForceIn {
  NodeMotionIn<D> nodes;  ///< needs no velocity and no step
  ConstVectors<D> x;
  ConstVectors<D> centre;                   ///< of each body, m
  Kokkos::View<const Index*, Memory> list;  ///< nodes, body after body
  ConstRanges parts;                        ///< stretches of the list, of one body each
  Kokkos::View<const Index*, Memory> body;  ///< of each stretch
};

/// Adds up force and torque of each stretch, in the order of the list.
template <int D>
void rigid_forces(Index parts, const RigidForceIn<D>& in, const RigidLoads& load);

template <int D>
struct RigidMotionIn {
  Kokkos::View<const RigidBody<D>*, Memory> body;
  ConstRanges parts_of;  ///< stretches of each body
  RigidLoads part_load;
  ConstVectors<D> boundary_velocity;
  Kokkos::View<const double* [2], Rows, Memory> table;  ///< of given spins
  double dt, kick;                                      ///< s
  double middle;                                        ///< s, t^(n+1/2)
};

template <int D>
struct RigidMotionOut {
  Vectors<D> centre, velocity;
  Vectors<4> turn;          ///< quaternion w, x, y, z since the reference
  Vectors<3> momentum;      ///< angular, about the centre of mass, N m s
  Vectors<3> spin;          ///< angular velocity, rad/s
  RigidLoads load;          ///< N and N m
  Array<double> unbalance;  ///< N, larger of the free force and the torque over `gyration`
  Matrices<D> change;       ///< (R(t + dt) - R(t)) / dt, 1/s
};

/// Moves each body by its force and torque, with the rotation of point/rigid_motion.hpp:
///   V += kick F / M,  X += dt V,  L += kick T,  R turned as without torque.
template <int D>
void rigid_motion(Index bodies, const RigidMotionIn<D>& in, const RigidMotionOut<D>& out);

/// Adds a stiffness to the nodes that keeps the step so short that a body turns by at most 0.01 and
/// moves by at most a tenth of its radius of gyration in it.
template <int D>
void rigid_pace(Index parts, const RigidForceIn<D>& in,
                const Kokkos::View<const RigidBody<D>*, Memory>& body, const ConstVectors<D>& v,
                const ConstVectors<3>& spin, const Kokkos::View<const double*, Memory>& mass,
                const Array<double>& stiffness);

extern template void rigid_forces<2>(Index, const RigidForceIn<2>&, const RigidLoads&);
extern template void rigid_forces<3>(Index, const RigidForceIn<3>&, const RigidLoads&);
extern template void rigid_motion<2>(Index, const RigidMotionIn<2>&, const RigidMotionOut<2>&);
extern template void rigid_motion<3>(Index, const RigidMotionIn<3>&, const RigidMotionOut<3>&);

}  // namespace breccia
