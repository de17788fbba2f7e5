// Scene keys of the law of Johnson and Holmquist.
#include "step/material_laws.hpp"

namespace breccia {

namespace {

void declare_strength(SectionBuilder s) {
  s.number("hel_stress", unit::pressure)
      .above(0)
      .required()
      .example("2 GPa")
      .doc("Equivalent stress at the Hugoniot elastic limit; unit of the strengths.");
  s.number("hel_pressure", unit::pressure)
      .above(0)
      .required()
      .example("1.46 GPa")
      .doc("Pressure there; unit of the pressures.");
  s.number("intact", unit::none)
      .above(0)
      .required()
      .example("0.93")
      .doc("Strength of the intact material, A.");
  s.number("intact_power", unit::none)
      .between(0, 2)
      .required()
      .example("0.6")
      .doc("Power of pressure and tension that it rises with, N.");
  s.number("fractured", unit::none)
      .at_least(0)
      .required()
      .example("0.31")
      .doc("Strength of the crushed material, B; not above that of the intact one.");
  s.number("fractured_power", unit::none)
      .between(0, 2)
      .required()
      .example("0.6")
      .doc("Power of pressure that it rises with, M.");
  s.number("fractured_most", unit::none)
      .at_least(0)
      .example("0.5")
      .doc("Its largest value; none if absent.");
  s.number("tension", unit::pressure)
      .above(0)
      .required()
      .example("200 MPa")
      .doc("Largest tension in all directions, T.");
}

void declare_holmquist(SectionBuilder s) {
  declare_strength(s);
  s.number("rate_strength", unit::none)
      .between(0, 1)
      .by_default(0.0)
      .example("0.009")
      .doc("Rise of the strengths per natural logarithm of the rate of plastic strain, C.");
  s.number("rate_reference", unit::frequency)
      .above(0)
      .by_default(1.0)
      .doc("Rate of plastic strain below which rate does not matter.");
  s.number("ductility", unit::none)
      .above(0)
      .required()
      .example("0.005")
      .doc("Plastic strain that crushes the material, D1, times its power of pressure.");
  s.number("ductility_power", unit::none)
      .between(0, 5)
      .required()
      .example("1")
      .doc("Power of pressure and tension that it rises with, D2.");
  s.number("ductility_least", unit::none)
      .above(0)
      .at_most(1)
      .by_default(0.001)
      .doc("Plastic strain that crushes the material where it is least, in tension.");
}

PlasticLaw read_holmquist(const Settings& law, const MaterialBasis&) {
  Holmquist h;
  h.hel_stress = law.number("hel_stress");
  h.hel_pressure = law.number("hel_pressure");
  h.intact = law.number("intact");
  h.intact_power = law.number("intact_power");
  h.fractured = law.number("fractured");
  h.fractured_power = law.number("fractured_power");
  h.fractured_most = law.maybe_number("fractured_most").value_or(h.fractured_most);
  h.tension = law.number("tension");
  h.rate_strength = law.number("rate_strength");
  h.rate_reference = law.number("rate_reference");
  h.ductility = law.number("ductility");
  h.ductility_power = law.number("ductility_power");
  h.ductility_least = law.number("ductility_least");
  if (h.fractured > h.intact) {
    throw law.error("fractured", "the crushed material is stronger than the intact one",
                    "take `fractured` not above `intact`");
  }
  return h;
}

}  // namespace

PlasticKeys holmquist_keys() {
  return {"holmquist",
          "Brittle damage after Johnson and Holmquist: rock and ceramics under impact.",
          declare_holmquist, read_holmquist};
}

}  // namespace breccia
