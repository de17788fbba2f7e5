#pragma once
#include "base/vec.hpp"
#include "point/softening.hpp"

namespace breccia {

// Law of one corner of an inserted face: unified cohesive model with a shifted origin.
//
// symbols  jump [m] x_right - x_left in the face's frame, normal first
//          d0 [m] offset of the origin, k_n d0 the normal traction at insertion
//          w [m] virtual opening   kap [m] largest w so far   w_p, w_f [m] at the peak, at the
//          break
//          xi [m] elastic slip     dp [m] plastic slip        s [m] its length so far
//          D, D_I, D_II [1] damage, its share of opening, of slip   S(D) [1] strength left
//          f_t, c_0 [Pa] tensile strength, cohesion; with a star: not less than the traction at
//          insertion demands   mu_i, mu_r [1] friction of the intact and of the broken face
//          G_I, G_II [J/m2] energies   k_n, k_s [Pa/m] stiffness   c_n, c_s [Pa s/m] damping
// source   ALGORITHMS; damping
// page     docs/modules/fracture.md

/// Strength and energy of a face.
struct CohesiveStrength {
  double tension = 0;            ///< f_t, Pa
  double cohesion = 0;           ///< c_0, Pa
  double friction = 0;           ///< mu_i
  double residual_friction = 0;  ///< mu_r
  double energy_tension = 0;     ///< G_I, J/m2
  double energy_shear = 0;       ///< G_II, J/m2
};

/// Springs and dashpots of a face per area.
struct CohesiveSprings {
  double normal = 0, shear = 0;                  ///< k_n, k_s, Pa/m
  double normal_damping = 0, shear_damping = 0;  ///< c_n, c_s, Pa s/m
};

/// All that a corner remembers.
template <int D>
struct CohesiveState {
  double offset;         ///< d0, m
  double opening;        ///< kap, m
  double slip;           ///< s, m
  double damage;         ///< D
  double strength;       ///< f_t*, Pa
  double cohesion;       ///< c_0*, Pa
  double opening_reach;  ///< w_f - w_p, m
  double slip_reach;     ///< s_f, m
  Vec<D - 1> plastic;    ///< dp, m
  Vec<D> jump;           ///< at the last step, m
  Vec<D> viscous;        ///< viscous traction at the last step, Pa
};

/// Energy per area that a step turned into something else, J/m2.
struct CohesiveSpent {
  double tension = 0, shear = 0, friction = 0, viscous = 0;
};

template <int D>
struct CohesiveResponse {
  Vec<D> traction;  ///< on the left face, viscous part included, Pa
  CohesiveState<D> next;
  CohesiveSpent spent;
};

template <int D, class Softening>
struct Cohesive {
  using State = CohesiveState<D>;
  CohesiveStrength strength;
  CohesiveSprings springs;

  /// Traction for the jump at t^n and what it changes. `rate` is one over the time since the last
  /// call, 1/s; 0 leaves the dashpots out.
  KOKKOS_FUNCTION
  CohesiveResponse<D> respond(const State& old, const Vec<D>& jump, double rate) const;

  /// The same in place, for the loop of every step: `state` moves on, `spent` grows by what the
  /// step spent. Corners whose damage and slip stand still, nearly all, take a short way. Returns
  /// the traction.
  template <class Spent>
  KOKKOS_FORCEINLINE_FUNCTION
  Vec<D> advance(State& state, const Vec<D>& jump, double rate, Spent& spent) const;

  /// Energy that closing the face without further damage would give back, J/m2; zero at zero
  /// jump but for the slip that the face was born with (`encoded_energy`).
  KOKKOS_FUNCTION
  double stored(const State& state) const {
    return normal_energy(state, state.jump[0]) +
           0.5 * springs.shear * norm2(elastic_slip(state, state.jump));
  }

  /// xi, m
  KOKKOS_FUNCTION
  static Vec<D - 1> elastic_slip(const State& state, const Vec<D>& jump) {
    Vec<D - 1> xi;
    for (int i = 0; i < D - 1; ++i) xi[i] = jump[i + 1] - state.plastic[i];
    return xi;
  }

 private:
  /// What follows from a guess of the damage at the end of the step.
  struct Trial {
    double damage, opening_now, opening, normal, yield, slipped, wanted;
  };

