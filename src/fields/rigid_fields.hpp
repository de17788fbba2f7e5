#pragma once
#include "fields/field.hpp"

namespace breccia {

// Rigid bodies: where they are and how they move.

template <int D>
struct RigidCentre {
  using View = Vectors<D>;
  static constexpr FieldInfo info{"rigid_centre", Entity::rigid, "m", Restart::yes,
                                  "centre of mass at t^n"};
};

template <int D>
struct RigidVelocity {
  using View = Vectors<D>;
  static constexpr FieldInfo info{"rigid_velocity", Entity::rigid, "m/s", Restart::yes,
                                  "velocity of the centre of mass at t^(n-1/2)"};
};

struct RigidTurn {
  using View = Vectors<4>;
  static constexpr FieldInfo info{"rigid_turn", Entity::rigid, "1", Restart::yes,
                                  "rotation since the start as a quaternion w, x, y, z"};
};

struct RigidMomentum {
  using View = Vectors<3>;
  static constexpr FieldInfo info{"rigid_momentum", Entity::rigid, "N m s", Restart::yes,
                                  "angular momentum about the centre of mass at t^(n-1/2)"};
};

struct RigidSpin {
  using View = Vectors<3>;
  static constexpr FieldInfo info{"rigid_spin", Entity::rigid, "rad/s", Restart::yes,
                                  "angular velocity at t^(n-1/2)"};
};

/// Force and torque of everything but what drives the body.
struct RigidLoad {
  using View = Vectors<6>;
  static constexpr FieldInfo info{"rigid_load", Entity::rigid, "N, N m", Restart::no,
                                  "force (3) and torque about the centre of mass (3)"};
};

/// Larger of the free part of the force and of the torque over the radius of gyration.
struct RigidUnbalance {
  using View = Array<double>;
  static constexpr FieldInfo info{"rigid_unbalance", Entity::rigid, "N", Restart::no,
                                  "force that nothing holds"};
};

// What the motion loop moves a body's nodes by.

template <int D>
struct RigidChange {
  using View = Matrices<D>;
  static constexpr FieldInfo info{"rigid_change", Entity::rigid, "1/s", Restart::no,
                                  "change of the rotation matrix over its step"};
};

template <int D>
struct RigidOrigin {
  using View = Vectors<D>;
  static constexpr FieldInfo info{"rigid_origin", Entity::rigid, "m", Restart::no,
                                  "centre of mass in the reference configuration"};
};

}  // namespace breccia
