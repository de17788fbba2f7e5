#pragma once
#include "base/exec.hpp"

#include <Kokkos_Core.hpp>
#include <Kokkos_SIMD.hpp>

#include <type_traits>

namespace breccia {

/// What a loop body computes with: a SIMD register of doubles on the host, one double on a
/// device. Laws are templates over it and are written once.
///
/// Packs are compared with < and <= only: up to Kokkos 5.0.2, a > b and a >= b of AVX-512 packs are
/// b > a and b >= a (github.com/kokkos/kokkos/pull/8797).
using HostPack = Kokkos::Experimental::simd<double>;
using Pack = std::conditional_t<kOnDevice, double, HostPack>;

template <class R>
inline constexpr bool kIsPack = !std::is_arithmetic_v<R>;

/// Number of lanes of R; 1 for a plain number.
template <class R>
KOKKOS_INLINE_FUNCTION
constexpr int lanes() {
  if constexpr (kIsPack<R>) {
    return static_cast<int>(R::size());
  } else {
    return 1;
  }
}

/// Fills the lanes with f(lane).
template <class R, class F>
KOKKOS_FORCEINLINE_FUNCTION
R fill(const F& f) {
  if constexpr (kIsPack<R>) {
    return R([&](std::size_t i) { return static_cast<double>(f(static_cast<int>(i))); });
  } else {
    return static_cast<R>(f(0));
  }
}

/// Copies the lanes to a plain array.
template <class R>
KOKKOS_FORCEINLINE_FUNCTION
void store(const R& x, double* to) {
  if constexpr (kIsPack<R>) {
    Kokkos::Experimental::simd_unchecked_store(x, to, Kokkos::Experimental::simd_flag_default);
  } else {
    *to = x;
  }
}

/// Reads lanes that lie one after the other.
template <class R>
KOKKOS_FORCEINLINE_FUNCTION
R load(const double* from) {
  if constexpr (kIsPack<R>) {
    return Kokkos::Experimental::simd_unchecked_load<R>(from,
                                                        Kokkos::Experimental::simd_flag_default);
  } else {
    return *from;
  }
}

/// Lanes are f(lane of x); for the few lanes that a quick formula does not reach.
template <class R, class F>
KOKKOS_FORCEINLINE_FUNCTION
R map_lanes(const R& x, const F& f) {
  double a[lanes<R>()];
  store(x, a);
  for (int i = 0; i < lanes<R>(); ++i) a[i] = f(a[i]);
  return load<R>(a);
}

/// True when the comparison holds in any lane.
template <class M>
KOKKOS_FORCEINLINE_FUNCTION
bool any(const M& mask) {
  if constexpr (std::is_same_v<M, bool>) {
    return mask;
  } else {
    return Kokkos::Experimental::any_of(mask);
  }
}

template <class R>
KOKKOS_FORCEINLINE_FUNCTION
R maximum(const R& a, const R& b) {
  if constexpr (kIsPack<R>) {
    return Kokkos::max(a, b);
  } else {
    return a > b ? a : b;
  }
}

template <class R>
KOKKOS_FORCEINLINE_FUNCTION
R minimum(const R& a, const R& b) {
  if constexpr (kIsPack<R>) {
    return Kokkos::min(a, b);
  } else {
    return a < b ? a : b;
  }
}

template <class R>
KOKKOS_FORCEINLINE_FUNCTION
R square_root(const R& a) {
  return Kokkos::sqrt(a);
}

template <class R>
KOKKOS_FORCEINLINE_FUNCTION
R absolute(const R& a) {
  return Kokkos::abs(a);
}

}  // namespace breccia
