#pragma once
#include "fields/field.hpp"

namespace breccia {

// Fields of elements that are not simply hyperelastic. Symmetric tensors of space are in the order
// xx, yy, xy, zz in the plane and xx, yy, zz, yz, xz, xy in space.

/// Cauchy stress without its viscous part, written by the element loop for other readers.
template <int D>
struct ElementCauchy {
  using View = FullTensors<D>;
  static constexpr FieldInfo info{"element_cauchy", Entity::element, "Pa", Restart::yes,
                                  "Cauchy stress at t^n"};
};

/// What is left of the deformation when it is undone elastically (point/inelastic.hpp): the inverse
/// of the plastic metric Cp in material axes, with elastic left Cauchy-Green B = F G F^T. It holds
/// plastic flow and initial stress alike; the identity where there is neither. Anisotropic elements
/// keep their initial elastic strain here instead.
template <int D>
struct ElementElastic {
  using View = FullTensors<D>;
  static constexpr FieldInfo info{"element_elastic", Entity::element, "1", Restart::yes,
                                  "inverse plastic metric, or initial elastic strain"};
};

/// Numbers that laws remember per element: those of the strength first, then those of the equation
/// of state.
struct ElementHistory {
  using View = Kokkos::View<double* [8], Columns, Memory>;
  static constexpr FieldInfo info{"element_history", Entity::element, "1", Restart::yes,
                                  "history of strength (4) and of the equation of state (4)"};
};

/// P-wave modulus (times J) that the time step uses where an equation of state makes it change;
/// zero where it is that of the material.
struct ElementModulus {
  using View = Array<double>;
  static constexpr FieldInfo info{"element_modulus", Entity::element, "Pa", Restart::yes,
                                  "P-wave modulus now, for the time step"};
};

}  // namespace breccia
