#include "point/eos.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace breccia;

Eos copper() {
  Eos eos;
  eos.kind = EosKind::mie_gruneisen;
  eos.rho0 = 8930;
  eos.mie_gruneisen = {8930, 3940, 1.489, 1.99, 1e300};
  eos.modulus0 = 8930 * 3940.0 * 3940.0;
  return eos;
}

// On its Hugoniot the law gives back p = rho0 (c0 + s u) u, whatever Gamma is.
TEST(Eos, MieGruneisenKeepsItsHugoniot) {
  const Eos eos = copper();
  for (const double u : {100.0, 500.0, 1000.0, 2000.0}) {
    const double shock = 3940 + 1.489 * u;
    const double rho = 8930 * shock / (shock - u), p = 8930 * shock * u;
    EXPECT_NEAR(eos.pressure(rho, 0.5 * u * u), p, 1e-12 * p) << u;
  }
  EXPECT_EQ(eos.pressure(8930, 0), 0);
  EXPECT_NEAR(eos.bulk_modulus(8930, 0), eos.modulus0, 1e-12 * eos.modulus0);
}

}  // namespace
