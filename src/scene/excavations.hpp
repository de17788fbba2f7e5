#pragma once
#include "core/settings.hpp"
#include "mesh/mesh.hpp"

#include <vector>

namespace breccia {

/// Which [[excavate]] of the scene takes each element of the mesh out, kNone for those that stay.
/// Throws Error where two take the same element, one takes none, or nothing would stay.
template <int D>
std::vector<Index> excavation_of_elements(const Settings& scene, const Mesh<D>& mesh);

}  // namespace breccia
