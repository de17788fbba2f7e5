#pragma once
#include "mesh/topology.hpp"

#include <vector>

namespace breccia {

/// Some elements of a mesh as a mesh of their own, in the order that they have in the whole, and
/// how they hang together there. A point whose elements do not all belong to the part lies at its
/// rim; it becomes one point for each corner, since nobody here can tell how they hang together.
template <int D>
struct MeshPart {
  Mesh<D> mesh;
  Topology<D> topology;        ///< faces towards elements outside are neither shared nor free
  std::vector<Index> element;  ///< number in the whole mesh, ascending
  std::vector<Index> family;   ///< point of the whole mesh, ascending
  std::vector<Index> face;     ///< shared face of the whole mesh, ascending
};

/// `elements` ascending, without repetition.
template <int D>
MeshPart<D> take_part(const Mesh<D>& mesh, const Topology<D>& topology,
                      const std::vector<Index>& elements);

/// The elements, and those that share a point with one of them, `rings` times; ascending.
template <int D>
std::vector<Index> with_neighbours(const Mesh<D>& mesh, const Topology<D>& topology,
                                   const std::vector<Index>& elements, int rings);

/// A box with sides along the axes, m.
template <int D>
struct AxisBox {
  Point<D> low, high;
};

/// The chosen boxes and those that come within `reach` of one of them; ascending.
template <int D>
std::vector<Index> boxes_near(const std::vector<AxisBox<D>>& boxes,
                              const std::vector<Index>& chosen, double reach);

}  // namespace breccia
