#include "core/expression.hpp"
#include "harness/failures.hpp"

#include <cmath>

namespace breccia {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

/// A load that rises to -3 at 2 s and falls back to -1 at 4 s, and a number.
Quantities sample() {
  Quantities q;
  q.time = {0, 1, 2, 3, 4};
  q.names = {"load.y", "count"};
  q.find = [](const std::string& name) -> std::optional<ExpressionValue> {
    if (name == "load.y") return std::vector<double>{0, -1, -3, -2, -1};
    if (name == "count") return 7.0;
    return std::nullopt;
  };
  return q;
}

double value(const std::string& text) {
  return Expression(text).evaluate(sample());
}

TEST(CoreExpression, ArithmeticBindsAsInMathematics) {
  EXPECT_DOUBLE_EQ(value("1 + 2 * 3"), 7);
  EXPECT_DOUBLE_EQ(value("(1 + 2) * 3"), 9);
  EXPECT_DOUBLE_EQ(value("2 ^ 3 ^ 2"), 512);
  EXPECT_DOUBLE_EQ(value("-2 ^ 2"), -4);
  EXPECT_DOUBLE_EQ(value("2 ^ -1"), 0.5);
  EXPECT_DOUBLE_EQ(value("8 / 4 / 2"), 1);
  EXPECT_DOUBLE_EQ(value("1 - 2 - 3"), -4);
  EXPECT_DOUBLE_EQ(value("--3"), 3);
  EXPECT_DOUBLE_EQ(value(" 1e-3*2E3 "), 2);
  EXPECT_DOUBLE_EQ(value("pi"), M_PI);
}

TEST(CoreExpression, NumbersCarryUnits) {
  EXPECT_DOUBLE_EQ(value("50 mm"), 0.05);
  EXPECT_DOUBLE_EQ(value("50mm/pi"), 0.05 / M_PI);
  EXPECT_DOUBLE_EQ(value("8 MPa / count"), 8e6 / 7);
  EXPECT_DOUBLE_EQ(value("10 %"), 0.1);
  EXPECT_DOUBLE_EQ(value("36 km/h"), 10);
  EXPECT_DOUBLE_EQ(value("9.81 m/s^2 * 2 s"), 19.62);
  EXPECT_DOUBLE_EQ(value("3 m-2"), 1);  // a difference, not a unit
  EXPECT_DOUBLE_EQ(value("2 kg/m3 * 3 m^3"), 6);
  EXPECT_DOUBLE_EQ(value("180 deg"), M_PI);
  EXPECT_DOUBLE_EQ(value("2 N.m"), 2);
}

TEST(CoreExpression, FunctionsOfNumbers) {
  EXPECT_DOUBLE_EQ(value("sqrt(16) + abs(-2) + max(1, 5, 3) + min(4, 2)"), 13);
  EXPECT_DOUBLE_EQ(value("sin(30 deg)"), std::sin(M_PI / 6));
  EXPECT_DOUBLE_EQ(value("exp(log(5))"), 5);
  EXPECT_DOUBLE_EQ(value("4 * atan(1) + cos(0) + tan(0) + asin(0) + acos(1)"), M_PI + 1);
}

TEST(CoreExpression, FunctionsOfSeries) {
  EXPECT_DOUBLE_EQ(value("peak(load.y)"), 3);
  EXPECT_DOUBLE_EQ(value("time_of_peak(load.y)"), 2);
  EXPECT_DOUBLE_EQ(value("max(load.y)"), 0);
  EXPECT_DOUBLE_EQ(value("min(load.y)"), -3);
  EXPECT_DOUBLE_EQ(value("initial(load.y)"), 0);
  EXPECT_DOUBLE_EQ(value("final(load.y)"), -1);
  EXPECT_DOUBLE_EQ(value("integral(load.y)"), -6.5);
  EXPECT_DOUBLE_EQ(value("mean(load.y)"), -6.5 / 4);
  EXPECT_DOUBLE_EQ(value("at(load.y, 1.5 s)"), -2);
  EXPECT_DOUBLE_EQ(value("at(load.y, 4)"), -1);
  EXPECT_DOUBLE_EQ(value("at(load.y, 0)"), 0);
  EXPECT_DOUBLE_EQ(value("arrival(load.y, 2)"), 1.5);
  EXPECT_DOUBLE_EQ(value("arrival(load.y, 0)"), 0);
  EXPECT_DOUBLE_EQ(value("slope(load.y, 2, 4)"), 1);
  EXPECT_DOUBLE_EQ(value("slope(time, 0, 4)"), 1);
  EXPECT_DOUBLE_EQ(value("mean(time, 1.5, 2.5)"), 2);
}

TEST(CoreExpression, SeriesCombineElementByElement) {
  EXPECT_DOUBLE_EQ(value("peak(2 * load.y - load.y)"), 3);
  EXPECT_DOUBLE_EQ(value("max(abs(load.y))"), 3);
  EXPECT_DOUBLE_EQ(value("final(load.y * time)"), -4);
  EXPECT_DOUBLE_EQ(value("final(max(load.y, -0.5))"), -0.5);
  EXPECT_DOUBLE_EQ(value("2 * peak(abs(load.y)) / (pi * 50 mm)"), 6 / (M_PI * 0.05));
}

TEST(CoreExpression, NamesAreListedOnce) {
  EXPECT_THAT(Expression("a.b + c * a.b - peak(d_1.x)").names(), ElementsAre("a.b", "c", "d_1.x"));
}

TEST(CoreExpression, SyntaxErrorsNameTheColumn) {
  const auto text = [](const char* e) { return error_text([e] { const Expression x{e}; }); };
  EXPECT_THAT(text(""), HasSubstr("empty"));
  EXPECT_THAT(text("1 +"), HasSubstr("ends where a value is wanted (column 4"));
  EXPECT_THAT(text("(1 + 2"), HasSubstr("a ')' is missing"));
  EXPECT_THAT(text("1 2"), HasSubstr("'2' is not expected here (column 3"));
  EXPECT_THAT(text("2 $ 3"), HasSubstr("'$' is not expected here (column 3"));
  EXPECT_THAT(text("3 mmm"), AllOf(HasSubstr("no unit 'mmm'"), HasSubstr("'mm'")));
  EXPECT_THAT(text("peek(x)"), AllOf(HasSubstr("no function 'peek'"), HasSubstr("'peak'")));
  EXPECT_THAT(text("at(x)"), HasSubstr("at() takes a series and a time"));
  EXPECT_THAT(text("sqrt()"), HasSubstr("sqrt() takes one argument"));
  EXPECT_THAT(text("1e999"), HasSubstr("not a number"));
  EXPECT_THAT(text(std::string(5000, '(').c_str()), HasSubstr("nested too deeply"));
}

TEST(CoreExpression, EvaluationErrorsSayWhatToDo) {
  const auto text = [](const char* e) { return error_text([e] { value(e); }); };
  EXPECT_THAT(text("lod.y + 1"), AllOf(HasSubstr("no quantity 'lod.y'"), HasSubstr("'load.y'"),
                                       HasSubstr("known: load.y, count, time")));
  EXPECT_THAT(text("load.y"), AllOf(HasSubstr("is a series"), HasSubstr("peak()")));
  EXPECT_THAT(text("1 / 0"), HasSubstr("not finite"));
  EXPECT_THAT(text("peak(3)"), HasSubstr("must be a series"));
  EXPECT_THAT(text("max(3)"), HasSubstr("needs a series"));
  EXPECT_THAT(text("at(load.y, 5)"), HasSubstr("outside of the run, 0 s to 4 s"));
  EXPECT_THAT(text("at(load.y, time)"), HasSubstr("must be a number"));
  EXPECT_THAT(text("arrival(load.y, 10)"), HasSubstr("never reaches 10"));
  EXPECT_THAT(text("slope(load.y, 1.1, 1.2)"), HasSubstr("fewer than two samples"));
  EXPECT_THAT(text("mean(load.y, 2, 1)"), HasSubstr("mean() from 2 s to 1 s"));
  EXPECT_THAT(text("mean(load.y, 2)"), HasSubstr("a series, or a series and two times"));
}

}  // namespace
}  // namespace breccia
