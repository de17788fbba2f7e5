#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace breccia {

/// Cell kinds that frames are made of, with VTK's numbers.
enum class CellType : std::uint8_t { vertex = 1, line = 3, triangle = 5, tetrahedron = 10 };

int corners_of(CellType type);

/// A named array over points or cells, entity by entity. What it is follows from its components:
/// D are a vector, written with three; 3 in the plane (xx, yy, xy), 4 in the plane (xx, yy, xy, zz)
/// and 6 (xx, yy, zz, yz, xz, xy: the order of Sym) are a symmetric tensor, written in VTK's order
/// xx, yy, zz, xy, yz, xz with zeros for what is not given; all others are written as they are.
struct FrameArray {
  std::string name;
  std::string unit;  ///< kept as attribute "unit" of the data set; pictures print it
  int components = 1;
  std::variant<std::span<const double>, std::span<const float>, std::span<const std::int32_t>>
      values;
};

/// One mesh with its fields at one time. Everything is borrowed for the time of the call.
struct Frame {
  int dimension = 3;                           ///< components per point in `points`
  std::span<const double> points;              ///< [m]; written with three components
  CellType cell = CellType::tetrahedron;       ///< all cells are of one kind
  std::span<const std::int32_t> connectivity;  ///< corners, cell by cell
  std::vector<FrameArray> point_arrays = {}, cell_arrays = {};
  double time = 0;        ///< [s]; FieldData "time"
  std::int64_t step = 0;  ///< FieldData "step"
};

/// Crack faces at one time: lines in 2D, triangles in 3D, one value per face in every array.
struct CrackFrame {
  int dimension = 2;
  std::span<const double> points;
  std::span<const std::int32_t> connectivity;
  std::span<const double> damage;        ///< 0 intact ... 1 broken
  std::span<const double> mode;          ///< 1 tension ... 2 shear
  std::span<const double> opening;       ///< [m] opening
  std::span<const double> slip;          ///< [m] slip
  std::span<const std::int32_t> status;  ///< 1 inserted (cohesive), 2 released (broken)
  std::span<const double> time;          ///< [s] when it broke; -1 while it holds
  std::span<const double> energy;        ///< [J/m2] spent per area
};

Frame as_frame(const CrackFrame& cracks, double time, std::int64_t step);

/// Writes a VTKHDF 1.0 UnstructuredGrid (as VTK 9.1's vtkHDFReader opens it), whole or not at all.
/// Throws Error (no HDF5 in this build, disk full, no permission); std::logic_error when sizes do
/// not fit together.
void write_frame(const std::string& path, const Frame& frame);

}  // namespace breccia
