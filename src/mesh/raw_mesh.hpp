#pragma once

#include "mesh/mesh.hpp"

#include <array>
#include <string>
#include <vector>

namespace breccia {

/// Point, line, triangle or tetrahedron as a mesh file lists it.
struct RawElement {
  int dimension = 0;
  std::array<Index, 4> point{};  ///< the first dimension + 1 count
};

/// A physical group: elements of one dimension under one name.
struct RawGroup {
  int dimension = 0;
  std::string name;
  std::vector<Index> elements;  ///< in RawMesh::element
};

/// What a mesh file holds, before we know which part of it is wanted. Lengths in m.
struct RawMesh {
  std::vector<Point<3>> point;
  std::vector<RawElement> element;
  std::vector<RawGroup> groups;
};

/// The elements of dimension D as a mesh of one body named "file", with every group as a region of
/// its own name. Points that only lower elements use are dropped (Gmsh keeps the centres of
/// circles). Elements repeated for a second group, as MSH 2 writes them, count once. `source` names
/// the place of errors: no elements of dimension D, a plane mesh with points off the plane z = 0,
/// points that no element uses, two groups with one name.
template <int D>
Mesh<D> to_mesh(const RawMesh& raw, const std::string& source);

}  // namespace breccia
