#pragma once
#include "loops/interface_force.hpp"

namespace breccia {

template <int D>
struct FaultForceOut {
  FaultStates<D> fault;
  CornerStates<D> state;  ///< gets the slip that contact goes on with
  CornerEnergies<D> energy;
  PairForces<D> force;       ///< N on the left corner; the right one gets the opposite
  Array<std::uint8_t> life;  ///< interface_life
  CornerRubbed<D> rubbed;    ///< slip rate and theta where contact asks for them; else empty
};

/// Tractions of faults at their corners, each with 1/D of the reference area. A pair of faces acts
/// on itself until its sides have slid past each other by a face, or by half a face where contact
/// follows; returns how many leave.
template <int D>
Index fault_force(const InterfaceForceIn<D>& in, const FrictionLaw& friction,
                  const FaultForceOut<D>& out);

extern template Index fault_force<2>(const InterfaceForceIn<2>&, const FrictionLaw&,
                                     const FaultForceOut<2>&);
extern template Index fault_force<3>(const InterfaceForceIn<3>&, const FrictionLaw&,
                                     const FaultForceOut<3>&);

}  // namespace breccia
