#include "loops/element_inelastic.hpp"

namespace breccia {

template void inelastic_groups<2, 4>(const ElementForceIn<2>&, const ElementForceOut<2>&,
                                     const PlasticLaw&, const InelasticState<2>&);

}  // namespace breccia
