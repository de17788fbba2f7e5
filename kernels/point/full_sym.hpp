#pragma once
#include "base/mat.hpp"

namespace breccia {

/// A symmetric tensor of space as bodies in D dimensions have it: in the plane, the part in the
/// plane and the normal component across it; the shears across are zero.
template <int D, class R = double>
struct FullSym {
  static constexpr int size = D == 2 ? 4 : 6;
  Sym<D, R> in;
  R zz = R(0);  ///< not used in space, where `in` has it

  /// Component in stored order: xx, yy, xy, zz (plane) or xx, yy, zz, yz, xz, xy (space).
  KOKKOS_INLINE_FUNCTION
  R& operator[](int i) {
    if constexpr (D == 2)
      return i < 3 ? in.s[i] : zz;
    else
      return in.s[i];
  }
  KOKKOS_INLINE_FUNCTION
  const R& operator[](int i) const {
    if constexpr (D == 2)
      return i < 3 ? in.s[i] : zz;
    else
      return in.s[i];
  }

  KOKKOS_INLINE_FUNCTION
  static FullSym zero() { return {Sym<D, R>::zero(), R(0)}; }

  /// a times the identity of space.
  KOKKOS_INLINE_FUNCTION
  void add_identity(const R& a) {
    for (int i = 0; i < D; ++i) in.s[i] = in.s[i] + a;
    if constexpr (D == 2) zz = zz + a;
  }
  KOKKOS_INLINE_FUNCTION
  FullSym& operator+=(const FullSym& b) {
    in += b.in;
    if constexpr (D == 2) zz = zz + b.zz;
    return *this;
  }
  KOKKOS_INLINE_FUNCTION
  FullSym& operator*=(const R& f) {
    in *= f;
    if constexpr (D == 2) zz = zz * f;
    return *this;
  }
  friend KOKKOS_INLINE_FUNCTION
  FullSym operator*(FullSym a, const R& f) { return a *= f; }
};

template <int D, class R>
KOKKOS_INLINE_FUNCTION
R trace(const FullSym<D, R>& a) {
  if constexpr (D == 2)
    return trace(a.in) + a.zz;
  else
    return trace(a.in);
}

/// a : b.
template <int D, class R>
KOKKOS_INLINE_FUNCTION
R contract(const FullSym<D, R>& a, const FullSym<D, R>& b) {
  if constexpr (D == 2)
    return contract(a.in, b.in) + a.zz * b.zz;
  else
    return contract(a.in, b.in);
}

}  // namespace breccia
