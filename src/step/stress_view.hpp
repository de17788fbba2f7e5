#pragma once
#include "fields/solid_fields.hpp"
#include "loops/element_stress.hpp"
#include "step/model.hpp"

namespace breccia {

/// Stresses, strains and volumes of single elements, for whoever asks for them.
template <int D>
ElementStress<D> stress_of(const Model<D>& model) {
  const Store& s = model.store;
  return {s.get<ElementNodes<D>>(),       s.get<NodePosition<D>>(),
          s.get<ElementReference<D>>(),   s.get<ElementMaterial>(),
          s.get<MaterialLame>(),          model.thickness,
          D == 2 && model.plane_stress,   s.get_or_empty<ElementCauchy<D>>(),
          s.get_or_empty<ElementShare>(), model.part.own};
}

/// A stress as scenes give it: [xx, yy, zz, xy] or [xx, yy, zz, xy, yz, xz].
inline Sym<3> stress_of(const std::vector<double>& given) {
  Sym<3> s = Sym<3>::zero();
  for (int i = 0; i < 3; ++i) s(i, i) = given[static_cast<std::size_t>(i)];
  s(0, 1) = given[3];
  if (given.size() < 6) return s;
  s(1, 2) = given[4];
  s(0, 2) = given[5];
  return s;
}

}  // namespace breccia
