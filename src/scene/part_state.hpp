#pragma once
#include "scene/simulation.hpp"

namespace breccia {

/// Gives a simulation of one rank the state of the whole scene, as far as its part goes, and
/// resumes it.
template <int D>
void take_state(Simulation<D>& whole, Simulation<D>& local);

/// Puts the state of the whole scene together in an order that does not depend on the number of
/// ranks: at rank 0, or everywhere; `whole` is not used elsewhere. Collective.
template <int D>
void collect_state(Simulation<D>& local, Simulation<D>* whole, bool everywhere = false);

extern template void take_state(Simulation<2>&, Simulation<2>&);
extern template void take_state(Simulation<3>&, Simulation<3>&);
extern template void collect_state(Simulation<2>&, Simulation<2>*, bool);
extern template void collect_state(Simulation<3>&, Simulation<3>*, bool);

}  // namespace breccia
