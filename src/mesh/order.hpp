#pragma once

#include "mesh/mesh.hpp"

#include <span>
#include <vector>

namespace breccia {

/// A renumbering: entry n is the old number of the new entity n.
struct Ordering {
  std::vector<Index> element;
  std::vector<Index> point;
};

/// Locality order: elements by block key, then along a Hilbert curve through their centroids (equal
/// keys: old number); points by first use in that element order, unused points last. `block` has
/// one entry per element (one value per combination of material and law, so that each combination
/// is one contiguous run), or is empty. The result depends on the mesh only.
template <int D>
Ordering locality_order(const Mesh<D>& mesh, std::span<const Index> block = {});

/// Elements as they are, points by first use.
template <int D>
Ordering first_use_order(const Mesh<D>& mesh);

/// The mesh renumbered, regions included (their lists are sorted again).
template <int D>
Mesh<D> reordered(const Mesh<D>& mesh, const Ordering& ordering);

/// Mean distance of the point numbers within an element divided by the number of points: 1/3 for
/// random numbers, about 1/sqrt(points) in locality order.
template <int D>
double mean_index_distance(const Mesh<D>& mesh);

}  // namespace breccia
