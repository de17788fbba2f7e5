#pragma once
#include "modules/fracture/interface_lists.hpp"
#include "step/observation.hpp"

#include <vector>

namespace breccia {

/// Events of the interfaces changed(0) ... changed(count - 1) at their present places, in that
/// order.
template <int D>
std::vector<Event> break_events(const Model<D>& model, const Array<Index>& changed, Index count,
                                double time);

/// Mid-surfaces of all interfaces that can open, with what happened to them.
template <int D>
std::vector<CrackFace> crack_faces(const Model<D>& model);

}  // namespace breccia
