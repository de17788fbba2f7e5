#pragma once
#include "loops/node_motion.hpp"
#include "step/model.hpp"

namespace breccia {

/// The part of the motion loop's input that says which forces act on the nodes and what holds them;
/// its absorbers, resistance and step are left out.
template <int D>
NodeMotionIn<D> forces_on_nodes(const Model<D>& model);

extern template NodeMotionIn<2> forces_on_nodes(const Model<2>&);
extern template NodeMotionIn<3> forces_on_nodes(const Model<3>&);

}  // namespace breccia
