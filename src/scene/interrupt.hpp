#pragma once

namespace breccia {

/// Turns Ctrl-C and SIGTERM into a request that the run loop answers at the end of a step.
void watch_for_interrupt();
bool interrupted();

}  // namespace breccia
