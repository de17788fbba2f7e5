#pragma once

#include "study/plan.hpp"

namespace breccia {

/// Has tools/plot draw study.png where it is found (beside the executable's folders, or as
/// BRECCIA_PLOT says); otherwise prints the command that draws it.
void draw_picture(const Study& study);

}  // namespace breccia
