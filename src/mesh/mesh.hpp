#pragma once

#include "base/index.hpp"

#include <array>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace breccia {

/// A point of the plane or of space. Unit m.
template <int D>
using Point = std::array<double, D>;

/// The two points of an element's edge, the smaller first.
using Edge = std::array<Index, 2>;

inline Edge edge_of(Index a, Index b) {
  return a < b ? Edge{a, b} : Edge{b, a};
}

/// One face seen from one element: local face f lies opposite local node f (base/simplex.hpp).
struct ElementFace {
  Index element = 0;
  int face = 0;
  auto operator<=>(const ElementFace&) const = default;
};

/// A named part of the mesh that boundaries, sensors and fractures refer to.
/// - a region of dimension D (every body has one of its own name): `elements`, the `points` they
///   use, and of a body's own region its free `faces`;
/// - a side (dimension D - 1; "disc.left"): `faces` and their `points`. A face between two elements
///   is listed once, seen from one of the two;
/// - a curve in space or a point: `points`.
///
/// All lists are sorted and without repetition.
struct Region {
  std::string name;
  std::vector<Index> elements;
  std::vector<ElementFace> faces;
  std::vector<Index> points;
};

/// Numbers that a mesh file gives to its elements ($ElementData of Gmsh).
struct ElementField {
  int components = 1;
  std::vector<double> values;  ///< components of each element; NaN: the file gives none
};
using ElementFields = std::map<std::string, ElementField>;

/// The fields of elements that were numbers `old` before, in this order; kNone: without values.
ElementFields fields_of(const ElementFields& fields, std::span<const Index> old);

/// All bodies of a scene as one simplex mesh on the host. Bodies that are not parts of one another
/// share no point. Elements are positively oriented once `validate` has passed.
template <int D>
struct Mesh {
  std::vector<Point<D>> point;                    ///< m
  std::vector<std::array<Index, D + 1>> element;  ///< points of each element
  std::vector<Index> body;                        ///< per element: index in body_names
  std::vector<std::string> body_names;
  std::vector<Region> regions;
  /// Of edges that follow a curved boundary: the place of the mid-edge node, m. Elements are
  /// straight all the same; composites made of them are not (mesh/composite.hpp).
  std::map<Edge, Point<D>> curved = {};
  /// Per body, after refinement to composites: elements of each composite (1: simple). Those of one
  /// composite are contiguous. Empty: all elements are simple.
  std::vector<int> group_size = {};
  /// By name, from mesh files; the parts of a composite have those of the whole.
  ElementFields fields = {};
  /// Of a part of a larger mesh (mesh/part.hpp): regions may be empty.
  bool partial = false;
  double whole_extent = 0;  ///< m, extent_of the mesh that it is a part of; 0: it is the whole

  Index points() const { return static_cast<Index>(point.size()); }
  Index elements() const { return static_cast<Index>(element.size()); }
  int group_of_body(Index b) const { return group_size.empty() ? 1 : group_size[b]; }
};

/// The longest side of the box around the whole mesh, m.
template <int D>
double extent_of(const Mesh<D>& mesh);

/// The region of that name, or nullptr.
template <int D>
const Region* find_region(const Mesh<D>& mesh, const std::string& name);

/// The index of a body in `body_names`, or -1.
template <int D>
Index find_body(const Mesh<D>& mesh, const std::string& name);

/// Joins meshes without merging points; body and region names must be unique across them.
/// Throws Error naming the repeated body or region, or the field of two numbers of components.
template <int D>
void append(Mesh<D>& mesh, const Mesh<D>& more);

}  // namespace breccia
