#pragma once
#include "point/cohesive.hpp"
#include "point/friction_law.hpp"

namespace breccia {

// Law of one corner of a fault: a face without strength that was there before the first step.
//
// symbols  jump [m] x_right - x_left in the face's frame, normal first
//          T [Pa] traction that friction sees, T = k (jump - dp) + k d0 + load
//          d0 [m] offset of the normal spring: the face begins with the traction of the ground
//          load [Pa] traction of a stress that stands on the fault but not in the elements
//          dp [m] plastic slip   s [m] its length so far
//          k_n, k_s [Pa/m] stiffness   c_n, c_s [Pa s/m] damping
// source   ALGORITHMS with D = 1 and c_0 = 0; the loops take T - load for the elements
// page     docs/modules/faults.md

template <int D>
struct FaultState {
  double offset;       ///< d0, m
  double slip;         ///< s, m
  double rate;         ///< V, m/s
  double theta;        ///< state variable of the friction, s
  double opening;      ///< largest so far, m
  Vec<D> load;         ///< Pa
  Vec<D - 1> plastic;  ///< dp, m
  Vec<D> jump;         ///< at the last step, m
  Vec<D> viscous;      ///< viscous traction at the last step, Pa
};

template <int D>
struct Fault {
  using State = FaultState<D>;
  FrictionLaw friction;
  CohesiveSprings springs;

  /// The state of a corner that begins with the traction t0 of the elements, Pa.
  KOKKOS_FUNCTION
  State encode(const Vec<D>& t0, const Vec<D>& load) const {
    State s;
    // eq:fault-1  k_n d0 = min(t0_n, -load_n), dp = -t0_s / k_s: nothing is pulled
    s.offset = Kokkos::min(t0[0], -load[0]) / springs.normal;
    for (int i = 0; i < D - 1; ++i) s.plastic[i] = -t0[i + 1] / springs.shear;
    s.slip = s.rate = s.opening = 0;
    s.theta = friction.state;
    s.load = load;
    s.jump = s.viscous = Vec<D>::zero();
    return s;
  }

  /// eq:fault-2  N = -(k_n (jump_n + d0) + load_n), zero where the face is open
  KOKKOS_FUNCTION
  double pressure(const State& s) const {
    return Kokkos::max(0.0, -(springs.normal * (s.jump[0] + s.offset) + s.load[0]));
  }

  /// eq:fault-3  tau = k_s (jump_s - dp) + load_s
  KOKKOS_FUNCTION
  Vec<D - 1> shear(const State& s) const {
    Vec<D - 1> tau;
    for (int i = 0; i < D - 1; ++i)
      tau[i] = springs.shear * (s.jump[i + 1] - s.plastic[i]) + s.load[i + 1];
    return tau;
  }

  /// Energy of the springs and of what stands on the fault alone, J/m2:
  /// eq:fault-4  N^2 / (2 k_n) + tau^2 / (2 k_s) - load . jump
  KOKKOS_FUNCTION
  double stored(const State& s) const {
    const double n = pressure(s);
    return 0.5 * n * n / springs.normal + 0.5 * norm2(shear(s)) / springs.shear -
           dot(s.load, s.jump);
  }

  /// Moves the state on to the jump at t^n and adds what the step spent. `rate` is one over the
  /// time since the last call, 1/s; 0 in the first. Returns the traction on the elements.
  template <class Spent>
  KOKKOS_FUNCTION
  Vec<D> advance(State& s, const Vec<D>& jump, double rate, Spent& spent) const {
    const State old = s;
    const Vec<D - 1> before = shear(old);
    s.jump = jump;
    s.opening = Kokkos::max(s.opening, jump[0]);
    const double pressed = pressure(s);
    const Vec<D - 1> trial = shear(s);
    const double length = norm(trial);
    Slide now{0, old.rate, old.theta};
    const double time = rate > 0 ? 1 / rate : 0;
    if (pressed > 0)
      now = slide_of(friction, length, pressed, springs.shear, time, old.slip, now);
    else  // open: nothing holds the slip
      now = {length / springs.shear, length / springs.shear * rate,
             friction.aged(old.theta, length / springs.shear * rate, time)};
    s.slip = old.slip + now.slipped;
    s.rate = now.rate;
    s.theta = now.theta;
    for (int i = 0; i < D - 1; ++i)
      s.plastic[i] = old.plastic[i] + (length > 0 ? now.slipped * trial[i] / length : 0);
    // eq:fault-5  heat = mean tau . d(dp)
    const Vec<D - 1> tau = shear(s);
    for (int i = 0; i < D - 1; ++i)
      spent.friction += 0.5 * (before[i] + tau[i]) * (s.plastic[i] - old.plastic[i]);

    Vec<D> t;
    t[0] = -pressed - s.load[0];
    for (int i = 0; i < D - 1; ++i) t[i + 1] = tau[i] - s.load[i + 1];
    damp(old, s, pressed, rate, now.slipped == 0);
    for (int i = 0; i < D; ++i)
      spent.viscous += 0.5 * (old.viscous[i] + s.viscous[i]) * (jump[i] - old.jump[i]);
    return t + s.viscous;
  }

 private:
  /// eq:fault-6  c_n d(jump_n)/dt, never pulling; c_s d(jump_s)/dt while it sticks; none where open
  KOKKOS_FUNCTION
  void damp(const State& old, State& s, double pressed, double rate, bool sticks) const {
    s.viscous = Vec<D>::zero();
    if (!(pressed > 0)) return;
    s.viscous[0] = Kokkos::min(springs.normal_damping * (s.jump[0] - old.jump[0]) * rate, pressed);
    if (!sticks) return;
    for (int i = 1; i < D; ++i)
      s.viscous[i] = springs.shear_damping * (s.jump[i] - old.jump[i]) * rate;
  }
};

}  // namespace breccia
