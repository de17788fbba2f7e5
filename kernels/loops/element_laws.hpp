#pragma once
#include "loops/element_force.hpp"
#include "point/anisotropic.hpp"
#include "point/eos.hpp"
#include "point/plastic_laws.hpp"

namespace breccia {

/// Where the history of an element's equation of state stands, after that of its strength.
namespace eos_place {
inline constexpr int energy = 4, pressure = 5, distension = 6, density = 7;
}  // namespace eos_place

/// What inelastic elements remember, and what of the block their response needs.
template <int D>
struct InelasticState {
  FullTensors<D> elastic;  ///< G, inverse plastic metric
  Kokkos::View<double* [8], Columns, Memory> history;
  bool has_eos = false;
  Eos eos;
};

/// What anisotropic elements need besides their shapes.
template <int D>
struct AnisotropicState {
  Anisotropic law;         ///< in plane stress reduced to it
  double modulus;          ///< largest rho c^2 of all directions, Pa
  FullTensors<D> initial;  ///< elastic strain at the start, in material axes; may be empty
};

/// element_force for materials that yield, have an equation of state or begin under stress.
template <int D>
void inelastic_force(const ElementForceIn<D>& in, const ElementForceOut<D>& out,
                     const PlasticLaw& law, const InelasticState<D>& state);

/// element_force for elasticity along material axes.
template <int D>
void anisotropic_force(const ElementForceIn<D>& in, const ElementForceOut<D>& out,
                       const AnisotropicState<D>& state);

template <int D>
void anisotropic_force_single(const ElementForceIn<D>& in, const ElementForceOut<D>& out,
                              const AnisotropicState<D>& state);

extern template void inelastic_force(const ElementForceIn<2>&, const ElementForceOut<2>&,
                                     const PlasticLaw&, const InelasticState<2>&);
extern template void inelastic_force(const ElementForceIn<3>&, const ElementForceOut<3>&,
                                     const PlasticLaw&, const InelasticState<3>&);
extern template void anisotropic_force(const ElementForceIn<2>&, const ElementForceOut<2>&,
                                       const AnisotropicState<2>&);
extern template void anisotropic_force(const ElementForceIn<3>&, const ElementForceOut<3>&,
                                       const AnisotropicState<3>&);

extern template void anisotropic_force_single(const ElementForceIn<2>&, const ElementForceOut<2>&,
                                              const AnisotropicState<2>&);
extern template void anisotropic_force_single(const ElementForceIn<3>&, const ElementForceOut<3>&,
                                              const AnisotropicState<3>&);

}  // namespace breccia
