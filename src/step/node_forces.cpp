#include "step/node_forces.hpp"

#include "fields/rigid_fields.hpp"

namespace breccia {

template <int D>
AnyCornerForces<D> element_forces(const Store& store) {
  return {store.get_or_empty<ElementForce<D>>(), store.get_or_empty<ElementForceSingle<D>>()};
}

template <int D>
NodeMotionIn<D> forces_on_nodes(const Model<D>& model) {
  const Store& s = model.store;
  NodeMotionIn<D> in;
  in.corners = s.get<NodeCorners>();
  in.corner_list = s.get<CornerList>();
  in.element_force = element_forces<D>(s);
  in.extra[0] = s.get_or_empty<InterfaceForce<D>>();
  in.extra[1] = s.get_or_empty<ContactForce<D>>();
  in.extra[2] = s.get_or_empty<LoadForce<D>>();
  in.extra_bit[0] = s.has<InterfaceForce<D>>() ? node_flag::interface : 0;
  in.extra_bit[1] = s.has<ContactForce<D>>() ? node_flag::contact : 0;
  in.extra_bit[2] = s.has<LoadForce<D>>() ? node_flag::load : 0;
  in.flags = s.get<NodeFlags>();
  in.mass = s.get<NodeMass>();
  in.added_mass = s.get_or_empty<NodeAddedMass>();
  in.gravity = model.gravity;
  in.boundary_velocity = s.get_or_empty<BoundaryVelocity<D>>();
  in.fixed_bits = node_flag::fixed_any;
  in.boundary_shift = node_flag::boundary_shift;
  if (s.has<RigidChange<D>>()) {
    in.rigid_bit = node_flag::rigid;
    in.rigid_velocity = s.get<RigidVelocity<D>>();
    in.rigid_origin = s.get<RigidOrigin<D>>();
    in.rigid_change = s.get<RigidChange<D>>();
    in.reference = s.get<NodeReference<D>>();
  }
  return in;
}

template AnyCornerForces<2> element_forces(const Store&);
template AnyCornerForces<3> element_forces(const Store&);
template NodeMotionIn<2> forces_on_nodes(const Model<2>&);
template NodeMotionIn<3> forces_on_nodes(const Model<3>&);

}  // namespace breccia
