#include "core/error.hpp"
#include "core/log.hpp"
#include "core/random.hpp"
#include "core/text.hpp"
#include "harness/failures.hpp"

#include <cmath>

namespace breccia {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

TEST(CoreText, EditDistanceCountsTheFourMistakes) {
  EXPECT_EQ(edit_distance("young", "young"), 0);
  EXPECT_EQ(edit_distance("yung", "young"), 1);    // left out
  EXPECT_EQ(edit_distance("youngg", "young"), 1);  // too many
  EXPECT_EQ(edit_distance("yoang", "young"), 1);   // changed
  EXPECT_EQ(edit_distance("yuong", "young"), 1);   // swapped
  EXPECT_EQ(edit_distance("", "abc"), 3);
}

TEST(CoreText, NearestFindsWhatWasMeantAndNothingElse) {
  const std::vector<std::string> known{"density", "damping", "tensile_strength"};
  EXPECT_EQ(nearest("tensile_strenght", known), "tensile_strength");
  EXPECT_EQ(nearest("densty", known), "density");
  EXPECT_EQ(nearest("tens", known), "tensile_strength");  // an abbreviation
  EXPECT_EQ(nearest("density_of_rock", known), "density");
  EXPECT_EQ(nearest("velocity", known), "");
  EXPECT_EQ(nearest("x", known), "");
}

TEST(CoreText, NumbersReadBackExactly) {
  for (const double x : {0.1, 1.0 / 3, 6.02e23, -5e-300, 1e100, 0.0}) {
    EXPECT_EQ(std::stod(number_text(x)), x);
  }
  EXPECT_EQ(number_text(100000), "100000");
  EXPECT_EQ(number_text(0.001), "0.001");
  EXPECT_EQ(number_text(1e-7), "1e-07");
}

TEST(CoreError, TextHasPlaceCauseAndIndentedRemedy) {
  const Error e("a.toml:3", "no such key", "keys: x\npage: y");
  EXPECT_STREQ(e.what(), "a.toml:3: no such key\n  keys: x\n  page: y");
  EXPECT_STREQ(Error("", "cause").what(), "cause");
}

TEST(CoreError, ProblemsReportAllButNeverMoreThanTwenty) {
  Problems none;
  EXPECT_NO_THROW(none.raise());
  Problems some;
  for (int i = 0; i < 25; ++i) some.add("p", "cause " + std::to_string(i));
  const std::string text = error_text([&] { some.raise(); });
  EXPECT_THAT(text, AllOf(HasSubstr("cause 0"), HasSubstr("cause 19"), HasSubstr("and 5 more"),
                          Not(HasSubstr("cause 20"))));
}

// Answers of the authors' own test file (Random123, kat_vectors, philox4x32 10).
TEST(CoreRandom, PhiloxGivesThePublishedBits) {
  using Block = Random::Block;
  EXPECT_EQ(Random::philox({0, 0, 0, 0}, {0, 0}),
            (Block{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(
      Random::philox({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}),
      (Block{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(
      Random::philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
      (Block{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

// n = 1e5: the mean of a uniform number has deviation 0.29/sqrt(n) = 9e-4, of a normal 3.2e-3, its
// variance 4.5e-3; five deviations are allowed, and the numbers are always the same.
TEST(CoreRandom, MomentsAreRight) {
  const Random random{42, 1};
  double mean = 0, normal_mean = 0, normal_square = 0;
  constexpr int n = 100000;
  for (int i = 0; i < n; ++i) {
    const double u = random.uniform(i);
    ASSERT_TRUE(u >= 0 && u < 1);
    mean += u / n;
    const double z = random.normal(i);
    normal_mean += z / n;
    normal_square += z * z / n;
  }
  EXPECT_NEAR(mean, 0.5, 5 * 9e-4);
  EXPECT_NEAR(normal_mean, 0, 5 * 3.2e-3);
  EXPECT_NEAR(normal_square, 1, 5 * 4.5e-3);
}

TEST(CoreRandom, SeedStreamIdAndDrawAllMatter) {
  const double u = Random{1, 1}.uniform(7, 0);
  EXPECT_EQ(u, (Random{1, 1}.uniform(7, 0)));
  EXPECT_NE(u, (Random{2, 1}.uniform(7, 0)));
  EXPECT_NE(u, (Random{1, 2}.uniform(7, 0)));
  EXPECT_NE(u, (Random{1, 1}.uniform(8, 0)));
  EXPECT_NE(u, (Random{1, 1}.uniform(7, 1)));
  EXPECT_NE(u, (Random{1, 1}.uniform(7 + (1ULL << 32), 0)));
}

TEST(CoreLog, DurationsReadLikeTime) {
  EXPECT_EQ(duration_text(0.84), "0.8 s");
  EXPECT_EQ(duration_text(9.96), "10 s");
  EXPECT_EQ(duration_text(59.6), "1 min 0 s");
  EXPECT_EQ(duration_text(200), "3 min 20 s");
  EXPECT_EQ(duration_text(7500), "2 h 5 min");
  EXPECT_EQ(duration_text(std::nan("")), "?");
}

TEST(CoreLog, ProgressTellsShareRateAndTimeLeft) {
  const Progress progress(2.0, "steps");
  EXPECT_EQ(progress.line(0.5, 1000, 10), " 25 %  1000 steps  100 steps/s  30 s left");
  EXPECT_EQ(progress.line(0, 0, 0), "  0 %  0 steps");
}

TEST(CoreLog, OffATerminalProgressIsALinePerTenth) {
  testing::internal::CaptureStdout();
  {
    Progress progress(1.0, "steps");
    for (int i = 0; i <= 1000; ++i) progress.update(i / 1000.0, i);
  }
  const std::string text = testing::internal::GetCapturedStdout();
  if (log::on_terminal()) GTEST_SKIP() << "standard output is a terminal";
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 10);
  EXPECT_THAT(text, AllOf(HasSubstr(" 10 %  100 steps"), HasSubstr("100 %  1000 steps")));
  EXPECT_THAT(text, Not(HasSubstr("\r")));
}

}  // namespace
}  // namespace breccia
