#pragma once

#include "mesh/mesh.hpp"

#include <string>

namespace breccia {

/// Refuses a mesh that cannot be computed with: non-finite coordinates, point numbers out of range,
/// elements with a repeated point, zero size, inverted orientation, duplicate elements, coincident
/// points of one body, points that no element uses, faces with more than two elements, bodies
/// without elements, regions that name missing entities. Numbers in messages count from 0 as in our
/// own files; `source` (file or body) names the place. Throws Error naming the first few offenders
/// and the remedy.
template <int D>
void validate(const Mesh<D>& mesh, const std::string& source);

/// Clockwise meshes: when every element is negatively oriented, swaps two points of each and
/// returns true. A mesh with both orientations is left as it is (validate then refuses it).
template <int D>
bool orient_if_all_mirrored(Mesh<D>& mesh);

}  // namespace breccia
