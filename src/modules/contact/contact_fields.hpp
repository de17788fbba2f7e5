#pragma once
#include "fields/field.hpp"
#include "loops/contact_history.hpp"

namespace breccia {

struct ContactPoint {
  using View = Array<Index>;
  static constexpr FieldInfo info{"contact_point", Entity::contact_point, "1", Restart::yes,
                                  "point: (element, local face, place on it), packed; ascending"};
};

struct ContactElement {
  using View = Kokkos::View<Index* [kContactSlots], Rows, Memory>;
  static constexpr FieldInfo info{"contact_element", Entity::contact_point, "1", Restart::yes,
                                  "element that the point was last in, per remembered piece"};
};

template <int D>
struct ContactMemory {
  using View = Kokkos::View<double* [kContactSlots][ContactHistory<D>::kNumbers], Rows, Memory>;
  static constexpr FieldInfo info{"contact_memory", Entity::contact_point, "SI", Restart::yes,
                                  "depth, jump, energy, elastic slip, force and its viscous part"};
};

struct ContactRubbed {
  using View = Kokkos::View<double* [kContactSlots][3], Rows, Memory>;
  static constexpr FieldInfo info{"contact_rubbed", Entity::contact_point, "SI", Restart::yes,
                                  "slip so far, slip rate and theta of the law of friction"};
};

}  // namespace breccia
