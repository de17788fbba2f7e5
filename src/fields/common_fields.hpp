#pragma once
#include "fields/field.hpp"

#include <cstdint>

namespace breccia {

// Fields that more than one module reads. A field type names its view and describes itself.

template <int D>
struct NodePosition {
  using View = Vectors<D>;
  static constexpr FieldInfo info{"node_position", Entity::node, "m", Restart::yes,
                                  "current position x^n"};
};

template <int D>
struct NodeVelocity {
  using View = Vectors<D>;
  static constexpr FieldInfo info{"node_velocity", Entity::node, "m/s", Restart::yes,
                                  "velocity v^(n-1/2), half a step behind the positions"};
};

template <int D>
struct NodeReference {
  using View = Vectors<D>;
  static constexpr FieldInfo info{"node_reference", Entity::node, "m", Restart::yes,
                                  "position in the reference configuration"};
};

struct NodeMass {
  using View = Array<double>;
  static constexpr FieldInfo info{"node_mass", Entity::node, "kg", Restart::yes,
                                  "sum of the masses of its corners"};
};

/// What mass scaling has added to node_mass; gravity does not act on it.
struct NodeAddedMass {
  using View = Array<double>;
  static constexpr FieldInfo info{"node_added_mass", Entity::node, "kg", Restart::yes,
                                  "share of node_mass that mass scaling has added"};
};

struct NodeFamily {
  using View = Array<Index>;
  static constexpr FieldInfo info{"node_family", Entity::node, "1", Restart::yes,
                                  "original mesh node that this node is a copy of"};
};

/// Bits of a node that the motion loop looks at.
namespace node_flag {
inline constexpr std::uint32_t fixed_x = 1, fixed_y = 2, fixed_z = 4;  // component d: fixed_x << d
inline constexpr std::uint32_t fixed_any = 7;
inline constexpr std::uint32_t interface = 8;  // has interface corner forces
inline constexpr std::uint32_t contact = 16;   // may have contact corner forces
inline constexpr std::uint32_t load = 32;      // has surface loads
inline constexpr std::uint32_t absorb = 64;    // lies on a boundary that lets waves out
inline constexpr std::uint32_t rigid = 128;    // moves with its body, in all components
inline constexpr int boundary_shift = 16;      // number of the prescribed motion, or of the rigid
                                               // body, in the high bits
}  // namespace node_flag

struct NodeFlags {
  using View = Array<std::uint32_t>;
  static constexpr FieldInfo info{"node_flags", Entity::node, "1", Restart::yes,
                                  "prescribed components, force classes present, boundary"};
};

/// Corners of node n are corner_list[begin(n)] ... corner_list[end(n) - 1], ascending. A corner
/// is element * (D + 1) + local node. The corners of a family are one fixed stretch of the
/// list; splitting only re-sorts the stretch (ALGORITHMS ).
struct NodeCorners {
  using View = Ranges;
  static constexpr FieldInfo info{"node_corners", Entity::node, "1", Restart::yes,
                                  "begin and end of the node's corners in the corner list"};
};

struct CornerList {
  using View = Array<Index>;
  static constexpr FieldInfo info{"corner_list", Entity::corner, "1", Restart::yes,
                                  "corners sorted by family, then node, then corner"};
};

/// Stretch of the corner list that belongs to a family; never changes.
struct FamilyCorners {
  using View = Ranges;
  static constexpr FieldInfo info{"family_corners", Entity::family, "1", Restart::no,
                                  "begin and end of the family's corners in the corner list"};
};

template <int D>
struct ElementNodes {
  using View = Connectivity<D>;
  static constexpr FieldInfo info{"element_nodes", Entity::element, "1", Restart::yes,
                                  "node (copy) at each corner"};
};

template <int D>
struct ElementFamilies {
  using View = Connectivity<D>;
  static constexpr FieldInfo info{"element_families", Entity::element, "1", Restart::no,
                                  "original mesh node at each corner"};
};

/// Inverse of the reference edge matrix [X1 - X0, ...]; unit 1/m.
template <int D>
struct ElementReference {
  using View = Matrices<D>;
  static constexpr FieldInfo info{"element_reference", Entity::element, "1/m", Restart::no,
                                  "inverse of the reference edge matrix"};
};

/// Share of its stress and mass that an element still has: 1, falling to 0 while it is excavated.
struct ElementShare {
  using View = Array<double>;
  static constexpr FieldInfo info{"element_share", Entity::element, "1", Restart::yes,
                                  "share of its stress and mass that is left"};
};

struct ElementBody {
  using View = Array<Index>;
  static constexpr FieldInfo info{"element_body", Entity::element, "1", Restart::no,
                                  "number of the body"};
};

struct ElementMaterial {
  using View = Array<Index>;
  static constexpr FieldInfo info{"element_material", Entity::element, "1", Restart::no,
                                  "number of the material"};
};

/// Lame constants lambda (that of plane stress in that case) and mu of each material.
struct MaterialLame {
  using View = Vectors<2>;
  static constexpr FieldInfo info{"material_lame", Entity::material, "Pa", Restart::no,
                                  "Lame constants lambda and mu"};
};

/// A bit of each element, raised where the stress may reach a face's insertion threshold on some
/// plane (prefilter of the insertion check, which lowers it; an upper bound, see
/// point/stress_watch.hpp).
struct ElementHot {
  using View = Array<BitWord>;
  static constexpr FieldInfo info{"element_hot", Entity::element_word, "1", Restart::no,
                                  "stress may reach an interface's threshold on some plane"};
};

// Forces on element corners, one array per class; sums over a node's corners are nodal forces.
// Booked on corners so that a splitting node can sort them (ALGORITHMS ).
template <int D>
struct ElementForce {
  using View = CornerForces<D>;
  static constexpr FieldInfo info{"element_force", Entity::element, "N", Restart::no,
                                  "internal forces of the element on its corners"};
};

/// The same field of a run in mixed precision, which has this one instead.
template <int D>
struct ElementForceSingle {
  using View = CornerForcesSingle<D>;
  static constexpr FieldInfo info = ElementForce<D>::info;
};

template <int D>
struct InterfaceForce {
  using View = CornerForces<D>;
  static constexpr FieldInfo info{"interface_force", Entity::element, "N", Restart::no,
                                  "forces of inserted interfaces, booked on element corners"};
};

template <int D>
struct ContactForce {
  using View = CornerForces<D>;
  static constexpr FieldInfo info{"contact_force", Entity::element, "N", Restart::no,
                                  "contact forces, booked on element corners"};
};

template <int D>
struct LoadForce {
  using View = CornerForces<D>;
  static constexpr FieldInfo info{"load_force", Entity::element, "N", Restart::no,
                                  "tractions and pressures, booked on element corners"};
};

/// Life of a face between two elements.
namespace face_status {
inline constexpr std::uint8_t bonded = 0, inserted = 1, released = 2;
/// A bonded face that can never break: no fracture law joins its two materials.
inline constexpr std::uint8_t tied = 3;
/// Joins nothing any more: one of its elements is excavated.
inline constexpr std::uint8_t cut = 4;
}  // namespace face_status

struct FaceStatus {
  using View = Array<std::uint8_t>;
  static constexpr FieldInfo info{"face_status", Entity::face, "1", Restart::yes,
                                  "0 bonded, 1 inserted, 2 released, 3 tied for ever, 4 cut"};
};

/// Elements on the left and right of a face between two elements, left < right.
struct FaceElements {
  using View = Ranges;
  static constexpr FieldInfo info{"face_elements", Entity::face, "1", Restart::no,
                                  "left and right element"};
};

/// Packed: left local face | right local face << 2 | rotation << 4 (mesh/topology.hpp).
struct FaceCode {
  using View = Array<std::uint8_t>;
  static constexpr FieldInfo info{"face_code", Entity::face, "1", Restart::no,
                                  "local faces and rotation, packed"};
};

KOKKOS_INLINE_FUNCTION
constexpr int left_face(std::uint8_t code) {
  return code & 3;
}
KOKKOS_INLINE_FUNCTION
constexpr int right_face(std::uint8_t code) {
  return (code >> 2) & 3;
}
KOKKOS_INLINE_FUNCTION
constexpr int rotation(std::uint8_t code) {
  return code >> 4;
}

/// Number of the shared face at each local face of an element, kNone at free faces.
template <int D>
struct ElementFaces {
  using View = Connectivity<D>;
  static constexpr FieldInfo info{"element_faces", Entity::element, "1", Restart::no,
                                  "shared face at each local face, or none"};
};

/// Prescribed velocity of each boundary at t^(n+1/2).
template <int D>
struct BoundaryVelocity {
  using View = Vectors<D>;
  static constexpr FieldInfo info{"boundary_velocity", Entity::boundary, "m/s", Restart::no,
                                  "prescribed velocity at the middle of the step"};
};

/// Row of absorber_damping of the elements on a boundary that lets waves out, none elsewhere.
struct ElementAbsorber {
  using View = Array<Index>;
  static constexpr FieldInfo info{"element_absorber", Entity::element, "1", Restart::no,
                                  "row of the element's absorber_damping, or none"};
};

/// Resistance at each corner of such an element, the components of Sym<D>: force = -C v.
template <int D>
struct AbsorberDamping {
  using View = CornerMatrices<D>;
  static constexpr FieldInfo info{"absorber_damping", Entity::absorber, "kg/s", Restart::no,
                                  "resistance of the boundary at each corner of the element"};
};

/// Force that holds a prescribed node on its way; zero in free components.
template <int D>
struct NodeReaction {
  using View = Vectors<D>;
  static constexpr FieldInfo info{"node_reaction", Entity::node, "N", Restart::no,
                                  "force of the prescribed motion on the node"};
};

/// Stiffness of springs (interfaces, contact) at a node; the time step looks at it.
struct NodeStiffness {
  using View = Array<double>;
  static constexpr FieldInfo info{"node_stiffness", Entity::node, "N/m", Restart::no,
                                  "sum of the spring stiffnesses that act at the node"};
};

}  // namespace breccia
