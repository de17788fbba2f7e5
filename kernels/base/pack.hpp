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

/// The same register full of floats: twice the lanes (precision = "mixed").
using HostPackSingle = Kokkos::Experimental::simd<float>;
using PackSingle = std::conditional_t<kOnDevice, float, HostPackSingle>;

template <class R>
inline constexpr bool kIsPack = !std::is_arithmetic_v<R>;

namespace pack_detail {
template <class R, bool Packed = kIsPack<R>>
struct LaneOf {
  using type = R;
};
template <class R>
struct LaneOf<R, true> {
  using type = typename R::value_type;
};
}  // namespace pack_detail

/// Type of one lane of R.
template <class R>
using Lane = typename pack_detail::LaneOf<R>::type;

/// True where strains are taken from differences that are small themselves: in single precision
/// F - 1 would keep too little of them.
template <class R>
inline constexpr bool kSingle = std::is_same_v<Lane<R>, float>;

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
    return R([&](std::size_t i) { return static_cast<Lane<R>>(f(static_cast<int>(i))); });
  } else {
    return static_cast<R>(f(0));
  }
}

/// Copies the lanes to a plain array.
template <class R, class T>
KOKKOS_FORCEINLINE_FUNCTION
void store(const R& x, T* to) {
  if constexpr (!kIsPack<R>) {
    *to = static_cast<T>(x);
  } else if constexpr (std::is_same_v<T, Lane<R>>) {
    Kokkos::Experimental::simd_unchecked_store(x, to, Kokkos::Experimental::simd_flag_default);
  } else {
    Lane<R> lane[lanes<R>()];
    store(x, lane);
    for (int l = 0; l < lanes<R>(); ++l) to[l] = static_cast<T>(lane[l]);
  }
}

/// Reads lanes that lie one after the other.
template <class R, class T>
KOKKOS_FORCEINLINE_FUNCTION
R load(const T* from) {
  if constexpr (!kIsPack<R>) {
    return static_cast<R>(*from);
  } else if constexpr (std::is_same_v<T, Lane<R>>) {
    return Kokkos::Experimental::simd_unchecked_load<R>(from,
                                                        Kokkos::Experimental::simd_flag_default);
  } else {
    Lane<R> lane[lanes<R>()];
    for (int l = 0; l < lanes<R>(); ++l) lane[l] = static_cast<Lane<R>>(from[l]);
    return load<R>(static_cast<const Lane<R>*>(lane));
  }
}

/// Lanes are f(lane of x).
template <class R, class F>
KOKKOS_FORCEINLINE_FUNCTION
R map_lanes(const R& x, const F& f) {
  double a[lanes<R>()];
  store(x, a);
  for (int i = 0; i < lanes<R>(); ++i) a[i] = f(a[i]);
  return load<R>(a);
}

/// The quick result but in lanes whose `y` is beyond `reach`, where it is f(lane of x). What a lane
/// gets does not depend on the others: elements are packed differently on other numbers of ranks.
template <class R, class F>
KOKKOS_FORCEINLINE_FUNCTION
R mended(const R& quick, const R& y, double reach, const R& x, const F& f) {
  double result[lanes<R>()], size[lanes<R>()], of[lanes<R>()];
  store(quick, result);
  store(y, size);
  store(x, of);
  for (int l = 0; l < lanes<R>(); ++l)
    if (!(size[l] <= static_cast<Lane<R>>(reach))) result[l] = f(of[l]);
  return load<R>(result);
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