  KOKKOS_FUNCTION
  static double shifted(const State& s, double jump, double damage) {
    return jump + (1 - damage) * s.offset;  // eq:cohesive-3  w = jump_n + (1 - D) d0
  }

  /// eq:cohesive-4  secant stiffness min(k_n, f_t* S / kap), so T = min(k_n kap, f_t* S) at kap
  KOKKOS_FUNCTION
  double secant(const State& s, double opening, double damage) const {
    const double peak = s.strength * Softening::left(damage);
    return springs.normal * opening <= peak ? springs.normal : peak / opening;
  }

  /// eq:cohesive-5  T_n = k_n w in compression, secant w in tension
  KOKKOS_FUNCTION
  double normal_traction(const State& s, double w, double opening, double damage) const {
    return (w <= 0 ? springs.normal : secant(s, opening, damage)) * w;
  }

  /// eq:cohesive-6  mu = mu_i S + mu_r (1 - S), pressed by -T_n
  KOKKOS_FUNCTION
  double friction_traction(double damage, double normal) const {
    const double left = Softening::left(damage);
    const double mu = strength.friction * left + strength.residual_friction * (1 - left);
    return mu * Kokkos::max(0.0, -normal);
  }

  /// eq:cohesive-7  cohesion left, S max(0, c_0* - mu_i max(0, T_n))
  KOKKOS_FUNCTION
  double cohesive_traction(const State& s, double damage, double normal) const {
    const double c = s.cohesion - strength.friction * Kokkos::max(0.0, normal);
    return Softening::left(damage) * Kokkos::max(0.0, c);
  }

  /// Half the spring's w^2 minus what it has at zero jump.
  KOKKOS_FUNCTION
  double normal_energy(const State& s, double jump) const {
    const double w = shifted(s, jump, s.damage), w0 = shifted(s, 0, s.damage);
    const double k = secant(s, s.opening, s.damage);
    return 0.5 * ((w < 0 ? springs.normal : k) * w * w - (w0 < 0 ? springs.normal : k) * w0 * w0);
  }

