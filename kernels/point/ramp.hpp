#pragma once
#include "base/index.hpp"

#include <Kokkos_Core.hpp>

namespace breccia {

/// Factor of a load or motion over time: a smooth rise to one within `ramp`, times a piecewise
/// linear table that is constant beyond its ends.
///
// symbols  t [s] time   s [1] = t / ramp   factor = s^2 (3 - 2 s), C1 at both ends
// source   ALGORITHMS
struct Ramp {
  double ramp = 0;           ///< s; 0: full from the start
  Index begin = 0, end = 0;  ///< rows of the table; equal: no table

  template <class Table>
  KOKKOS_FUNCTION
  double factor(double t, const Table& table) const { return smooth(t) * tabulated(t, table); }

 private:
  KOKKOS_FUNCTION
  double smooth(double t) const {
    if (t >= ramp) return 1;
    if (t <= 0) return 0;
    const double s = t / ramp;
    return s * s * (3 - 2 * s);
  }

  template <class Table>
  KOKKOS_FUNCTION
  double tabulated(double t, const Table& table) const {
    if (begin == end) return 1;
    if (t <= table(begin, 0)) return table(begin, 1);
    for (Index i = begin + 1; i < end; ++i)
      if (t < table(i, 0)) {
        const double s = (t - table(i - 1, 0)) / (table(i, 0) - table(i - 1, 0));
        return table(i - 1, 1) + s * (table(i, 1) - table(i - 1, 1));
      }
    return table(end - 1, 1);
  }
};

}  // namespace breccia
