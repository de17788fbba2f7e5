#pragma once
#include "point/inelastic.hpp"

namespace breccia {

/// Cohesion that moves along a line from its first value to its last one.
///
// eq:plastic-8  c = first + (last - first) min(1, ep / strain)
struct Cohesion {
  double first = 0, last = 0;  ///< Pa
  double strain = 0;           ///< plastic strain at which the last value is reached; 0: constant

  template <class R>
  KOKKOS_INLINE_FUNCTION
  R at(const R& ep) const {
    if (!(strain > 0)) return R(first);
    return R(first) + R(last - first) * minimum(R(1), ep * R(1 / strain));
  }
  KOKKOS_INLINE_FUNCTION
  double slope(double ep) const { return strain > 0 && ep < strain ? (last - first) / strain : 0; }
};

/// Drucker and Prager's cone with tension cut-off and non-associated flow (ALGORITHMS A-1.7b).
///
// symbols  r = sqrt(J2) [Pa]   sm [Pa] mean stress, tension > 0   A, Abar [1] slope of the cone and
//          of the plastic potential   B = k c(ep) [Pa]   sT [Pa] tension cut-off   dg [1]
//          ep [1] = sum of sqrt(2/3 dep : dep)
// eq:plastic-9   f = r + A sm - B <= 0, sm <= min(sT, B / A)
// eq:plastic-10  dg = f / (G + K A Abar + dB/dg), r -= G dg, sm -= K Abar dg
// eq:plastic-11  past the corner with the cut-off or the apex: sm = sT, r = min(r, B - A sT)
// source   Drucker and Prager 1952; de Souza Neto, Peric, Owen, Computational Methods for
//          Plasticity (2008), chapter 8
struct DruckerPrager {
  static constexpr bool kRadial = true;
  static constexpr int kHistory = 1;
  static constexpr std::array<HistoryEntry, 1> kHistoryEntries{kPlasticStrain};
  double bulk = 0, shear = 0;  ///< Pa
  double friction = 0;         ///< A, 1
  double dilation = 0;         ///< Abar, 1; not above A
  double per_cohesion = 0;     ///< k = B / c, 1
  Cohesion cohesion;
  double cut_off = 1e300;      ///< sT, Pa
  double strength_factor = 1;  ///< on c and sT, by the rate of strain

  enum class Fit { compression, extension, plane_strain };

  /// A / sin(phi) or B / (c cos(phi)) of the cone that meets Mohr and Coulomb's pyramid at its
  /// outer edges, its inner ones, or in plane strain (eq:plastic-12, page).
  KOKKOS_INLINE_FUNCTION
  static double fit(Fit fit, double angle) {
    const double sine = Kokkos::sin(angle), tangent = Kokkos::tan(angle);
    switch (fit) {
      case Fit::compression:
        return 6 / (1.7320508075688773 * (3 - sine));
      case Fit::extension:
        return 6 / (1.7320508075688773 * (3 + sine));
      case Fit::plane_strain:
        return 3 / (Kokkos::cos(angle) * Kokkos::sqrt(9 + 12 * tangent * tangent));
    }
    return 0;
  }
  /// The cone of a cohesion and an angle of friction, with its potential for an angle of dilation.
  KOKKOS_INLINE_FUNCTION
  static DruckerPrager fitted(Fit by, double phi, double psi) {
    DruckerPrager law;
    law.friction = fit(by, phi) * Kokkos::sin(phi);
    law.dilation = fit(by, psi) * Kokkos::sin(psi);
    law.per_cohesion = fit(by, phi) * Kokkos::cos(phi);
    return law;
  }

  /// Largest stress in simple tension, Pa, before any plastic strain.
  KOKKOS_INLINE_FUNCTION
  double uniaxial_tension() const {
    const double b = strength(0.0);
    return minimum(b / (0.5773502691896258 + friction / 3), 3 * tension_limit(b));
  }

  /// B at a plastic strain.
  template <class R>
  KOKKOS_INLINE_FUNCTION
  R strength(const R& ep) const { return R(per_cohesion * strength_factor) * cohesion.at(ep); }
  KOKKOS_INLINE_FUNCTION
  double tension_limit(double b) const {
    const double cut = cut_off * strength_factor;
    return friction > 0 && b < friction * cut ? b / friction : cut;
  }
  /// ep per dg on the cone.
  KOKKOS_INLINE_FUNCTION
  double strain_per_step() const { return Kokkos::sqrt(1.0 / 3 + 2 * dilation * dilation / 9); }

  template <class R>
  KOKKOS_FUNCTION
  R beyond(const R& mean, const R& root_j2, const R* history) const {
    // The apex lies on the cone: the cut-off alone matters besides it.
    return maximum(root_j2 + R(friction) * mean - strength(history[0]),
                   mean - R(cut_off * strength_factor));
  }

  KOKKOS_FUNCTION
  double update(double (&strain)[3], double (&history)[kMaxHistory], double /*dt*/) const {
    const PrincipalStress trial = PrincipalStress::of(strain, bulk, shear);
    const double r0 = trial.root_j2(), sm0 = trial.mean(), ep = history[0];
    const double b0 = strength(ep), f = r0 + friction * sm0 - b0;
    if (!(f > 0) && !(sm0 > tension_limit(b0))) return 0;
    double b = b0, dg = 0;
    if (f > 0) dg = cone_step(f, ep, b);
    double r = r0 - shear * dg, sm = sm0 - bulk * dilation * dg;
    double work = dg * (r + dilation * sm + 0.5 * (b0 - b));
    double grown = strain_per_step() * dg;
    if (r < 0 || sm > tension_limit(b)) {
      // The first pass tells how far the plastic strain goes, the second one is exact for it.
      b = b0;
      for (int pass = 0; pass < 2; ++pass) {
        sm = minimum(sm0, tension_limit(b));  // eq:plastic-11
        r = minimum(r0, maximum(0.0, b - friction * sm));
        const double dr = (r0 - r) / shear, dv = (sm0 - sm) / bulk;
        work = r * dr + sm * dv;
        if (pass == 0) grown = Kokkos::sqrt((dr * dr + 2 * dv * dv / 3) / 3);
        b = strength(ep + grown);
      }
    }
    set_invariants(strain, r0 > 0 ? r / r0 : 1, sm / bulk);
    history[0] += grown;
    return work > 0 ? work : 0;
  }

 private:
  /// dg of eq:plastic-10; b becomes the strength after it.
  KOKKOS_INLINE_FUNCTION
  double cone_step(double f, double ep, double& b) const {
    const double stiff = shear + bulk * friction * dilation, m = strain_per_step();
    const double k = per_cohesion * strength_factor, slope = k * cohesion.slope(ep) * m;
    double dg = f / (stiff + slope);
    if (slope != 0 && !(stiff + slope > 0 && ep + m * dg <= cohesion.strain)) {
      dg = (f + b - k * cohesion.last) / stiff;  // goes beyond the end of the line
    }
    b = strength(ep + m * dg);
    return dg;
  }
};
static_assert(InelasticLaw<DruckerPrager>);

}  // namespace breccia
