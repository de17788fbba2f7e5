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

}  // namespace breccia
