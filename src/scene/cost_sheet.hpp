#pragma once
#include "io/report.hpp"
#include "scene/recorder.hpp"
#include "scene/simulation.hpp"

namespace breccia {

/// How a run went, for its report.
struct Outcome {
  std::string status;  ///< complete, stopped or failed
  std::string reason;
  double wall_seconds = 0;
};

/// Everything of report.json but the checks.
template <int D>
Report make_report(Simulation<D>& simulation, const Recorder<D>& recorder, const Outcome& outcome);

/// Bytes of an effect: its fields and what its module keeps besides them.
template <int D>
std::size_t effect_bytes(const Simulation<D>& simulation, const std::string& effect);

/// Largest resident memory of this process so far, bytes; 0 where the system does not say.
std::int64_t peak_memory_bytes();

}  // namespace breccia
