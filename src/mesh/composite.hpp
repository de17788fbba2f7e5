#pragma once

#include "mesh/mesh.hpp"

#include <span>
#include <vector>

namespace breccia {

/// The mesh with each element of body b cut into `group_size[b]` elements (ALGORITHMS ): 1
/// leaves it alone, 4 in the plane, 8 or 12 in space make a composite. The pieces of one element
/// are contiguous, in its place and in the order of base/composite.hpp; points are numbered by
/// first use.
///
/// Mid-edge nodes are at `mesh.curved`, elsewhere in the middle of the edge; an element that would
/// get a sub-element smaller than a tenth of its share has its edges made straight instead.
/// The octahedron of a group of 8 is cut along its shortest diagonal, of equal ones along the one
/// whose parent edges have the smallest point numbers; the vertices are turned for it.
///
/// Regions follow: elements and faces become their pieces, points get the mid-edge nodes of the
/// region's elements and faces. A curve in space that is known by its points alone gets those of
/// the edges that have both ends in it.
///
/// Bodies that share points must have the same group size.
template <int D>
Mesh<D> refined_to_composites(Mesh<D> mesh, std::span<const int> group_size);

/// The composite of each element, numbered in the order of the elements; a simple element is one by
/// itself.
template <int D>
std::vector<Index> composite_of_elements(const Mesh<D>& mesh);

}  // namespace breccia
