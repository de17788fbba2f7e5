#pragma once
#include "point/hencky.hpp"

namespace breccia {

/// From the stress that is conjugate to the logarithmic strain to the second Piola-Kirchhoff
/// stress, without an eigenvalue problem where strains are small.
///
// symbols  C = F^T F   J = det F   eps = ln(C) / 2   t [Pa] any symmetric tensor, conjugate to eps
//          S = 2 t : d(eps)/dC [Pa], so that t : d(eps)/dt = tau : d with tau = F S F^T
// source   derivative of eq:solid-1 and eq:solid-2; Daleckii and Krein 1965 for the exact form by
//          eigenvalues. With isotropic t(eps) this is S = F^-1 t F^-T.
// page     docs/modules/solid.md
//
// eq:solid-11 in the plane, with m = 1 / (tr C + 2 J), D = dev C, A(y) = atanh(sqrt y) / sqrt y,
//             y = 2 (D : D) m^2 and eps = ln(J)/2 1 + 2 m A D:
//             S = tr(t)/2 C^-1 + 4 m A dev t
//                 + 2 (t : D) [ 8 m^3 A' D - m^2 (8 m^2 (D : D) A' + 2 A) (1 + J C^-1) ]
template <class R>
KOKKOS_FUNCTION
Sym<2, R> second_piola(const Sym<2, R>& t, const Sym<2, R>& c, const R& jacobian) {
  const R m = R(1) / (c.s[0] + c.s[1] + R(2) * jacobian);
  const R half = R(0.5) * (c.s[0] - c.s[1]);
  const Sym<2, R> d = {{half, -half, c.s[2]}};
  const R dd = contract(d, d);
  const R y = R(2) * dd * m * m;
  const R a = atanh_ratio(y), slope = atanh_ratio_slope(y);
  const R over = R(1) / (jacobian * jacobian);
  const Sym<2, R> inverse = {{c.s[1] * over, c.s[0] * over, -c.s[2] * over}};
  const R mean = R(0.5) * (t.s[0] + t.s[1]);
  const Sym<2, R> deviator = {{t.s[0] - mean, t.s[1] - mean, t.s[2]}};
  const R td = contract(t, d);
  const R along = R(16) * td * m * m * m * slope;
  const R back = R(2) * td * m * m * (R(8) * m * m * dd * slope + R(2) * a);
  Sym<2, R> s = inverse * (mean - back * jacobian);
  s += deviator * (R(4) * m * a);
  s += d * along;
  for (int i = 0; i < 2; ++i) s.s[i] = s.s[i] - back;
  return s;
}

namespace hencky {

/// a b a for symmetric matrices.
template <class R>
KOKKOS_FORCEINLINE_FUNCTION
Sym<3, R> sandwich(const Sym<3, R>& a, const Sym<3, R>& b) {
  Mat<3, R> ab;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      ab(i, j) = a(i, 0) * b(0, j) + a(i, 1) * b(1, j) + a(i, 2) * b(2, j);
  Sym<3, R> r;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j)
      r(i, j) = ab(i, 0) * a(0, j) + ab(i, 1) * a(1, j) + ab(i, 2) * a(2, j);
  return r;
}

/// a b + b a for symmetric matrices.
template <class R>
KOKKOS_FORCEINLINE_FUNCTION
Sym<3, R> both_ways(const Sym<3, R>& a, const Sym<3, R>& b) {
  Sym<3, R> r;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) {
      R s = a(i, 0) * b(0, j) + b(i, 0) * a(0, j);
      for (int k = 1; k < 3; ++k) s = s + a(i, k) * b(k, j) + b(i, k) * a(k, j);
      r(i, j) = s;
    }
  return r;
}

/// Largest |X|^2 for which the terms up to X^2 and up to X^4 reach round-off.
inline constexpr double kReachTwo = 1e-8, kReachFour = 2e-5;

/// eq:solid-12 in space, for one point: in the axes of C, S_ij = 2 t_ij theta_ij, theta_ij the
/// divided difference of (ln l)/2 between the eigenvalues l_i and l_j of C.
KOKKOS_INLINE_FUNCTION
Sym<3> second_piola_by_eigenvalues(const Sym<3>& t, const Sym<3>& c) {
  const Principal<3> p = principal_of(c);
  Mat<3> full;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) full(i, j) = t(i, j);
  Mat<3> turned = transpose(p.axes) * full * p.axes;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const double sum = p.value[i] + p.value[j], z = (p.value[i] - p.value[j]) / sum;
      turned(i, j) *= 2 * atanh_ratio(z * z) / sum;
    }
  return symmetric_part(p.axes * turned * transpose(p.axes));
}

}  // namespace hencky

/// eq:solid-13 in space, with X = (C - 1)(C + 1)^-1 and eps = atanh X:
///   S = 4 (C + 1)^-1 [ t + (Y t + X t X + t Y)/3 + ... ] (C + 1)^-1,  Y = X^2,
/// the bracket being the derivative of the series, term by term.
template <class R>
KOKKOS_FUNCTION
Sym<3, R> second_piola(const Sym<3, R>& t, const Sym<3, R>& c, const R& /*jacobian*/) {
  const Sym<3, R> inverse = hencky::inverse_of_one_plus(c);
  Sym<3, R> x = inverse * R(-2);
  for (int i = 0; i < 3; ++i) x.s[i] = x.s[i] + R(1);
  const Sym<3, R> y = commuting_product(x, x);
  const R size = trace(y);
  Sym<3, R> sum = t;
  const Sym<3, R> yt = hencky::both_ways(y, t);
  sum += (yt + hencky::sandwich(x, t)) * R(1.0 / 3);
  if (any(R(hencky::kReachTwo) < size)) {
    Sym<3, R> four = hencky::both_ways(commuting_product(y, y), t);
    four += hencky::sandwich(x, yt);
    four += hencky::sandwich(y, t);
    double sizes[lanes<R>()];
    store(size, sizes);
    // Lanes that do not need the terms go without them, whatever their neighbours need.
    const R weight = fill<R>(
        [&](int l) { return static_cast<Lane<R>>(hencky::kReachTwo) < sizes[l] ? 0.2 : 0.0; });
    sum += four * weight;
  }
  Sym<3, R> s = hencky::sandwich(inverse, sum) * R(4);
  if (any(!(size <= R(hencky::kReachFour)))) {
    double lanes_of_t[6][lanes<R>()], lanes_of_c[6][lanes<R>()], lanes_of_s[6][lanes<R>()];
    double sizes[lanes<R>()];
    store(size, sizes);
    for (int i = 0; i < 6; ++i) store(t.s[i], lanes_of_t[i]);
    for (int i = 0; i < 6; ++i) store(c.s[i], lanes_of_c[i]);
    for (int i = 0; i < 6; ++i) store(s.s[i], lanes_of_s[i]);
    for (int l = 0; l < lanes<R>(); ++l) {
      if (sizes[l] <= static_cast<Lane<R>>(hencky::kReachFour)) continue;
      Sym<3> one, metric;
      for (int i = 0; i < 6; ++i) one.s[i] = lanes_of_t[i][l];
      for (int i = 0; i < 6; ++i) metric.s[i] = lanes_of_c[i][l];
      one = hencky::second_piola_by_eigenvalues(one, metric);
      for (int i = 0; i < 6; ++i) lanes_of_s[i][l] = one.s[i];
    }
    for (int i = 0; i < 6; ++i) s.s[i] = load<R>(lanes_of_s[i]);
  }
  return s;
}

}  // namespace breccia
