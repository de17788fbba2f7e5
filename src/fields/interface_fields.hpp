#pragma once
#include "fields/field.hpp"

namespace breccia {

// Fields of inserted faces that other modules read, in plain numbers.

struct FaceInterface {
  using View = Array<Index>;
  static constexpr FieldInfo info{"face_interface", Entity::face, "1", Restart::yes,
                                  "interface that the face became, or -1"};
};

/// Elastic slip of the right side against the left at the corners of the left element's face, in
/// global components. Written in the step of release, where contact takes the face over: its
/// friction goes on from there (ALGORITHMS ).
template <int D>
struct InterfaceSlip {
  using View = Kokkos::View<double* [D][D], Rows, Memory>;
  static constexpr FieldInfo info{"interface_slip", Entity::interface, "m", Restart::yes,
                                  "elastic slip at release, per corner"};
};

/// What else the laws of friction of contact go on with there.
template <int D>
struct InterfaceRubbed {
  using View = Kokkos::View<double* [D][3], Rows, Memory>;
  static constexpr FieldInfo info{"interface_rubbed", Entity::interface, "SI", Restart::yes,
                                  "slip so far, slip rate and theta at release, per corner"};
};

}  // namespace breccia
