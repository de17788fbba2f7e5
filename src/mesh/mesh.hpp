#pragma once

#include "base/index.hpp"

#include <array>
#include <string>
#include <vector>

namespace breccia {

/// A point of the plane or of space. Unit m.
template <int D>
using Point = std::array<double, D>;

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

/// All bodies of a scene as one simplex mesh on the host. Bodies that are not parts of one another
/// share no point. Elements are positively oriented once `validate` has passed.
template <int D>
struct Mesh {
  std::vector<Point<D>> point;                    ///< m
  std::vector<std::array<Index, D + 1>> element;  ///< points of each element
  std::vector<Index> body;                        ///< per element: index in body_names
  std::vector<std::string> body_names;
  std::vector<Region> regions;

  Index points() const { return static_cast<Index>(point.size()); }
  Index elements() const { return static_cast<Index>(element.size()); }
};

/// The region of that name, or nullptr.
template <int D>
const Region* find_region(const Mesh<D>& mesh, const std::string& name);

/// The index of a body in `body_names`, or -1.
template <int D>
Index find_body(const Mesh<D>& mesh, const std::string& name);

/// Joins meshes without merging points; body and region names must be unique across them.
/// Throws Error naming the repeated body or region.
template <int D>
void append(Mesh<D>& mesh, const Mesh<D>& more);

}  // namespace breccia