  KOKKOS_FUNCTION
  Trial try_damage(const State& old, const Vec<D>& jump, double elastic_trial, double damage) const;
  KOKKOS_FUNCTION
  Trial solve_damage(const State& old, const Vec<D>& jump, double elastic_trial) const;
  KOKKOS_FUNCTION
  double spent_in_opening(const State& old, const State& next, double normal, double done) const;
  KOKKOS_FUNCTION
  Vec<D> dashpots(const State& old, const State& next, double normal, double rate) const;
};

template <int D, class Softening>
KOKKOS_FUNCTION
auto Cohesive<D, Softening>::try_damage(const State& old, const Vec<D>& jump, double elastic_trial,
                                        double damage) const -> Trial {
  Trial t;
  t.damage = damage;
  t.opening_now = shifted(old, jump[0], damage);
  t.opening = Kokkos::max(old.opening, t.opening_now);
  t.normal = normal_traction(old, t.opening_now, t.opening, damage);
  // eq:cohesive-8  |tau| <= cohesion left + friction; what exceeds it becomes slip
  t.yield = cohesive_traction(old, damage, t.normal) + friction_traction(damage, t.normal);
  t.slipped = Kokkos::max(0.0, (elastic_trial - t.yield) / springs.shear);
  // eq:cohesive-9  D_I = (kap - w_p) / (w_f - w_p), D_II = s / s_f, D = sqrt(D_I^2 + D_II^2)
  if (t.slipped == 0 && t.opening == old.opening) {
    t.wanted = old.damage;  // nothing that damage depends on has moved
    return t;
  }
  const double excess = springs.normal * t.opening - old.strength;
  const double d1 = excess > 0 ? excess / (springs.normal * old.opening_reach) : 0;
  const double d2 = (old.slip + t.slipped) / old.slip_reach;
  t.wanted = Kokkos::sqrt(d1 * d1 + d2 * d2);
  return t;
}

/// The damage at the end of the step as the root of wanted(D) = D, which is unique because the
/// difference falls with D (encode keeps the reaches long enough). Illinois method.
template <int D, class Softening>
KOKKOS_FUNCTION
auto Cohesive<D, Softening>::solve_damage(const State& old, const Vec<D>& jump,
                                          double elastic_trial) const -> Trial {
  constexpr double kTolerance = 4e-16;
  constexpr int kTries = 60;
  Trial low = try_damage(old, jump, elastic_trial, old.damage);
  if (old.damage >= 1 || low.wanted <= old.damage) return low;
  Trial high = try_damage(old, jump, elastic_trial, 1);
  if (high.wanted >= 1) return high;
  double below = low.wanted - low.damage, above = high.wanted - high.damage;
  double guess = Kokkos::min(1.0, low.wanted);
  Trial t = low;
  int side = 0;
  for (int i = 0; i < kTries; ++i) {
    t = try_damage(old, jump, elastic_trial, guess);
    const double miss = t.wanted - guess;
    if (Kokkos::abs(miss) <= kTolerance) break;
    if (miss > 0) {
      low = t;
      below = miss;
      if (side == 1) above *= 0.5;
      side = 1;
    } else {
      high = t;
      above = miss;
      if (side == -1) below *= 0.5;
      side = -1;
    }
    const double next = (low.damage * above - high.damage * below) / (above - below);
    if (!(next > low.damage && next < high.damage)) break;
    guess = next;
  }
  return t;
}

/// eq:cohesive-10  dW_I = mean T_n d(jump_n) - d(stored), counted from where damage begins; `done`
/// is the part of the step up to D = 1. Zero where neither damage nor stiffness changed. A step
/// that ends or begins closed meets the kink at w = 0, which costs nothing: there dW_I is what the
/// spring loses at either end by the change of damage, on average.
template <int D, class Softening>
KOKKOS_FUNCTION
double Cohesive<D, Softening>::spent_in_opening(const State& old, const State& next, double normal,
                                                double done) const {
  const double k_old = secant(old, old.opening, old.damage);
  const double k_new = secant(next, next.opening, next.damage);
  if (old.damage >= 1 || (next.damage <= old.damage && k_new >= k_old)) return 0;
  double from = old.jump[0];
  double w = shifted(old, from, old.damage);
  const double to = next.jump[0], w_to = shifted(next, to, next.damage);
  double traction = k_old * w;
  // Up to `limit` the way is elastic.
  const double limit =
      Kokkos::max(old.opening, old.strength * Softening::left(old.damage) / springs.normal);
  if (w < limit && shifted(old, to, old.damage) > limit) {
    from += limit - w;
    w = limit;
    traction = old.strength * Softening::left(old.damage);
  }
  const double before = normal_energy(old, from), after = normal_energy(next, to);
  if (w <= 0 || w_to <= 0)
    return 0.5 * (before - normal_energy(next, from) + normal_energy(old, to) - after);
  if (next.damage >= 1) return 0.5 * traction * (to - from) * done + before;
  return 0.5 * (traction + normal) * (to - from) + before - after;
}

/// eq:cohesive-11  viscous tractions c_n d(jump_n)/dt and c_s d(xi)/dt, fading with the stiffness
/// they belong to; they never pull a broken face.
template <int D, class Softening>
KOKKOS_FUNCTION
Vec<D> Cohesive<D, Softening>::dashpots(const State& old, const State& next, double normal,
                                        double rate) const {
  const bool closed = shifted(next, next.jump[0], next.damage) <= 0;
  const double left = Softening::left(next.damage);
  const double share = closed ? 1 : secant(next, next.opening, next.damage) / springs.normal;
  Vec<D> t;
  t[0] = springs.normal_damping * share * (next.jump[0] - old.jump[0]) * rate;
  if (closed) t[0] = Kokkos::min(t[0], Kokkos::max(0.0, next.strength * left - normal));
  const Vec<D - 1> before = elastic_slip(old, old.jump), now = elastic_slip(next, next.jump);
  for (int i = 0; i < D - 1; ++i)
    t[i + 1] = springs.shear_damping * (closed ? 1 : left) * (now[i] - before[i]) * rate;
  return t;
}

template <int D, class Softening>
KOKKOS_FUNCTION
CohesiveResponse<D> Cohesive<D, Softening>::respond(const State& old, const Vec<D>& jump,
                                                    double rate) const {
  const Vec<D - 1> xi = elastic_slip(old, jump);
  const double length = norm(xi), elastic_trial = springs.shear * length;
  const Trial t = solve_damage(old, jump, elastic_trial);
  const double grown = t.wanted - old.damage;
  const double done = t.wanted > 1 && old.damage < 1 ? (1 - old.damage) / grown : 1;

  CohesiveResponse<D> r;
  r.next = old;
  r.next.jump = jump;
  r.next.opening = t.opening;
  r.next.damage = old.damage < 1 ? t.damage : 1.0;
  r.next.slip = old.slip + t.slipped;
  r.traction[0] = t.normal;
  for (int i = 0; i < D - 1; ++i) {
    const double direction = length > 0 ? xi[i] / length : 0;
    r.next.plastic[i] = old.plastic[i] + t.slipped * direction;
    r.traction[i + 1] = springs.shear * xi[i] - springs.shear * t.slipped * direction;
  }

  if (t.opening > old.opening || r.next.damage > old.damage)
    r.spent.tension = spent_in_opening(old, r.next, t.normal, done);
  if (t.slipped > 0) {
    const double before =
        normal_traction(old, shifted(old, old.jump[0], old.damage), old.opening, old.damage);
    const double cohesion =
        cohesive_traction(old, old.damage, before) + cohesive_traction(old, t.damage, t.normal);
    const double friction =
        friction_traction(old.damage, before) + friction_traction(t.damage, t.normal);
    r.spent.shear = 0.5 * cohesion * t.slipped * done;  // eq:cohesive-12  dW_II = S c ds
    r.spent.friction = 0.5 * friction * t.slipped;      // eq:cohesive-13  heat mu |T_n| ds
  }

  r.next.viscous = dashpots(old, r.next, t.normal, rate);
  for (int i = 0; i < D; ++i)
    r.spent.viscous += 0.5 * (old.viscous[i] + r.next.viscous[i]) * (jump[i] - old.jump[i]);
  r.traction += r.next.viscous;
  return r;
}

/// Where w stays below kap, or k_n w below the peak, and friction holds, eq:cohesive-9 leaves the
/// damage as it is: only jump, viscous traction and perhaps kap change. Values are those of
/// respond.
template <int D, class Softening>
template <class Spent>
KOKKOS_FORCEINLINE_FUNCTION
Vec<D> Cohesive<D, Softening>::advance(State& s, const Vec<D>& jump, double rate,
                                       Spent& spent) const {
  const double left = Softening::left(s.damage), peak = s.strength * left;
  const double w = shifted(s, jump[0], s.damage);
  const double opening = Kokkos::max(s.opening, w);
  const bool whole = springs.normal * opening <= peak;
  const double k = whole ? springs.normal : peak / opening;
  const bool closed = w <= 0;
  const double normal = (closed ? springs.normal : k) * w;
  const double pressed = Kokkos::max(0.0, -normal), pulled = Kokkos::max(0.0, normal);
  const double mu = strength.friction * left + strength.residual_friction * (1 - left);
  const double yield =
      left * Kokkos::max(0.0, s.cohesion - strength.friction * pulled) + mu * pressed;
  const Vec<D - 1> xi = elastic_slip(s, jump);
  const bool stands = (whole || opening == s.opening) && springs.shear * norm(xi) <= yield;
  if (!stands) {
    const CohesiveResponse<D> r = respond(s, jump, rate);
    s = r.next;
    spent.tension += r.spent.tension;
    spent.shear += r.spent.shear;
    spent.friction += r.spent.friction;
    spent.viscous += r.spent.viscous;
    return r.traction;
  }

  // eq:cohesive-11, see dashpots
  Vec<D> traction, viscous;
  viscous[0] =
      springs.normal_damping * (closed ? 1 : k / springs.normal) * (jump[0] - s.jump[0]) * rate;
  if (closed) viscous[0] = Kokkos::min(viscous[0], Kokkos::max(0.0, peak - normal));
  traction[0] = normal + viscous[0];
  const Vec<D - 1> before = elastic_slip(s, s.jump);
  for (int i = 0; i < D - 1; ++i) {
    viscous[i + 1] = springs.shear_damping * (closed ? 1 : left) * (xi[i] - before[i]) * rate;
    traction[i + 1] = springs.shear * xi[i] + viscous[i + 1];
  }
  double work = 0;
  for (int i = 0; i < D; ++i) work += 0.5 * (s.viscous[i] + viscous[i]) * (jump[i] - s.jump[i]);
  spent.viscous += work;
  s.opening = opening;
  s.jump = jump;
  s.viscous = viscous;
  return traction;
}

}  // namespace breccia
