#pragma once
#include "base/index.hpp"

#include <Kokkos_Core.hpp>

#include <cstdint>

namespace breccia {

using Exec = Kokkos::DefaultExecutionSpace;
using Memory = Exec::memory_space;
using Host = Kokkos::DefaultHostExecutionSpace;

/// True where kernels run on another processor than the host.
inline constexpr bool kOnDevice =
    !Kokkos::SpaceAccessibility<Kokkos::HostSpace, Memory>::accessible;

/// Launches and bytes of the effect that is running; the plan sets `current` around every task.
struct Tally {
  std::int64_t launches = 0;
};
inline Tally* current_tally = nullptr;

inline void count_launch() {
  if (current_tally != nullptr) ++current_tally->launches;
}

/// Runs f(i) for i in [begin, end). Every i must write to places of its own.
template <class Functor>
void for_each(const char* label, Index begin, Index end, const Functor& f) {
  if (end <= begin) return;
  count_launch();
  Kokkos::parallel_for(label, Kokkos::RangePolicy<Exec, Kokkos::IndexType<Index>>(begin, end), f);
}

template <class Functor>
void for_each(const char* label, Index n, const Functor& f) {
  for_each(label, 0, n, f);
}

/// Runs f once on the device: for tables too small to be worth a parallel loop.
template <class Functor>
void run_once(const char* label, const Functor& f) {
  for_each(label, 0, 1, f);
}

/// Exclusive scan: f(i, partial, final) adds its count to `partial`; returns the total.
/// Integers only, so the result does not depend on the number of threads.
template <class Functor>
Index scan(const char* label, Index n, const Functor& f) {
  Index total = 0;
  if (n <= 0) return total;
  count_launch();
  Kokkos::parallel_scan(label, Kokkos::RangePolicy<Exec, Kokkos::IndexType<Index>>(0, n), f, total);
  return total;
}

}  // namespace breccia
