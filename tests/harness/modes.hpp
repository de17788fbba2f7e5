#pragma once
#include "harness/scenes.hpp"

namespace breccia {

/// Largest rate (rad/s) of the body as it is now, free or held: the eigenvalues of its own nodal
/// forces, differentiated numerically. For meshes of some dozens of nodes.
template <int D>
double largest_rate(SceneWorld<D>& world);

extern template double largest_rate<2>(SceneWorld<2>&);
extern template double largest_rate<3>(SceneWorld<3>&);

}  // namespace breccia
