#pragma once
#include "base/mat.hpp"
#include "base/series.hpp"
#include "point/full_sym.hpp"
#include "point/principal.hpp"

namespace breccia {

/// Isotropic hyperelasticity in logarithmic strain.
///
// symbols  F [1] deformation gradient   J = det F   B = F F^T   V = sqrt(B) left stretch
//          eps = ln V [1] Hencky strain   tau = J sigma [Pa] Kirchhoff stress
//          lambda, mu [Pa] Lame constants (lambda of plane stress in that case)
//          w [Pa] strain energy per reference volume
// source   ALGORITHMS in spatial axes, which isotropy allows; Hencky 1928. The law is
//          exactly hyperelastic: tau = dw/d(eps).
// page     docs/modules/solid.md

/// eq:solid-1  ln V in the plane: V = (B + J 1) / sqrt(tr B + 2 J), then with m = tr V / 2 and q
/// the ratio of the deviator's radius to m, ln V = ln(J)/2 1 + (atanh q / q) dev V / m.
template <class R>
KOKKOS_FUNCTION
Sym<2, R> hencky_strain(const Sym<2, R>& b, const R& jacobian) {
  const R two_m = square_root(b.s[0] + b.s[1] + R(2) * jacobian);
  const R four_over = R(1) / (two_m * two_m);
  const R half = R(0.5) * (b.s[0] - b.s[1]);
  const R radius2 = half * half + b.s[2] * b.s[2];  // (2 m r)^2
  const R q2 = R(4) * radius2 * four_over * four_over;
  const R scale = R(2) * atanh_ratio(q2) * four_over;
  const R mean = R(0.5) * log_near_one(jacobian);
  return {{mean + scale * half, mean - scale * half, scale * b.s[2]}};
}

/// The same from E = B - 1 and J - 1, which may be known better than B and J.
template <class R>
KOKKOS_FUNCTION
Sym<2, R> hencky_strain_of_growth(const Sym<2, R>& e, const R& dilation) {
  const R four_over = R(1) / (R(4) + (e.s[0] + e.s[1] + R(2) * dilation));
  const R half = R(0.5) * (e.s[0] - e.s[1]);
  const R radius2 = half * half + e.s[2] * e.s[2];
  const R scale = R(2) * atanh_ratio(R(4) * radius2 * four_over * four_over) * four_over;
  const R mean = R(0.5) * log_of_one_plus(dilation);
  return {{mean + scale * half, mean - scale * half, scale * e.s[2]}};
}

namespace hencky {
/// Series terms in space and the largest |X|^2 that they reach with round-off accuracy.
template <class R>
inline constexpr int kTerms = kSingle<R> ? 7 : 14;
inline constexpr double kReach = 0.08;

/// (a + 1)^-1.
template <class R>
KOKKOS_FORCEINLINE_FUNCTION
Sym<3, R> inverse_of_one_plus(const Sym<3, R>& b) {
  Mat<3, R> a;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) a(i, j) = i == j ? b(i, j) + R(1) : b(i, j);
  const Mat<3, R> c = cofactor(a);
  const R over = R(1) / (a(0, 0) * c(0, 0) + a(0, 1) * c(0, 1) + a(0, 2) * c(0, 2));
  Sym<3, R> x;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) x(i, j) = over * c(i, j);
  return x;
}

/// ln V = (ln B) / 2 by eigenvalues, for stretches beyond the series.
KOKKOS_FUNCTION
Sym<3> by_eigenvalues(const Sym<3>& b);

/// Z with ln V = X Z, Z = sum_k Y^k / (2k + 1), Y = X^2, summed by Horner's rule in the basis
/// {1, Y, Y^2} with the Cayley-Hamilton theorem.
template <class R>
KOKKOS_FUNCTION
Sym<3, R> series_factor(const Sym<3, R>& y) {
  const Sym<3, R> y2 = commuting_product(y, y);
  const R i1 = trace(y);
  const R i2 = R(0.5) * (i1 * i1 - trace(y2));
  const R i3 = y.s[0] * (y.s[1] * y.s[2] - y.s[3] * y.s[3]) -
               y.s[5] * (y.s[5] * y.s[2] - y.s[3] * y.s[4]) +
               y.s[4] * (y.s[5] * y.s[3] - y.s[1] * y.s[4]);
  R a = R(1.0 / (2 * kTerms<R> - 1)), b = R(0), c = R(0);
  for (int k = kTerms<R> - 2; k >= 0; --k) {
    const R next_a = c * i3 + R(1.0 / (2 * k + 1));
    const R next_b = a - c * i2;
    c = b + c * i1;
    a = next_a;
    b = next_b;
  }
  Sym<3, R> z;
  for (int i = 0; i < 6; ++i) z.s[i] = b * y.s[i] + c * y2.s[i] + (i < 3 ? a : R(0));
  return z;
}
}  // namespace hencky

