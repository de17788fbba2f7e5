#pragma once

#include "io/vtkhdf.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace breccia {

/// A mesh, its fields and its cracks at one time: made up, but shaped like a run.
struct SampleState {
  int dimension = 2;
  std::vector<double> points, displacement, velocity, damage, opening, slip, mode, stress;
  std::vector<double> crack_points;
  std::vector<std::int32_t> cells, body, crack_cells, status;

  Frame frame(double time, std::int64_t step) const;
  CrackFrame cracks() const;
};

/// A disc of `rings` rings of triangles that a diametral crack opens while `progress` goes from 0
/// to 1.
SampleState sample_disc(int rings, double progress);

/// A beam of tetrahedra, `cells` cubes high, bent and cracked from above in its middle.
SampleState sample_beam(int cells, double progress);

/// Writes a whole run folder ("disc" or "beam") with `frames` frames, as a run would.
void write_sample_run(const std::string& folder, const std::string& kind, int frames);

}  // namespace breccia
