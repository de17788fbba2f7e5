#include "io/vtkhdf.hpp"

#include "io/hdf5_file.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace breccia {
namespace {

[[noreturn]] void unfit(const std::string& what) {
  throw std::logic_error("frame: " + what);
}

std::size_t values_in(const FrameArray& array) {
  return std::visit([](const auto& span) { return span.size(); }, array.values);
}

void check_arrays(const std::vector<FrameArray>& arrays, std::size_t entities) {
  for (const FrameArray& array : arrays) {
    if (array.components < 1 ||
        values_in(array) != entities * static_cast<std::size_t>(array.components)) {
      unfit("array '" + array.name + "' has " + std::to_string(values_in(array)) + " values for " +
            std::to_string(entities) + " entities");
    }
  }
}

void check(const Frame& frame) {
  const auto d = static_cast<std::size_t>(frame.dimension),
             n = static_cast<std::size_t>(corners_of(frame.cell));
  if (d < 2 || d > 3 || frame.points.size() % d != 0)
    unfit("points are not made of 2 or 3 components");
  if (frame.connectivity.size() % n != 0) unfit("connectivity is not made of whole cells");
  const auto points = static_cast<std::int64_t>(frame.points.size() / d);
  for (const std::int32_t corner : frame.connectivity) {
    if (corner < 0 || corner >= points) unfit("corner " + std::to_string(corner) + " is no point");
  }
  check_arrays(frame.point_arrays, frame.points.size() / d);
  check_arrays(frame.cell_arrays, frame.connectivity.size() / n);
}

// Rows of two components with a zero appended to each.
template <class T>
std::vector<T> in_space(std::span<const T> plane) {
  std::vector<T> space(plane.size() / 2 * 3, T(0));
  for (std::size_t i = 0; i < plane.size() / 2; ++i) {
    space[3 * i] = plane[2 * i];
    space[3 * i + 1] = plane[2 * i + 1];
  }
  return space;
}

// Where VTK's components xx, yy, zz, xy, yz, xz of a symmetric tensor stand in ours; -1: not given.
std::array<int, 6> tensor_order(int components) {
  if (components == 3) return {0, 1, -1, 2, -1, -1};
  if (components == 4) return {0, 1, 3, 2, -1, -1};
  return {0, 1, 2, 5, 3, 4};
}

template <class T>
std::vector<T> as_tensors(std::span<const T> values, int components) {
  const std::array<int, 6> order = tensor_order(components);
  const auto c = static_cast<std::size_t>(components);
  std::vector<T> tensors(values.size() / c * 6, T(0));
  for (std::size_t i = 0; i < tensors.size(); ++i) {
    const int from = order[i % 6];
    if (from >= 0) tensors[i] = values[i / 6 * c + static_cast<std::size_t>(from)];
  }
  return tensors;
}

void write_array(H5Writer& file, const std::string& group, const FrameArray& array, int dimension) {
  const std::string name = group + "/" + array.name;
  const int components = array.components;
  const bool tensor = components == 6 || (dimension == 2 && (components == 3 || components == 4));
  const auto write = [&]<class T>(std::span<const T> values) {
    const auto c = static_cast<std::size_t>(components);
    if (c == 1) {
      file.write(name, view_of(values));
    } else if (tensor) {
      const std::vector<T> tensors = as_tensors(values, components);
      file.write(name, view_of(tensors, {tensors.size() / 6, 6}));
    } else if (c == 2) {
      const std::vector<T> space = in_space(values);
      file.write(name, view_of(space, {space.size() / 3, 3}));
    } else {
      file.write(name, view_of(values, {values.size() / c, c}));
    }
  };
  std::visit(write, array.values);
  if (!array.unit.empty()) file.attribute(name, "unit", array.unit);
}

void write_cells(H5Writer& file, const Frame& frame) {
  const auto corners = static_cast<std::size_t>(corners_of(frame.cell));
  const std::size_t cells = frame.connectivity.size() / corners;
  std::vector<std::int64_t> offsets(cells + 1);
  for (std::size_t k = 0; k <= cells; ++k) offsets[k] = static_cast<std::int64_t>(k * corners);
  const std::vector<std::int64_t> connectivity(frame.connectivity.begin(),
                                               frame.connectivity.end());
  const std::vector<std::uint8_t> types(cells, static_cast<std::uint8_t>(frame.cell));
  file.write("VTKHDF/Connectivity", view_of(connectivity));
  file.write("VTKHDF/Offsets", view_of(offsets));
  file.write("VTKHDF/Types", view_of(types));
}

void write_sizes(H5Writer& file, const Frame& frame) {
  const auto d = static_cast<std::size_t>(frame.dimension),
             n = static_cast<std::size_t>(corners_of(frame.cell));
  // One entry per partition; a single process writes one.
  const std::array points = {static_cast<std::int64_t>(frame.points.size() / d)};
  const std::array cells = {static_cast<std::int64_t>(frame.connectivity.size() / n)};
  const std::array corners = {static_cast<std::int64_t>(frame.connectivity.size())};
  file.write("VTKHDF/NumberOfPoints", view_of(points));
  file.write("VTKHDF/NumberOfCells", view_of(cells));
  file.write("VTKHDF/NumberOfConnectivityIds", view_of(corners));
}

}  // namespace

int corners_of(CellType type) {
  switch (type) {
    case CellType::vertex:
      return 1;
    case CellType::line:
      return 2;
    case CellType::triangle:
      return 3;
    case CellType::tetrahedron:
      return 4;
  }
  return 0;
}

Frame as_frame(const CrackFrame& cracks, double time, std::int64_t step) {
  Frame frame;
  frame.dimension = cracks.dimension;
  frame.points = cracks.points;
  frame.cell = cracks.dimension == 2 ? CellType::line : CellType::triangle;
  frame.connectivity = cracks.connectivity;
  frame.cell_arrays = {{"damage", "1", 1, cracks.damage},   {"mode", "1", 1, cracks.mode},
                       {"opening", "m", 1, cracks.opening}, {"slip", "m", 1, cracks.slip},
                       {"status", "1", 1, cracks.status},   {"time", "s", 1, cracks.time},
                       {"energy", "J/m2", 1, cracks.energy}};
  frame.time = time;
  frame.step = step;
  return frame;
}

void write_frame(const std::string& path, const Frame& frame) {
  check(frame);
  H5Writer file(path);
  file.group("VTKHDF");
  file.attribute("VTKHDF", "Version", std::array<std::int64_t, 2>{1, 0});
  file.attribute("VTKHDF", "Type", std::string_view("UnstructuredGrid"));
  write_sizes(file, frame);
  if (frame.dimension == 3) {
    file.write("VTKHDF/Points", view_of(frame.points, {frame.points.size() / 3, 3}));
  } else {
    const std::vector<double> space = in_space(frame.points);
    file.write("VTKHDF/Points", view_of(space, {space.size() / 3, 3}));
  }
  write_cells(file, frame);
  file.group("VTKHDF/PointData");
  file.group("VTKHDF/CellData");
  for (const FrameArray& array : frame.point_arrays)
    write_array(file, "VTKHDF/PointData", array, frame.dimension);
  for (const FrameArray& array : frame.cell_arrays)
    write_array(file, "VTKHDF/CellData", array, frame.dimension);
  file.write("VTKHDF/FieldData/time", view_of(std::array{frame.time}));
  file.write("VTKHDF/FieldData/step", view_of(std::array{frame.step}));
  file.attribute("VTKHDF", "dimension", std::array<std::int64_t, 1>{frame.dimension});
  file.commit();
}

}  // namespace breccia
