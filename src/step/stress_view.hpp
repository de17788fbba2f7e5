#pragma once
#include "fields/solid_fields.hpp"
#include "loops/element_stress.hpp"
#include "step/model.hpp"

namespace breccia {

/// Stresses, strains and volumes of single elements, for whoever asks for them.
template <int D>
ElementStress<D> stress_of(const Model<D>& model) {
  const Store& s = model.store;
  return {s.get<ElementNodes<D>>(),      s.get<NodePosition<D>>(),
          s.get<ElementReference<D>>(),  s.get<ElementMaterial>(),
          s.get<MaterialLame>(),         model.thickness,
          D == 2 && model.plane_stress,  s.get_or_empty<ElementCauchy<D>>(),
          s.get_or_empty<ElementShare>()};
}

}  // namespace breccia
