#include "loops/rigid_bodies.hpp"

#include "loops/net_force.hpp"
#include "point/rigid_motion.hpp"

namespace breccia {

namespace {

template <int D>
KOKKOS_INLINE_FUNCTION
Vec<3> in_space(const Vec<D>& a) {
  Vec<3> b = Vec<3>::zero();
  for (int d = 0; d < D; ++d) b[d] = a[d];
  return b;
}

template <int D>
struct RigidMotionLoop {
  RigidMotionIn<D> in;
  RigidMotionOut<D> out;

  KOKKOS_FUNCTION
  void operator()(Index b) const {
    const RigidBody<D> body = in.body(b);
    Vec<3> force = Vec<3>::zero(), torque = Vec<3>::zero();
    for (Index p = in.parts_of(b, 0); p < in.parts_of(b, 1); ++p)
      for (int d = 0; d < 3; ++d) {
        force[d] += in.part_load(p, d);
        torque[d] += in.part_load(p, 3 + d);
      }
    for (int d = 0; d < 3; ++d) {
      out.load(b, d) = force[d];
      out.load(b, 3 + d) = torque[d];
    }

    Vec<D> v = row<D>(out.velocity, b);
    double free = 0;
    for (int d = 0; d < D; ++d)
      if ((body.driven & (1u << d)) != 0) {
        v[d] = in.boundary_velocity(body.boundary, d);
      } else {
        v[d] += force[d] * (in.kick / body.mass);
        free += force[d] * force[d];
      }
    const double turning = body.turning == RigidTurning::free ? norm(torque) / body.gyration : 0.0;
    out.unbalance(b) = Kokkos::max(Kokkos::sqrt(free), turning);
    set_row<D>(out.velocity, b, v);
    set_row<D>(out.centre, b, row<D>(out.centre, b) + v * in.dt);
    rotate(b, body, torque);
  }

 private:
  KOKKOS_FUNCTION
  void rotate(Index b, const RigidBody<D>& body, const Vec<3>& torque) const {
    const Quaternion q{out.turn(b, 0), {out.turn(b, 1), out.turn(b, 2), out.turn(b, 3)}};
    const Mat<3> now = matrix_of(q), axes = now * body.axes;
    Vec<3> momentum = Vec<3>::zero(), spin = Vec<3>::zero();
    Quaternion turn = Quaternion::identity();
    if (body.turning == RigidTurning::free) {
      momentum = row<3>(out.momentum, b) + torque * in.kick;
      const Vec<3> along = transpose(axes) * momentum;
      Vec<3> rates;
      for (int i = 0; i < 3; ++i) rates[i] = along[i] * body.inverse_inertia[i];
      spin = axes * rates;
      turn = FreeRotor{body.inverse_inertia}.turn(along, in.dt);
      turn.u = axes * turn.u;
    } else if (body.turning == RigidTurning::given) {
      spin = body.spin * body.ramp.factor(in.middle, in.table);
      const Vec<3> rates = transpose(axes) * spin;
      Vec<3> along = Vec<3>::zero();
      for (int i = 0; i < 3; ++i)
        if (body.inverse_inertia[i] > 0) along[i] = rates[i] / body.inverse_inertia[i];
      momentum = axes * along;
      turn = Quaternion::of(spin * in.dt);
    }
    set_row<3>(out.momentum, b, momentum);
    set_row<3>(out.spin, b, spin);
    const Mat<3> change = (in.dt > 0 ? turn_less_one(turn) : cross_matrix(spin)) * now;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        out.change(b, i, j) = in.dt > 0 ? change(i, j) / in.dt : change(i, j);
    const Quaternion next = normalised(turn * q);
    out.turn(b, 0) = next.w;
    for (int d = 0; d < 3; ++d) out.turn(b, 1 + d) = next.u[d];
  }
};

}  // namespace

template <int D>
void rigid_forces(Index parts, const RigidForceIn<D>& in, const RigidLoads& load) {
  const NetForce<D> net{in.nodes};
  for_each(
      "breccia::rigid::forces", parts, KOKKOS_LAMBDA(Index p) {
        const Vec<D> centre = row<D>(in.centre, in.body(p));
        Vec<3> force = Vec<3>::zero(), torque = Vec<3>::zero();
        for (Index k = in.parts(p, 0); k < in.parts(p, 1); ++k) {
          const Index n = in.list(k);
          const Vec<3> f = in_space<D>(net(n));
          force += f;
          torque += cross(in_space<D>(row<D>(in.x, n) - centre), f);
        }
        for (int d = 0; d < 3; ++d) {
          load(p, d) = force[d];
          load(p, 3 + d) = torque[d];
        }
      });
}

template <int D>
void rigid_motion(Index bodies, const RigidMotionIn<D>& in, const RigidMotionOut<D>& out) {
  for_each("breccia::rigid::motion", bodies, RigidMotionLoop<D>{in, out});
}

template <int D>
void rigid_pace(Index parts, const RigidForceIn<D>& in,
                const Kokkos::View<const RigidBody<D>*, Memory>& body, const ConstVectors<D>& v,
                const ConstVectors<3>& spin, const Kokkos::View<const double*, Memory>& mass,
                const Array<double>& stiffness) {
  constexpr double kTurns = 100, kWays = 10;  // steps per radian, per radius
  const auto list = in.list, owner = in.body;
  const auto ranges = in.parts;
  for_each(
      "breccia::rigid::pace", parts, KOKKOS_LAMBDA(Index p) {
        const Index b = owner(p);
        const double turning = kTurns * norm(row<3>(spin, b));
        const double moving = kWays * norm(row<D>(v, b)) / body(b).gyration;
        const double rate = Kokkos::max(turning, moving);
        for (Index k = ranges(p, 0); k < ranges(p, 1); ++k)
          stiffness(list(k)) += mass(list(k)) * rate * rate;
      });
}

template void rigid_forces<2>(Index, const RigidForceIn<2>&, const RigidLoads&);
template void rigid_forces<3>(Index, const RigidForceIn<3>&, const RigidLoads&);
template void rigid_motion<2>(Index, const RigidMotionIn<2>&, const RigidMotionOut<2>&);
template void rigid_motion<3>(Index, const RigidMotionIn<3>&, const RigidMotionOut<3>&);

#define BRECCIA_RIGID_PACE(D)                                                   \
  template void rigid_pace<D>(Index, const RigidForceIn<D>&,                    \
                              const Kokkos::View<const RigidBody<D>*, Memory>&, \
                              const ConstVectors<D>&, const ConstVectors<3>&,   \
                              const Kokkos::View<const double*, Memory>&, const Array<double>&);
BRECCIA_RIGID_PACE(2)
BRECCIA_RIGID_PACE(3)
#undef BRECCIA_RIGID_PACE

}  // namespace breccia
