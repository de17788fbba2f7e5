#pragma once
#include "point/cohesive.hpp"

namespace breccia {

/// What the springs of a face are made of, on one of its sides.
struct InterfaceSide {
  double p_wave_modulus, shear_modulus;  ///< M, G, Pa
  double density;                        ///< kg/m3
};

/// Springs and dashpots of a face, per area.
///
// symbols  kf [1] stiffness factor   h_f [m] = (V_L + V_R) / (2 A), about half an element's height
//          M, G [Pa] harmonic means of both sides   m_A [kg/m2] mass per area, rho h_f / 2,
//          with the harmonic mean of both: one made for the heavier side would throw the lighter
//          xi [1] share of critical damping
// source   ALGORITHMS
// page     docs/modules/fracture.md
KOKKOS_INLINE_FUNCTION
CohesiveSprings springs_of(const InterfaceSide& left, const InterfaceSide& right, double height,
                           double stiffness_factor, double damping) {
  const auto harmonic = [](double a, double b) { return 2 * a * b / (a + b); };
  CohesiveSprings k;
  // eq:cohesive-20  k_n = kf M / h_f, k_s = kf G / h_f
  k.normal = stiffness_factor * harmonic(left.p_wave_modulus, right.p_wave_modulus) / height;
  k.shear = stiffness_factor * harmonic(left.shear_modulus, right.shear_modulus) / height;
  // eq:cohesive-21  c = 2 xi sqrt(k m_A)
  const double density =
      left.density == right.density ? left.density : harmonic(left.density, right.density);
  const double mass = 0.5 * density * height;
  k.normal_damping = 2 * damping * Kokkos::sqrt(k.normal * mass);
  k.shear_damping = 2 * damping * Kokkos::sqrt(k.shear * mass);
  return k;
}

}  // namespace breccia