namespace hencky {
/// atanh X = ln V; by the eigenvalues of B in lanes that the series does not reach.
template <class R>
KOKKOS_FORCEINLINE_FUNCTION
Sym<3, R> strain_of(const Sym<3, R>& x, const Sym<3, R>& b) {
  const Sym<3, R> y = commuting_product(x, x);
  Sym<3, R> eps = commuting_product(x, series_factor(y));
  const R size = trace(y);
  if (any(!(size <= R(kReach)))) {
    double lanes_of_b[6][lanes<R>()], lanes_of_eps[6][lanes<R>()], sizes[lanes<R>()];
    store(size, sizes);
    for (int i = 0; i < 6; ++i) store(b.s[i], lanes_of_b[i]);
    for (int i = 0; i < 6; ++i) store(eps.s[i], lanes_of_eps[i]);
    for (int l = 0; l < lanes<R>(); ++l) {
      if (sizes[l] <= static_cast<Lane<R>>(kReach)) continue;
      Sym<3> one;
      for (int i = 0; i < 6; ++i) one.s[i] = lanes_of_b[i][l];
      one = by_eigenvalues(one);
      for (int i = 0; i < 6; ++i) lanes_of_eps[i][l] = one.s[i];
    }
    for (int i = 0; i < 6; ++i) eps.s[i] = load<R>(lanes_of_eps[i]);
  }
  return eps;
}
}  // namespace hencky

/// eq:solid-2  ln V in space: X = (B - 1)(B + 1)^-1 = tanh(ln V), so ln V = atanh X.
template <class R>
KOKKOS_FUNCTION
Sym<3, R> hencky_strain(const Sym<3, R>& b, const R& /*jacobian*/) {
  Sym<3, R> x = hencky::inverse_of_one_plus(b) * R(-2);
  for (int i = 0; i < 3; ++i) x.s[i] = x.s[i] + R(1);
  return hencky::strain_of(x, b);
}

/// The same from E = B - 1.
template <class R>
KOKKOS_FUNCTION
Sym<3, R> hencky_strain_of_growth(const Sym<3, R>& e, const R& /*dilation*/) {
  Sym<3, R> b = e;
  for (int i = 0; i < 3; ++i) b.s[i] = b.s[i] + R(1);
  return hencky::strain_of(commuting_product(e, hencky::inverse_of_one_plus(b)), b);
}

struct HenckyElastic {
  double lambda = 0, mu = 0;

  /// eq:solid-3  tau = lambda tr(eps) 1 + 2 mu eps
  template <int D, class R>
  KOKKOS_FUNCTION
  Sym<D, R> kirchhoff(const Sym<D, R>& eps) const {
    const R p = R(lambda) * trace(eps);
    Sym<D, R> tau = eps * R(2 * mu);
    for (int i = 0; i < D; ++i) tau.s[i] = tau.s[i] + p;
    return tau;
  }

  /// eq:solid-4  w = lambda tr(eps)^2 / 2 + mu eps : eps
  template <int D, class R>
  KOKKOS_FUNCTION
  R energy(const Sym<D, R>& eps) const {
    const R t = trace(eps);
    return R(0.5 * lambda) * t * t + R(mu) * contract(eps, eps);
  }
};

/// eq:solid-3 for a tensor of space. `flat`: plane stress, with lambda of plane stress.
template <int D, class R>
KOKKOS_FORCEINLINE_FUNCTION
FullSym<D, R> isotropic(const HenckyElastic& law, const FullSym<D, R>& eps, bool flat) {
  const R p = R(law.lambda) * (flat ? trace(eps.in) : trace(eps));
  FullSym<D, R> tau = eps * R(2 * law.mu);
  tau.add_identity(p);
  if (flat) tau.zz = R(0);
  return tau;
}

namespace hencky {
KOKKOS_INLINE_FUNCTION
Sym<3> by_eigenvalues(const Sym<3>& b) {
  Principal<3> p = principal_of(b);
  for (double& value : p.value) value = 0.5 * Kokkos::log(value);
  return p.with(p.value);
}
}  // namespace hencky

}  // namespace breccia
