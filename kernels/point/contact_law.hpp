#pragma once
#include "base/vec.hpp"
#include "point/friction_law.hpp"

namespace breccia {

/// What a law of friction other than Coulomb's knows of the past.
struct Rubbed {
  double slip = 0;   ///< s so far, m
  double rate = 0;   ///< V, m/s
  double theta = 0;  ///< s; 0: as the law begins
};

/// Memory of one contact point against one piece of material.
template <int D>
struct ContactState {
  double phi = 0;                   ///< depth that the force was made with, m
  double offset = 0;                ///< what is left of a jump of the potential, m
  double stored = 0;                ///< J
  Vec<D> slip = Vec<D>::zero();     ///< elastic slip, m
  Vec<D> force = Vec<D>::zero();    ///< on the contactor, N
  Vec<D> viscous = Vec<D>::zero();  ///< its viscous part, N
  Rubbed rubbed;
};

/// Stiffnesses and dashpots of the point: per area times the area that it stands for.
struct ContactParameters {
  double normal = 0;                 ///< k, N/m
  double tangential = 0;             ///< k_t, N/m
  double damping = 0;                ///< c, N s/m
  double tangential_damping = 0;     ///< c_t, N s/m
  double friction = 0;               ///< mu at rest, 1
  const FrictionLaw* law = nullptr;  ///< none: Coulomb's, which is mu alone
};

/// Motion of the point relative to the target since the last step.
template <int D>
struct ContactMotion {
  double phi;       ///< depth now, m
  Vec<D> normal;    ///< of the target, outwards
  double slope;     ///< by how much phi grows per way against the normal, about 1
  Vec<D> velocity;  ///< of the point relative to the target at t^(n-1/2), m/s
  double dt;        ///< length of the last step, s
  double keep;      ///< share of a jump of the potential that is left after this step
  bool jumped;      ///< the potential has been computed anew since the last step
};

template <int D>
struct ContactResponse {
  ContactState<D> next;
  double friction = 0, viscous = 0, numeric = 0;  ///< J lost since the last step
};

/// A jump of the potential fades where that gives energy away. One that would push the point out
/// stays and shrinks only as the point leaves by itself: an overlap that was there before the
/// contact is never made into energy.
KOKKOS_INLINE_FUNCTION
double kept_offset(double offset, double phi, double keep) {
  if (offset >= 0) return offset * keep;
  return phi + offset < 0 ? -phi : offset;
}

/// How far the spring of friction may be stretched, as a force, N.
struct Grip {
  double cap;
  bool sticks;
};

/// Grip on a spring that would bear `size` if nothing slid: eq:friction-1 to 7.
KOKKOS_INLINE_FUNCTION
Grip grip_of(const FrictionLaw& law, double size, double pressing, double stiffness, double dt,
             Rubbed& rubbed) {
  if (!(rubbed.theta > 0)) rubbed.theta = law.state;
  const Slide before{0, rubbed.rate, rubbed.theta};
  const Slide now = slide_of(law, size, pressing, stiffness, dt, rubbed.slip, before);
  rubbed = {rubbed.slip + now.slipped, now.rate, now.theta};
  if (!(pressing > 0)) return {0, size <= 0};
  if (now.slipped > 0) return {Kokkos::max(0.0, size - stiffness * now.slipped), false};
  const double cap = pressing * law.coefficient(rubbed.slip, now.rate, now.theta);
  return {Kokkos::max(size, cap), true};
}

/// Force of a contact point (ALGORITHMS ).
///
// symbols  phi [m] depth  n [1] outward normal of the target  e [m] elastic slip
//          v [m/s] velocity of the point relative to the target  k, k_t [N/m]  c, c_t [N s/m]
//          g [1] slope of phi
// eq:contact-1   F_n = g max(0, k phi - c g v.n)                 never tensile
// eq:contact-2   e* = e turned into the tangent plane + v_t dt
// eq:contact-3   e = e* while k_t |e*| <= mu F_n (sticks), else mu F_n / k_t along e* (slips); the
//                slip |e* - e| of a step and mu go together by eq:friction-7
// eq:contact-4   F_t = k_t e, and + c_t v_t up to mu F_n while it sticks
// eq:contact-5   F = F_n n - F_t on the contactor
// Energies of a step are exact for the trapezoidal work W = (F_old + F)/2 . v dt, which is what
// the leapfrog books: stored k phi^2/2 + k_t e^2/2; friction k_t (e_old + e)/2 . (e* - e);
// viscous -(V_old + V)/2 . v dt; what remains is numeric: curvature of the path, smooth direction,
// jumps of the potential.
template <int D>
KOKKOS_FUNCTION
ContactResponse<D> contact_response(const ContactParameters& p, const ContactState<D>& old,
                                    const ContactMotion<D>& motion) {
  const Vec<D>& n = motion.normal;
  const double closing = -dot(motion.velocity, n), rate = motion.slope * closing;
  ContactResponse<D> r;
  ContactState<D>& s = r.next;
  s.offset = motion.jumped ? old.phi + rate * motion.dt - motion.phi
                           : kept_offset(old.offset, motion.phi, motion.keep);
  s.phi = motion.phi + s.offset;
  if (!(s.phi > 0)) s.phi = 0;
  const double elastic = p.normal * s.phi;
  const double damped = elastic + p.damping * rate;
  const double pressing = s.phi > 0 && damped > 0 ? motion.slope * damped : 0;  // eq:contact-1

  Vec<D> dragging = Vec<D>::zero(), sticking = Vec<D>::zero();
  if (p.friction > 0) {
    const Vec<D> v_t = motion.velocity + n * closing;
    Vec<D> e = old.slip - n * dot(old.slip, n);
    const double length2 = norm2(e);
    if (length2 > 0) e *= Kokkos::sqrt(norm2(old.slip) / length2);
    const Vec<D> before = e;
    e += v_t * motion.dt;  // eq:contact-2
    const double size = p.tangential * norm(e);
    Grip grip{p.friction * pressing, size <= p.friction * pressing};
    if (p.law != nullptr) {
      s.rubbed = old.rubbed;
      grip = grip_of(*p.law, size, pressing, p.tangential, motion.dt, s.rubbed);
    }
    s.slip = grip.sticks ? e : e * (grip.cap / size);  // eq:contact-3
    dragging = s.slip * p.tangential;
    if (grip.sticks) {  // eq:contact-4
      dragging += v_t * p.tangential_damping;
      const double most = norm(dragging);
      if (most > grip.cap) dragging *= grip.cap / most;
      sticking = dragging - s.slip * p.tangential;
    }
    r.friction = 0.5 * p.tangential * dot(before + s.slip, e - s.slip);
  }
  s.force = n * pressing - dragging;  // eq:contact-5
  s.viscous = n * (pressing - motion.slope * elastic) - sticking;
  s.stored = 0.5 * (elastic * s.phi + p.tangential * norm2(s.slip));
  const Vec<D> way = motion.velocity * motion.dt;
  r.viscous = -0.5 * dot(old.viscous + s.viscous, way);
  r.numeric =
      -0.5 * dot(old.force + s.force, way) - (s.stored - old.stored) - r.friction - r.viscous;
  return r;
}

/// The point has left the target: its energy is given back by the last half step of its force.
template <int D>
KOKKOS_FUNCTION
ContactResponse<D> contact_ended(const ContactState<D>& old, const Vec<D>& way) {
  ContactResponse<D> r;
  r.viscous = -0.5 * dot(old.viscous, way);
  r.numeric = -0.5 * dot(old.force, way) + old.stored - r.viscous;
  return r;
}

}  // namespace breccia
