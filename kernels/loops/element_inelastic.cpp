#include "loops/element_inelastic.hpp"

namespace breccia {

template <int D>
void inelastic_force(const ElementForceIn<D>& in, const ElementForceOut<D>& out,
                     const PlasticLaw& law, const InelasticState<D>& state) {
  if (in.end <= in.begin) return;
  if (in.group == 1) {
    inelastic_groups<D, 1>(in, out, law, state);
  } else if constexpr (D == 2) {
    inelastic_groups<2, 4>(in, out, law, state);
  } else if (in.group == 8) {
    inelastic_groups<3, 8>(in, out, law, state);
  } else {
    inelastic_groups<3, 12>(in, out, law, state);
  }
}

template void inelastic_force(const ElementForceIn<2>&, const ElementForceOut<2>&,
                              const PlasticLaw&, const InelasticState<2>&);
template void inelastic_force(const ElementForceIn<3>&, const ElementForceOut<3>&,
                              const PlasticLaw&, const InelasticState<3>&);

}  // namespace breccia
