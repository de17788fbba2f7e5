#include "scene/interrupt.hpp"

#include <csignal>

namespace breccia {

namespace {
volatile std::sig_atomic_t requested = 0;
void request(int) {
  requested = 1;
}
}  // namespace

void watch_for_interrupt() {
  requested = 0;
  std::signal(SIGINT, request);
  std::signal(SIGTERM, request);
}

bool interrupted() {
  return requested != 0;
}

}  // namespace breccia
