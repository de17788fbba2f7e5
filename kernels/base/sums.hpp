#pragma once
#include "base/exec.hpp"

#include <Kokkos_Core.hpp>

namespace breccia {

/// K sums that a loop body adds to.
template <int K>
struct Sums {
  double v[K];

  KOKKOS_INLINE_FUNCTION
  Sums() {
    for (int k = 0; k < K; ++k) v[k] = 0;
  }
  KOKKOS_INLINE_FUNCTION
  double& operator[](int k) { return v[k]; }
  KOKKOS_INLINE_FUNCTION
  const double& operator[](int k) const { return v[k]; }
  KOKKOS_INLINE_FUNCTION
  Sums& operator+=(const Sums& b) {
    for (int k = 0; k < K; ++k) v[k] += b.v[k];
    return *this;
  }
};

/// Entities per partial sum. Fixed, so that sums do not depend on the number of threads.
inline constexpr Index kChunk = 2048;

inline constexpr Index chunks_of(Index n) {
  return (n + kChunk - 1) / kChunk;
}

/// Running sums of one loop, one row per chunk of entities; they are added up in chunk order
/// when somebody looks, never inside a step.
template <int K>
using ChunkSums = Kokkos::View<double* [K], Kokkos::LayoutRight, Memory>;

}  // namespace breccia

namespace Kokkos {
template <int K>
struct reduction_identity<breccia::Sums<K>> {
  KOKKOS_FORCEINLINE_FUNCTION
  static breccia::Sums<K> sum() { return {}; }
};
}  // namespace Kokkos

namespace breccia {

/// Runs f(i, sums) for i in [0, n) and adds each chunk's sums to its row of `rows`. The order
/// of additions is fixed: entities of a chunk in turn (host) or by a fixed tree (device).
template <int K, class Functor>
void for_each_summed(const char* label, Index n, const ChunkSums<K>& rows, const Functor& f) {
  if (n <= 0) return;
  count_launch();
  if constexpr (kOnDevice) {
    using Policy = Kokkos::TeamPolicy<Exec, Kokkos::IndexType<Index>>;
    Kokkos::parallel_for(
        label, Policy(chunks_of(n), 256), KOKKOS_LAMBDA(const typename Policy::member_type& team) {
          const Index chunk = team.league_rank();
          const Index begin = chunk * kChunk;
          const Index end = begin + kChunk < n ? begin + kChunk : n;
          Sums<K> total;
          Kokkos::parallel_reduce(
              Kokkos::TeamThreadRange(team, begin, end),
              [&](Index i, Sums<K>& part) { f(i, part); }, Kokkos::Sum<Sums<K>>(total));
          Kokkos::single(Kokkos::PerTeam(team), [&]() {
            for (int k = 0; k < K; ++k) rows(chunk, k) += total[k];
          });
        });
  } else {
    Kokkos::parallel_for(
        label, Kokkos::RangePolicy<Exec, Kokkos::IndexType<Index>>(0, chunks_of(n)),
        KOKKOS_LAMBDA(const Index chunk) {
          const Index begin = chunk * kChunk;
          const Index end = begin + kChunk < n ? begin + kChunk : n;
          Sums<K> total;
          for (Index i = begin; i < end; ++i) f(i, total);
          for (int k = 0; k < K; ++k) rows(chunk, k) += total[k];
        });
  }
}

/// Adds the rows up in chunk order, on the host.
template <int K>
Sums<K> total_of(const ChunkSums<K>& rows) {
  const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, rows);
  Sums<K> total;
  for (std::size_t c = 0; c < host.extent(0); ++c)
    for (int k = 0; k < K; ++k) total[k] += host(c, k);
  return total;
}

}  // namespace breccia
