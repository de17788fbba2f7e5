#pragma once

#include "mesh/mesh.hpp"

#include <array>
#include <map>
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
  std::map<Edge, Index> middle;  ///< mid-edge nodes of second-order elements
  ElementFields fields;          ///< of all elements, in this order
};

/// Notes the mid-edge node of an edge. Throws Error at `source` when the edge has another one.
void add_middle(RawMesh& raw, Index a, Index b, Index middle, const std::string& source);

/// The nodes of an element type of Gmsh: dimension + 1 corners, then mid-edge nodes.
struct GmshType {
  int dimension = -1;                        ///< -1: a type that we do not take
  int middles = 0;                           ///< mid-edge nodes behind the corners
  std::array<std::array<int, 2>, 6> edge{};  ///< corners of the edge of each
};

/// Points, lines, triangles and tetrahedra of first and second order.
GmshType gmsh_type(long long type);

/// What to say of other types.
inline constexpr const char* kTypesTaken =
    "mesh with triangles or tetrahedra of first or second order";

/// The elements of dimension D as a mesh of one body named "file", with every group as a region of
/// its own name. Points that only lower elements use are dropped (Gmsh keeps the centres of
/// circles). Mid-edge nodes become `curved` where they are off the middle by more than rounding.
/// Elements repeated for a second group, as MSH 2 writes them, count once, with the fields of the
/// first. `source` names
/// the place of errors: no elements of dimension D, a plane mesh with points off the plane z = 0,
/// points that no element uses, two groups with one name.
template <int D>
Mesh<D> to_mesh(const RawMesh& raw, const std::string& source);

}  // namespace breccia
