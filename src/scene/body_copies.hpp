#pragma once
#include "core/settings.hpp"
#include "mesh/copies.hpp"

namespace breccia {

/// Copies the bodies whose sections say so ([body.copies]).
template <int D>
void make_copies(const Settings& scene, Mesh<D>& mesh);

}  // namespace breccia
