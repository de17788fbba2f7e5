// Factors of loads and motions over time.
#include "point/ramp.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace breccia {
namespace {

/// Rows (time, factor) as the kernels read them.
struct Table {
  std::vector<std::array<double, 2>> rows;
  double operator()(Index i, int j) const {
    return rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  }
};

const Table kNoTable{};

TEST(Ramp, NothingGivenIsFullFromTheStart) {
  const Ramp ramp{};
  for (const double t : {0.0, 1e-9, 1.0}) EXPECT_EQ(ramp.factor(t, kNoTable), 1.0);
}

TEST(Ramp, RisesSmoothlyFromZeroToOne) {
  const Ramp ramp{2.0, 0, 0};
  EXPECT_EQ(ramp.factor(-1, kNoTable), 0.0);
  EXPECT_EQ(ramp.factor(0, kNoTable), 0.0);
  EXPECT_DOUBLE_EQ(ramp.factor(0.5, kNoTable), 3.0 / 16 - 2.0 / 64);
  EXPECT_DOUBLE_EQ(ramp.factor(1, kNoTable), 0.5);
  EXPECT_EQ(ramp.factor(2, kNoTable), 1.0);
  EXPECT_EQ(ramp.factor(5, kNoTable), 1.0);
}

TEST(Ramp, HasNoKinkAtItsEnds) {
  const Ramp ramp{2.0, 0, 0};
  const double h = 1e-4;
  EXPECT_LT(ramp.factor(h, kNoTable) / h, 1e-3);  // slope 3 h / ramp^2 at the start
  EXPECT_LT((1 - ramp.factor(2 - h, kNoTable)) / h, 1e-3);
  // Odd about its middle: a load so ramped acts as one step at half the ramp's time.
  for (double s = 0; s <= 1; s += 0.125)
    EXPECT_NEAR(ramp.factor(1 + s, kNoTable) + ramp.factor(1 - s, kNoTable), 1, 1e-15);
}

TEST(Ramp, TableIsLinearBetweenRowsAndConstantBeyond) {
  const Table table{{{9, 9}, {1, 0}, {2, 4}, {4, -4}, {7, 7}}};
  const Ramp ramp{0, 1, 4};  // rows 1 to 3 belong to it
  EXPECT_EQ(ramp.factor(0, table), 0.0);
  EXPECT_EQ(ramp.factor(1, table), 0.0);
  EXPECT_DOUBLE_EQ(ramp.factor(1.25, table), 1.0);
  EXPECT_DOUBLE_EQ(ramp.factor(2, table), 4.0);
  EXPECT_DOUBLE_EQ(ramp.factor(3, table), 0.0);
  EXPECT_DOUBLE_EQ(ramp.factor(4, table), -4.0);
  EXPECT_DOUBLE_EQ(ramp.factor(9, table), -4.0);
}

}  // namespace
}  // namespace breccia
