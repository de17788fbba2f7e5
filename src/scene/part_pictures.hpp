#pragma once
#include "scene/simulation.hpp"

namespace breccia {

/// What modules draw of their last forces, put together from all ranks at rank 0, where `whole` has
/// the nodes that it is for. Collective.
template <int D>
void draw_parts(Simulation<D>& local, Simulation<D>* whole, Picture& picture);

extern template void draw_parts(Simulation<2>&, Simulation<2>*, Picture&);
extern template void draw_parts(Simulation<3>&, Simulation<3>*, Picture&);

}  // namespace breccia
