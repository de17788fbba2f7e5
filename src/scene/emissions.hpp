#pragma once
#include "io/csv.hpp"

#include <vector>

namespace breccia {

/// What counts as one acoustic emission: breaks within `reach` [m] of each other that follow within
/// `pause` [s], the time that a crack at half the speed of shear waves needs (Hazzard and Young
/// 2000, doi:10.1016/S1365-1609(00)00011-9), and all that hang together so.
struct EmissionRule {
  double reach, pause;
};

/// Emissions in the order of their first breaks. `events` in the order of time. Moments are added
/// up; magnitude 2/3 log10(moment / N m) - 6.03 (Hanks and Kanamori 1979,
/// doi:10.1029/JB084iB05p02348).
std::vector<EmissionRow> find_emissions(const std::vector<CrackEvent>& events,
                                        const EmissionRule& rule);

}  // namespace breccia
