#pragma once
#include <Kokkos_Core.hpp>

namespace breccia {

// How an interface loses its strength.
//
// symbols  D [1] damage, 0 intact ... 1 broken   S [1] share of the strength that is left
//          c_S [1] integral of S from 0 to 1     steepest = max |dS/dD|
// page     docs/modules/fracture.md

/// eq:cohesive-1  S = 1 - D, c_S = 1/2
struct LinearSoftening {
  static constexpr double area = 0.5;
  static constexpr double steepest = 1;
  KOKKOS_FUNCTION
  static double left(double damage) { return 1 - damage; }
};

/// eq:cohesive-2  S = z(D) = (1 - (a+b-1)/(a+b) exp(D (a+bc)/((a+b)(1-a-b)))) (a(1-D) + b(1-D)^c)
///
/// source  Munjiza, Andrews and White 1999, doi:10.1002/(SICI)1097-0207(19990110)44:1<41, a fit to
///         the tensile tests on concrete of Evans and Marathe; c_S by quadrature, A-3.5
struct ZCurve {
  static constexpr double a = 0.63, b = 1.8, c = 6;
  static constexpr double area = 0.3863072947439407;
  static constexpr double steepest = 2.0402;
  KOKKOS_FUNCTION
  static double left(double damage) {
    constexpr double sum = a + b;
    constexpr double rate = (a + b * c) / (sum * (1 - sum));
    const double r = 1 - damage, r2 = r * r;  // c = 6 is spelt out below
    return (1 - (sum - 1) / sum * Kokkos::exp(rate * damage)) * (a * r + b * r2 * r2 * r2);
  }
};

}  // namespace breccia
