#pragma once
#include "base/views.hpp"

#include <cstdint>

namespace breccia {

/// Numbers of the entities whose flag is set, ascending, into `list`; returns how many. One launch
/// and one number to the host.
inline Index compact(const char* label, const Kokkos::View<const std::uint8_t*, Memory>& flag,
                     Index n, const Array<Index>& list) {
  return scan(
      label, n, KOKKOS_LAMBDA(Index i, Index & at, bool last) {
        if (flag(i) == 0) return;
        if (last) list(at) = i;
        ++at;
      });
}

/// Sets a flag that several iterations may set at once, all to the same value.
KOKKOS_FORCEINLINE_FUNCTION
void raise(const Array<std::uint8_t>& flag, Index i) {
  KOKKOS_IF_ON_HOST((Kokkos::atomic_store(&flag(i), std::uint8_t{1});))
  KOKKOS_IF_ON_DEVICE((flag(i) = 1;))
}

}  // namespace breccia
