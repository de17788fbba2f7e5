// Makes what the Python tests look at: `sample_run FOLDER disc|beam FRAMES`, or `sample_run FOLDER
// vtk` for the small files whose content tests/scene/check_frames.py knows.
#include "harness/sample_run.hpp"

#include <cstdlib>
#include <filesystem>
#include <iostream>

namespace breccia {
namespace {

// Two triangles and arrays of all kinds; check_frames.py computes the same numbers.
void write_plane(const std::string& path) {
  const std::vector<double> points = {0, 0, 1, 0.1, 1, 1, 0, 1.1},
                            velocity = {0, 1, 2, 3, 4, 5, 6, 7};
  const std::vector<std::int32_t> cells = {0, 1, 2, 0, 2, 3}, body = {3, -7};
  const std::vector<double> damage = {0.25, 1.0 / 3};
  const std::vector<float> speed = {0.5f, 1.5f, 2.5f, 3.5f};
  const std::vector<float> plane_stress = {1, 2, 3, 4, 5, 6};
  std::vector<double> stress(12);
  for (std::size_t k = 0; k < stress.size(); ++k) stress[k] = 1e6 * static_cast<double>(k) + 0.125;
  Frame frame{.dimension = 2, .points = points, .cell = CellType::triangle, .connectivity = cells};
  frame.point_arrays = {{"velocity", "m/s", 2, std::span<const double>(velocity)},
                        {"speed", "m/s", 1, std::span<const float>(speed)}};
  frame.cell_arrays = {{"body", "1", 1, std::span<const std::int32_t>(body)},
                       {"damage", "1", 1, std::span<const double>(damage)},
                       {"plane_stress", "Pa", 3, std::span<const float>(plane_stress)},
                       {"stress", "Pa", 6, std::span<const double>(stress)}};
  frame.time = 0.375;
  frame.step = 42;
  write_frame(path, frame);
}

void write_space(const std::string& path) {
  const std::vector<double> points = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1};
  const std::vector<std::int32_t> cells = {0, 1, 2, 3, 1, 2, 3, 4};
  Frame frame{
      .dimension = 3, .points = points, .cell = CellType::tetrahedron, .connectivity = cells};
  frame.point_arrays = {{"displacement", "m", 3, std::span<const double>(points)}};
  write_frame(path, frame);
}

void write_cracks(const std::string& path, std::size_t count) {
  const std::vector<double> points = {0, 0, 1, 0, 1, 1}, value = {0.5, 1.0};
  const std::vector<std::int32_t> lines = {0, 1, 1, 2}, status = {1, 2};
  const auto some = std::span(value).first(count);
  const CrackFrame cracks = {2,
                             std::span(points).first(count > 0 ? 6 : 0),
                             std::span(lines).first(2 * count),
                             some,
                             some,
                             some,
                             some,
                             std::span(status).first(count),
                             some,
                             some};
  write_frame(path, as_frame(cracks, 0.5, 1));
}

}  // namespace
}  // namespace breccia

int main(int argc, char** argv) {
  if (argc < 3) {
    std::cerr << "sample_run FOLDER disc|beam FRAMES, or sample_run FOLDER vtk\n";
    return 2;
  }
  const std::string folder = argv[1], kind = argv[2];
  if (kind == "vtk") {
    std::filesystem::create_directories(folder);
    breccia::write_plane(folder + "/plane.vtkhdf");
    breccia::write_space(folder + "/space.vtkhdf");
    breccia::write_cracks(folder + "/cracks.vtkhdf", 2);
    breccia::write_cracks(folder + "/no_cracks.vtkhdf", 0);
  } else {
    breccia::write_sample_run(folder, kind, argc > 3 ? std::atoi(argv[3]) : 5);
  }
  return 0;
}
