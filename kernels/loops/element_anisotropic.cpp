#include "loops/element_response.hpp"

namespace breccia {

template <int D>
void anisotropic_force(const ElementForceIn<D>& in, const ElementForceOut<D>& out,
                       const AnisotropicState<D>& state) {
  launch_groups(in, out, AnisotropicResponse<D>{state, in.flat, in.thickness / kFactorial<D>});
}

template void anisotropic_force(const ElementForceIn<2>&, const ElementForceOut<2>&,
                                const AnisotropicState<2>&);
template void anisotropic_force(const ElementForceIn<3>&, const ElementForceOut<3>&,
                                const AnisotropicState<3>&);

}  // namespace breccia
