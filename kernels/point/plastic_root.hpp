#pragma once
#include <Kokkos_Core.hpp>

namespace breccia {

/// Value and derivative of a residual.
struct Residual {
  double value, slope;
};

/// Root of a residual that is above 0 at `low` and not above 0 at `high`: Newton's method, halving
/// the bracket where that would leave it or is slow. At most 80 evaluations; the root is found to
/// round-off.
template <class F>
KOKKOS_INLINE_FUNCTION
double bracketed_root(const F& residual, double low, double high) {
  double x = 0.5 * (low + high), last = high - low;
  for (int i = 0; i < 80; ++i) {
    const Residual r = residual(x);
    if (r.value > 0) {
      low = x;
    } else {
      high = x;
    }
    const double step = r.slope < 0 ? -r.value / r.slope : 2 * last;
    double next = x + step;
    if (!(next > low && next < high) || Kokkos::abs(step) > 0.5 * last) next = 0.5 * (low + high);
    last = Kokkos::abs(next - x);
    if (next == x || last <= 1e-16 * high) break;
    x = next;
  }
  return x;
}

}  // namespace breccia
