#pragma once
#include "base/mat.hpp"

namespace breccia {

/// Resistance of a surface that lets plane waves out: traction = -rho c_p v_n n - rho c_s v_t.
///
// symbols  n [1] unit normal   area [m2]   z_p, z_s [kg/(m2 s)] impedances rho c_p, rho c_s
//          C [kg/s] force = -C v
// source   ALGORITHMS A-8.5 (Lysmer and Kuhlemeyer 1969)
template <int D>
KOKKOS_INLINE_FUNCTION
Sym<D> absorbing_matrix(const Vec<D>& n, double area, double z_p, double z_s) {
  Sym<D> c;
  for (int i = 0; i < D; ++i)
    for (int j = i; j < D; ++j)
      c(i, j) = area * ((z_p - z_s) * n[i] * n[j] + (i == j ? z_s : 0.0));  // eq:boundary-1
  return c;
}

/// Velocity after a kick h of the force f on mass m with the resistance taken at its middle, which
/// is stable for any C: (m + h C / 2) v_new = (m - h C / 2) v + h f. Components whose bit is set in
/// `held` come out as they stand in `v_new`.
template <int D>
KOKKOS_INLINE_FUNCTION
void absorbing_kick(double m, double h, const Sym<D>& c, const Vec<D>& v, const Vec<D>& f,
                    unsigned held, Vec<D>& v_new) {
  Mat<D> a;
  Vec<D> b;
  const Vec<D> cv = c * v;
  for (int i = 0; i < D; ++i) {
    const bool fixed = (held & (1u << i)) != 0;
    b[i] = fixed ? v_new[i] : m * v[i] + h * (f[i] - 0.5 * cv[i]);  // eq:boundary-2
    for (int j = 0; j < D; ++j) {
      a(i, j) = i == j ? 1.0 : 0.0;
      if (!fixed) a(i, j) = (i == j ? m : 0.0) + 0.5 * h * c(i, j);
    }
  }
  v_new = inverse(a) * b;
}

}  // namespace breccia
