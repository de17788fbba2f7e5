#include "core/unit.hpp"
#include "harness/failures.hpp"

namespace breccia {
namespace {

using testing::AllOf;
using testing::HasSubstr;

struct Known {
  const char* text;
  double value;
  Dimension dimension;
};

class CoreUnitKnown : public testing::TestWithParam<Known> {};

// Conversions are exact: the SI value is the double nearest to the decimal number.
TEST_P(CoreUnitKnown, IsConvertedExactly) {
  const Quantity q = parse_quantity(GetParam().text);
  EXPECT_DOUBLE_EQ(q.value, GetParam().value);
  EXPECT_EQ(q.dimension, GetParam().dimension);
}

constexpr double pi = 3.14159265358979323846;
constexpr Dimension spring{0, 1, -2, 0, 0};

INSTANTIATE_TEST_SUITE_P(
    All, CoreUnitKnown,
    testing::Values(Known{"60 GPa", 60e9, unit::pressure}, Known{"2650 kg/m3", 2650, unit::density},
                    Known{"2.65 g/cm^3", 2650, unit::density}, Known{"50 J/m2", 50, spring},
                    Known{"9.81 m/s^2", 9.81, unit::acceleration},
                    Known{"3 MPa/m", 3e6, unit::interface_stiffness},
                    Known{"2 N.m", 2, unit::energy}, Known{"2 N*m", 2, unit::energy},
                    Known{"180 deg", pi, unit::angle}, Known{"1 rad", 1, unit::angle},
                    Known{"10 %", 0.1, unit::none}, Known{"7 us", 7e-6, unit::time},
                    Known{"7 \u00b5s", 7e-6, unit::time}, Known{"7 ms", 7e-3, unit::time},
                    Known{"2 min", 120, unit::time}, Known{"1.5 h", 5400, unit::time},
                    Known{"-3e-2mm", -3e-5, unit::length}, Known{"+4 m", 4, unit::length},
                    Known{"5 1/s", 5, unit::frequency}, Known{"5 s^-1", 5, unit::frequency},
                    Known{"5 m-2", 5, Dimension{-2, 0, 0, 0, 0}},
                    Known{"2 J/(kg.K)", 2, Dimension{2, 0, -2, -1, 0}},
                    Known{"2 J/kg/K", 2, Dimension{2, 0, -2, -1, 0}},
                    Known{"60 rpm", 2 * pi, unit::angular_velocity}, Known{"3 t", 3000, unit::mass},
                    Known{"1 bar", 1e5, unit::pressure}, Known{"0.25", 0.25, unit::none}));

TEST(CoreUnit, SmallPrefixesRoundOnce) {
  for (int n = 1; n <= 200; ++n) {
    const std::string text = std::to_string(n);
    EXPECT_EQ(parse_quantity(text + " mm").value, std::stod(text + "e-3")) << n;
    EXPECT_EQ(parse_quantity(text + " us").value, std::stod(text + "e-6")) << n;
  }
}

TEST(CoreUnit, ANumberAloneHasNoUnit) {
  EXPECT_FALSE(parse_quantity("3").has_unit);
  EXPECT_TRUE(parse_quantity("3 %").has_unit);
}

TEST(CoreUnit, RefusalsSayWhatIsWrong) {
  const auto text = [](const char* q) { return error_text([q] { parse_quantity(q); }); };
  EXPECT_THAT(text("60 mpa"), AllOf(HasSubstr("no unit 'mpa'"), HasSubstr("'MPa'")));
  EXPECT_THAT(text("60 GPx"), HasSubstr("Did you mean 'GPa'?"));
  EXPECT_THAT(text("GPa"), HasSubstr("does not begin with a number"));
  EXPECT_THAT(text(""), HasSubstr("does not begin with a number"));
  EXPECT_THAT(text("nan m"), HasSubstr("not a finite number"));
  EXPECT_THAT(text("inf"), HasSubstr("not a finite number"));
  EXPECT_THAT(text("1e999 m"), HasSubstr("too large or too small"));
  EXPECT_THAT(text("1e307 GPa"), HasSubstr("too large in SI"));
  EXPECT_THAT(text("3 m/"), HasSubstr("is not complete"));
  EXPECT_THAT(text("3 m^x"), HasSubstr("no integer"));
  EXPECT_THAT(text("3 m^99"), HasSubstr("exponent out of range"));
  EXPECT_THAT(text("3 (m"), HasSubstr("lacks a ')'"));
  EXPECT_THAT(text("3 m m"), HasSubstr("' m' is not a unit"));
  EXPECT_THAT(text("20 degC"), AllOf(HasSubstr("temperatures are in K"), HasSubstr("273.15")));
}

TEST(CoreUnit, NamesAreForPeople) {
  EXPECT_EQ(friendly(unit::pressure), "pressure, e.g. \"60 GPa\"");
  EXPECT_EQ(friendly(unit::none), "pure number, e.g. 0.5");
  EXPECT_EQ(si_unit(unit::density), "kg/m3");
  EXPECT_EQ(si_unit(Dimension{1, 0, -3, 0, 0}), "m.s^-3");
  EXPECT_EQ(dimension_name(Dimension{1, 0, -3, 0, 0}), "quantity in m.s^-3");
  EXPECT_EQ(with_article("angle"), "an angle");
}

// What si_unit writes into a resolved scene must be readable again.
TEST(CoreUnit, SiUnitsReadBack) {
  for (const Dimension d : {unit::pressure, unit::surface_energy, unit::angular_velocity,
                            unit::interface_viscosity, Dimension{-1, 2, -3, 1, 1}}) {
    const Quantity q = parse_unit(si_unit(d));
    EXPECT_EQ(q.dimension, d) << si_unit(d);
    EXPECT_EQ(q.value, 1.0) << si_unit(d);
  }
}

}  // namespace
}  // namespace breccia
