#pragma once

#include "mesh/topology.hpp"

#include <array>
#include <limits>
#include <vector>

namespace breccia {

/// A plane with everything within `tolerance` (m) of it.
template <int D>
struct PlaneSelector {
  Point<D> through{};
  Point<D> normal{};  ///< any length but zero
  double tolerance = 0;
};

/// A closed box; an axis may be unbounded (infinite limits).
template <int D>
struct BoxSelector {
  Point<D> lower{};
  Point<D> upper{};
};

/// Free faces and points on the plane, as an unnamed region. A face counts when all its nodes do;
/// elements stay empty.
template <int D>
Region select(const Mesh<D>& mesh, const Topology<D>& topology, const PlaneSelector<D>& plane);

/// Elements (by centroid), free faces (all nodes) and points inside the box.
template <int D>
Region select(const Mesh<D>& mesh, const Topology<D>& topology, const BoxSelector<D>& box);

}  // namespace breccia
