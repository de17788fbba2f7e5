#pragma once
#include "base/views.hpp"

#include <cstdint>

namespace breccia {

/// Numbers of the entities whose flag is set, ascending, into `list`; returns how many. One launch
/// and one number to the host. Flags are looked at eight at a time: most are not set, or all.
inline Index compact(const char* label, const Kokkos::View<const std::uint8_t*, Memory>& flag,
                     Index n, const Array<Index>& list) {
  constexpr Index kWord = 8;
  return scan(
      label, (n + kWord - 1) / kWord, KOKKOS_LAMBDA(Index w, Index & at, bool last) {
        const Index begin = w * kWord, end = begin + kWord < n ? begin + kWord : n;
        if (end == begin + kWord) {
          std::uint32_t any = 0;
          for (Index i = 0; i < kWord; ++i) any |= flag(begin + i);
          if (any == 0) return;
        }
        for (Index i = begin; i < end; ++i) {
          if (flag(i) == 0) continue;
          if (last) list(at) = i;
          ++at;
        }
      });
}

/// The same of flags that are bits of words. Where none is raised the host sees it by itself.
inline Index compact(const char* label, const Kokkos::View<const BitWord*, Memory>& words,
                     const Array<Index>& list) {
  if constexpr (!kOnDevice) {
    BitWord any = 0;
    for (std::size_t w = 0; w < words.extent(0); ++w) any |= words(w);
    if (any == 0) return 0;
  }
  return scan(
      label, static_cast<Index>(words.extent(0)), KOKKOS_LAMBDA(Index w, Index & at, bool last) {
        const BitWord word = words(w);
        if (word == 0) return;
        for (Index b = 0; b < kWordBits; ++b) {
          if ((word >> b & 1) == 0) continue;
          if (last) list(at) = w * kWordBits + b;
          ++at;
        }
      });
}

KOKKOS_FORCEINLINE_FUNCTION
bool is_raised(const Kokkos::View<const BitWord*, Memory>& words, Index i) {
  return (words(i / kWordBits) >> (i % kWordBits) & 1) != 0;
}

/// Sets a flag that several iterations may set at once, all to the same value.
KOKKOS_FORCEINLINE_FUNCTION
void raise(const Array<std::uint8_t>& flag, Index i) {
  KOKKOS_IF_ON_HOST((Kokkos::atomic_store(&flag(i), std::uint8_t{1});))
  KOKKOS_IF_ON_DEVICE((flag(i) = 1;))
}

/// Asks a processor that runs ahead of its memory, the host, for the line at `address`.
KOKKOS_FORCEINLINE_FUNCTION
void fetch(const void* address) {
  KOKKOS_IF_ON_HOST((__builtin_prefetch(address);))
  KOKKOS_IF_ON_DEVICE((static_cast<void>(address);))
}

}  // namespace breccia
