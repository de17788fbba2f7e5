#pragma once
#include "harness/machine.hpp"

#include <benchmark/benchmark.h>

namespace breccia::perf {

/// Entities/s, bytes per entity counted from the code, and the share of the bandwidth of this
/// process that they make.
inline void report(benchmark::State& state, double entities, double bytes) {
  Kokkos::fence("breccia::perf::report");
  const double rate = entities * static_cast<double>(state.iterations());
  state.counters["entities/s"] = benchmark::Counter(rate, benchmark::Counter::kIsRate);
  state.counters["bytes/entity"] = bytes;
  state.counters["of bandwidth"] =
      benchmark::Counter(rate * bytes / bandwidth(), benchmark::Counter::kIsRate);
}

/// Elements of a benchmark; few where only its answer is looked at.
inline void one_size(benchmark::internal::Benchmark* b) {
  b->ArgName("elements")->Unit(benchmark::kMillisecond)->UseRealTime()->Arg(smoke() ? 2000 : 30000);
}

}  // namespace breccia::perf
