#include "loops/element_inelastic.hpp"

namespace breccia {

template void inelastic_groups<3, 12>(const ElementForceIn<3>&, const ElementForceOut<3>&,
                                      const PlasticLaw&, const InelasticState<3>&);

}  // namespace breccia
