#pragma once
#include "base/pack.hpp"

namespace breccia {

namespace series {
/// Terms that reach round-off: in double 9, in single precision 5.
template <class R>
inline constexpr int kTerms = kSingle<R> ? 5 : 9;

/// sum_k y^k / (2k + 1) up to k = kTerms - 1: atanh(sqrt y) / sqrt y with relative error below
/// 1e-16 (single: 2e-8) for 0 <= y <= kReach.
inline constexpr double kReach = 0.02;

template <class R>
KOKKOS_FORCEINLINE_FUNCTION
R atanh_over(const R& y) {
  R s = R(1.0 / (2 * kTerms<R> - 1));
  for (int k = kTerms<R> - 2; k >= 0; --k) s = s * y + R(1.0 / (2 * k + 1));
  return s;
}

/// Its derivative, sum_k k y^(k-1) / (2k + 1).
template <class R>
KOKKOS_FORCEINLINE_FUNCTION
R atanh_slope(const R& y) {
  R s = R(double(kTerms<R>) / (2 * kTerms<R> + 1));
  for (int k = kTerms<R> - 1; k >= 1; --k) s = s * y + R(double(k) / (2 * k + 1));
  return s;
}
}  // namespace series

/// atanh(q) / q as a function of y = q^2, 0 <= y < 1: a series near zero, the library function
/// beyond its reach, in the lanes that are (rare: stretches above 1.3).
template <class R>
KOKKOS_FORCEINLINE_FUNCTION
R atanh_ratio(const R& y) {
  const R near = series::atanh_over(y);
  if (!any(!(y <= R(series::kReach)))) return near;
  return mended(near, y, series::kReach, y, [](double yi) {
    const double q = Kokkos::sqrt(yi);
    return Kokkos::atanh(q) / q;
  });
}

/// Derivative of atanh_ratio: (1 / (1 - y) - atanh_ratio(y)) / (2 y), as a series near zero.
template <class R>
KOKKOS_FORCEINLINE_FUNCTION
R atanh_ratio_slope(const R& y) {
  const R near = series::atanh_slope(y);
  if (!any(!(y <= R(series::kReach)))) return near;
  return mended(near, y, series::kReach, y, [](double yi) {
    const double q = Kokkos::sqrt(yi);
    return 0.5 * (1 / (1 - yi) - Kokkos::atanh(q) / q) / yi;
  });
}

/// ln(j), quick for j near one (0.75 < j < 1.33), exact to round-off everywhere.
template <class R>
KOKKOS_FORCEINLINE_FUNCTION
R log_near_one(const R& j) {
  const R z = (j - R(1)) / (j + R(1));
  const R y = z * z;
  const R near = R(2) * z * series::atanh_over(y);
  if (!any(!(y <= R(series::kReach)))) return near;
  return mended(near, y, series::kReach, j, [](double ji) { return Kokkos::log(ji); });
}

/// ln(1 + z), exact to round-off of z itself where z is small.
template <class R>
KOKKOS_FORCEINLINE_FUNCTION
R log_of_one_plus(const R& z) {
  const R w = z / (z + R(2));
  const R y = w * w;
  const R near = R(2) * w * series::atanh_over(y);
  if (!any(!(y <= R(series::kReach)))) return near;
  return mended(near, y, series::kReach, z, [](double zi) { return Kokkos::log1p(zi); });
}

}  // namespace breccia
