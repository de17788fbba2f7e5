#pragma once
#include "point/hencky.hpp"

namespace breccia {

/// Scalar seismic moment per area of a face that opens and slides.
///
// symbols  o, s [m] opening, slip   n, t [1] normal, direction of the slip   u = o n + s t
//          lambda, mu [Pa] Lame constants   m_ij [N/m] moment tensor per area
// equation m_ij = lambda u.n delta_ij + mu (u_i n_j + n_i u_j), M_0 = sqrt(m_ij m_ij / 2)
// source   Aki and Richards, Quantitative Seismology; Silver and Jordan 1982,
//          doi:10.1111/j.1365-246X.1982.tb02576.x; mu s for pure slip
// page     docs/modules/fracture.md
KOKKOS_INLINE_FUNCTION
double moment_per_area(const HenckyElastic& law, double opening, double slip) {
  const double normal = law.lambda * opening, shear = law.mu * opening;
  // m : m = 3 l^2 o^2 + 4 l mu o^2 + 2 mu^2 (2 o^2 + s^2), l = lambda
  const double squares = 3 * normal * normal + 4 * normal * shear + 4 * shear * shear +
                         2 * law.mu * law.mu * slip * slip;
  return Kokkos::sqrt(0.5 * squares);
}

}  // namespace breccia
