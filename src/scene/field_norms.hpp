#pragma once
#include "scene/simulation.hpp"
#include "scene/verdict.hpp"

namespace breccia {

/// Norms of fields ([[norm]]) now: "norm.NAME", the root of the mean square over the volume of the
/// difference to `exact`, and "norm.NAME.share", that over the same of `exact`. Places and volumes
/// are those before anything moved; integrals have degree 2 in each element.
/// \throws Error where a field, body or formula is not what the scene has.
template <int D>
Numbers field_norms(Simulation<D>& simulation);

extern template Numbers field_norms<2>(Simulation<2>&);
extern template Numbers field_norms<3>(Simulation<3>&);

}  // namespace breccia
