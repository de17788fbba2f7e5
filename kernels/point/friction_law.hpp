#pragma once
#include <Kokkos_MathematicalFunctions.hpp>
#include <Kokkos_MinMax.hpp>

#include <cstdint>

namespace breccia {

// Coefficients of friction of faults and surfaces.
//
// symbols  mu [1] coefficient   mu_s, mu_d [1] at rest, sliding   s [m] slip so far   V [m/s] slip
//          rate   D_c [m] slip that weakening takes   v_c [m/s] speed of it
//          a, b, mu_0 [1], V_0 [m/s], L [m] of rate and state   theta [s] state variable
// source   slip weakening: Andrews (1976), doi:10.1029/JB081i032p05679; velocity weakening: Cochard
//          and Madariaga (1994), doi:10.1007/BF00876049; rate and state: Dieterich (1979),
//          doi:10.1029/JB084iB05p02161, Ruina (1983), doi:10.1029/JB088iB12p10359, regularised at
//          rest as by Rice, Lapusta and Ranjith (2001), doi:10.1016/S0022-5096(01)00042-4
// page     docs/modules/faults.md

enum class FrictionKind : std::uint8_t {
  coulomb,
  static_dynamic,
  slip_weakening,
  velocity_weakening,
  ageing,
  slip_law
};

struct FrictionLaw {
  FrictionKind kind = FrictionKind::coulomb;
  double at_rest = 0;  ///< mu_s; of coulomb the only one; of rate and state mu_0
  double sliding = 0;  ///< mu_d
  double length = 0;   ///< D_c or L, m
  double speed = 0;    ///< v_c or V_0, m/s
  double a = 0, b = 0;
  double state = 0;  ///< theta at the start, s

  KOKKOS_FUNCTION
  bool has_state() const { return kind == FrictionKind::ageing || kind == FrictionKind::slip_law; }

  /// mu for slip s, slip rate V and state theta.
  KOKKOS_FUNCTION
  double coefficient(double slip, double rate, double theta) const {
    switch (kind) {
      case FrictionKind::coulomb:
        return at_rest;
      case FrictionKind::static_dynamic:
        // eq:friction-1  mu = mu_d + (mu_s - mu_d) exp(-V / v_c)
        return sliding + (at_rest - sliding) * Kokkos::exp(-rate / speed);
      case FrictionKind::slip_weakening:
        // eq:friction-2  mu = mu_s - (mu_s - mu_d) min(s / D_c, 1)
        return at_rest - (at_rest - sliding) * Kokkos::min(slip / length, 1.0);
      case FrictionKind::velocity_weakening:
        // eq:friction-3  mu = mu_d + (mu_s - mu_d) v_c / (v_c + V)
        return sliding + (at_rest - sliding) * speed / (speed + rate);
      case FrictionKind::ageing:
      case FrictionKind::slip_law:
        break;
    }
    // eq:friction-4  mu = a asinh( V / (2 V_0) exp((mu_0 + b ln(V_0 theta / L)) / a) )
    const double log_state = Kokkos::log(speed * theta / length);
    return a * Kokkos::asinh(0.5 * rate / speed * Kokkos::exp((at_rest + b * log_state) / a));
  }

  /// theta after `time` at the slip rate V, exact while V is constant.
  KOKKOS_FUNCTION
  double aged(double theta, double rate, double time) const {
    const double way = rate * time / length;
    // eq:friction-5  ageing: d theta/dt = 1 - V theta / L
    if (kind == FrictionKind::ageing)
      return theta * Kokkos::exp(-way) + (way > 0 ? -Kokkos::expm1(-way) / way : 1.0) * time;
    // eq:friction-6  slip law: d theta/dt = -(V theta / L) ln(V theta / L)
    if (kind == FrictionKind::slip_law && rate > 0)
      return length / rate * Kokkos::pow(rate * theta / length, Kokkos::exp(-way));
    return theta;
  }
};

/// What slides in a step, and the rate and state that it leaves.
struct Slide {
  double slipped = 0;  ///< m
  double rate = 0;     ///< V, m/s
  double theta = 0;    ///< s
};

/// Slip of a spring of stiffness k [Pa/m] that would reach the shear traction `trial` [Pa] if
/// nothing slipped, under the pressure N [Pa]: eq:friction-7  trial - k ds = mu N. Slip weakening
/// and rate and state are implicit in the slip of the step; laws of speed take the speed of the
/// step before. `time` is the length of the step, s; 0: nothing slides by rate and state.
KOKKOS_INLINE_FUNCTION
Slide slide_of(const FrictionLaw& law, double trial, double pressure, double stiffness, double time,
               double slip, const Slide& before) {
  Slide now = before;
  now.slipped = 0;
  if (!law.has_state()) {
    double room = trial - pressure * law.coefficient(slip, before.rate, before.theta);
    if (room > 0 && law.kind == FrictionKind::slip_weakening) {
      // Where the line falls faster than the spring, the step takes the coefficient it began with.
      const double fall = pressure * (law.at_rest - law.sliding) / law.length;
      const double ahead = fall < stiffness ? room / (stiffness - fall) : room / stiffness;
      if (fall < stiffness && slip < law.length)
        room = slip + ahead <= law.length ? stiffness * ahead : trial - pressure * law.sliding;
    }
    now.slipped = Kokkos::max(0.0, room / stiffness);
    now.rate = time > 0 ? now.slipped / time : 0;
    return now;
  }
  if (!(time > 0)) return now;
  // With V = V_1 sinh(y), mu = a y: N a y + k V_1 sinh(y) dt = trial. The left side is convex and
  // grows, so that Newton's steps from above come down to the root and never pass it.
  const double log_state = Kokkos::log(law.speed * before.theta / law.length);
  const double one = 2 * law.speed * Kokkos::exp(-(law.at_rest + law.b * log_state) / law.a);
  const double give = stiffness * time * one, hold = pressure * law.a;
  if (!(trial > 0)) return now;
  double y = Kokkos::min(trial / hold, Kokkos::asinh(trial / give));
  constexpr int kTries = 100;
  for (int i = 0; i < kTries; ++i) {
    const double miss = hold * y + give * Kokkos::sinh(y) - trial;
    const double next = y - miss / (hold + give * Kokkos::cosh(y));
    const bool done = !(next < y);
    if (next > 0) y = next;
    if (done) break;
  }
  const double rate = one * Kokkos::sinh(y);
  now.rate = rate;
  now.slipped = rate * time;
  now.theta = law.aged(before.theta, rate, time);
  return now;
}

}  // namespace breccia
