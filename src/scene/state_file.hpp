#pragma once
#include "io/checkpoint.hpp"
#include "scene/simulation.hpp"

#include <string>

namespace breccia {

/// How far the output files of a run had come when a checkpoint was written.
struct OutputState {
  std::int64_t history_rows = 0, event_rows = 0, fragment_rows = 0;
  std::int64_t next_history = 0, next_frame = 0;
  std::vector<double> frame_times;
  double wall_seconds = 0;
};

/// What a checkpoint of this scene on this build is called.
CheckpointIdentity identity_of(const std::string& resolved_scene);

/// Writes the whole state, aside first. Throws Error.
template <int D>
void save_state(const std::string& path, const CheckpointIdentity& identity,
                Simulation<D>& simulation, const OutputState& output);

/// Fills a simulation that has been built but not started. Throws Error.
template <int D>
OutputState load_state(const std::string& path, const CheckpointIdentity& identity,
                       Simulation<D>& simulation);

/// Order-fixed hash of positions, velocities, damage and labels: of everything that a restart
/// needs. Equal bits, equal hashes.
template <int D>
std::string state_hash(const Simulation<D>& simulation);

}  // namespace breccia
