// The resistance of a boundary that lets waves out, and the kick with it.
#include "point/absorbing.hpp"

#include "harness/tensors.hpp"

#include <gtest/gtest.h>

namespace breccia {
namespace {

// Normal and tangent parts by hand, for surfaces of every orientation; label eq:boundary-1.
template <int D>
void check_parts() {
  for (int i = 0; i < 20; ++i) {
    const Mat<D> q = random_rotation<D>(Random{7, 7}, static_cast<std::uint64_t>(i));
    Vec<D> n = Vec<D>::zero(), v = Vec<D>::zero();
    for (int d = 0; d < D; ++d) n[d] = q(d, 0), v[d] = q(d, 1) + 0.3 * q(d, 0) + 0.1 * d;
    const Vec<D> along = n * dot(n, v);
    const Vec<D> expected = (along * 5.0 + (v - along) * 3.0) * 2.0;
    EXPECT_LT(norm(absorbing_matrix(n, 2.0, 5.0, 3.0) * v - expected), 1e-14);
  }
}
TEST(Absorbing, ResistsNormalAndTangentPartsApart) {
  check_parts<2>();
  check_parts<3>();
}

// label eq:boundary-2
TEST(Absorbing, KickBalancesMomentumAndHoldsWhatIsHeld) {
  const Vec<3> n{{0.6, 0.8, 0}}, v{{1, -2, 3}}, f{{4, 5, -6}};
  const Sym<3> c = absorbing_matrix(n, 1.0, 7.0, 2.0);
  const double m = 2, h = 0.3;
  Vec<3> free = Vec<3>::zero();
  absorbing_kick(m, h, c, v, f, 0, free);
  const Vec<3> resistance = (c * (v + free)) * 0.5;
  EXPECT_LT(norm((free - v) * m - (f - resistance) * h), 1e-14);
  Vec<3> held{{0, 9, 0}};
  absorbing_kick(m, h, c, v, f, 2, held);
  EXPECT_DOUBLE_EQ(held[1], 9);
  const Vec<3> wall = (held - v) * m - (f - (c * (v + held)) * 0.5) * h;
  EXPECT_NEAR(wall[0], 0, 1e-13);
  EXPECT_NEAR(wall[2], 0, 1e-13);
}

// Explicit, the kick would grow beyond h C = 2 m.
TEST(Absorbing, KickNeverGrows) {
  for (const double h : {1e-3, 1.0, 1e3, 1e9}) {
    Vec<2> v{{1, 1}};
    const Sym<2> c = absorbing_matrix(Vec<2>{{0.6, 0.8}}, 1.0, 7.0, 2.0);
    Vec<2> next = Vec<2>::zero();
    absorbing_kick(1.0, h, c, v, Vec<2>::zero(), 0, next);
    EXPECT_LE(norm(next), norm(v)) << h;
  }
}

}  // namespace
}  // namespace breccia
