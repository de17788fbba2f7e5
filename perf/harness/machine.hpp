#pragma once
#include "base/views.hpp"

#include <Kokkos_Core.hpp>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <string>

namespace breccia::perf {

/// True when ctest runs the benchmark at tiny size to verify it.
inline bool smoke() {
  return std::getenv("BRECCIA_PERF_SMOKE") != nullptr;
}

/// Bandwidth of a = b + s c in this process with its threads, bytes/s: the best of five runs over
/// arrays far larger than the caches. Measured once, beside the benchmarks, because machines differ
/// from minute to minute.
inline double bandwidth() {
  static const double measured = [] {
    const Index n = smoke() ? 1 << 18 : 1 << 25;
    Array<double> a("breccia::perf::a", n), b("breccia::perf::b", n), c("breccia::perf::c", n);
    double best = 0;
    for (int run = 0; run < 5; ++run) {
      Kokkos::fence("breccia::perf::triad");
      const auto start = std::chrono::steady_clock::now();
      for_each(
          "breccia::perf::triad", n, KOKKOS_LAMBDA(Index i) { a(i) = b(i) + 3.0 * c(i); });
      Kokkos::fence("breccia::perf::triad");
      const std::chrono::duration<double> t = std::chrono::steady_clock::now() - start;
      best = std::max(best, 24.0 * n / t.count());
    }
    return best;
  }();
  return measured;
}

}  // namespace breccia::perf
