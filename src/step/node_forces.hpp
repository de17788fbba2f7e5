#pragma once
#include "loops/node_motion.hpp"
#include "step/model.hpp"

namespace breccia {

/// Forces of elements on their corners, in the precision of the run.
template <int D>
AnyCornerForces<D> element_forces(const Store& store);

/// The part of the motion loop's input that says which forces act on the nodes and what holds them;
/// its absorbers, resistance and step are left out.
template <int D>
NodeMotionIn<D> forces_on_nodes(const Model<D>& model);

extern template AnyCornerForces<2> element_forces(const Store&);
extern template AnyCornerForces<3> element_forces(const Store&);
extern template NodeMotionIn<2> forces_on_nodes(const Model<2>&);
extern template NodeMotionIn<3> forces_on_nodes(const Model<3>&);

}  // namespace breccia
