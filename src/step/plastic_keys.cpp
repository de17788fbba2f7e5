// Scene keys of the inelastic laws of metals, and the table of all.
#include "step/material_laws.hpp"

namespace breccia {

namespace {

void add_hardening(SectionBuilder s) {
  s.number("yield", unit::pressure)
      .above(0)
      .required()
      .example("90 MPa")
      .doc("Yield stress in simple tension before any plastic strain.");
  s.number("hardening", unit::pressure)
      .at_least(0)
      .by_default(0.0)
      .example("292 MPa")
      .doc("Rise of the yield stress per plastic strain to the power of the exponent.");
  s.number("exponent", unit::none)
      .above(0)
      .at_most(1)
      .by_default(1.0)
      .example("0.31")
      .doc("Of plastic strain; 1: hardening along a line.");
}

void declare_j2(SectionBuilder s) {
  add_hardening(s);
  s.number("rate_reference", unit::frequency)
      .above(0)
      .example("100 1/s")
      .doc("Rate of plastic strain that doubles the yield stress (Perzyna); none if absent.");
  s.number("rate_exponent", unit::none)
      .above(0)
      .at_most(10)
      .by_default(1.0)
      .example("0.2")
      .doc("Power of the rate over rate_reference that the yield stress rises with.");
}

PlasticLaw read_j2(const Settings& law, const MaterialBasis&) {
  if (!law.has("rate_reference") && law.number("exponent") == 1) {
    J2 j2;
    j2.yield = law.number("yield");
    j2.hardening = law.number("hardening");
    return j2;
  }
  JohnsonCook j2;
  j2.yield = law.number("yield");
  j2.hardening = law.number("hardening");
  j2.exponent = law.number("exponent");
  if (law.has("rate_reference")) {
    j2.rate_law = RateFactor::perzyna;
    j2.rate_reference = law.number("rate_reference");
    j2.rate_strength = law.number("rate_exponent");
  }
  return j2;
}

void declare_johnson_cook(SectionBuilder s) {
  add_hardening(s);
  s.number("rate_strength", unit::none)
      .between(0, 1)
      .by_default(0.0)
      .example("0.025")
      .doc("Rise of the yield stress per natural logarithm of the rate of plastic strain.");
  s.number("rate_reference", unit::frequency)
      .above(0)
      .by_default(1.0)
      .doc("Rate of plastic strain below which rate does not matter.");
  s.number("melting", unit::temperature)
      .above(0)
      .example("1356 K")
      .doc("Melting temperature, where strength is gone; heat does not matter if absent.");
  s.number("room", unit::temperature)
      .at_least(0)
      .by_default(293.0)
      .doc("Temperature from which strength begins to fall.");
  s.number("start", unit::temperature).at_least(0).doc("Temperature at the start; room if absent.");
  s.number("softening", unit::none)
      .above(0)
      .at_most(10)
      .by_default(1.0)
      .example("1.09")
      .doc("Power of the way from room to melting temperature that strength falls with.");
  s.number("heat_capacity", unit::heat_capacity)
      .above(0)
      .example("383 J/(kg.K)")
      .doc("Heats by plastic work; without it the temperature stays.");
  s.number("heat_share", unit::none)
      .between(0, 1)
      .by_default(0.9)
      .doc("Share of plastic work that becomes heat.");
}

PlasticLaw read_johnson_cook(const Settings& law, const MaterialBasis& basis) {
  JohnsonCook jc;
  jc.yield = law.number("yield");
  jc.hardening = law.number("hardening");
  jc.exponent = law.number("exponent");
  jc.rate_law = RateFactor::johnson_cook;
  jc.rate_strength = law.number("rate_strength");
  jc.rate_reference = law.number("rate_reference");
  jc.softening = law.number("softening");
  if (law.has("heat_capacity")) {
    jc.heat = law.number("heat_share") / (basis.density * law.number("heat_capacity"));
  }
  if (!law.has("melting")) return jc;
  const double room = law.number("room"), start = law.maybe_number("start").value_or(room);
  jc.melting = law.number("melting") - room;
  jc.start = start - room;
  if (jc.melting <= 0) {
    throw law.error("melting", "is not above the temperature `room`",
                    "strength falls from `room` to `melting`");
  }
  if (jc.start >= jc.melting) {
    throw law.error("start", "the material is molten at the start",
                    "a strengthless material needs no law of yielding");
  }
  return jc;
}

}  // namespace

const std::vector<PlasticKeys>& plastic_keys() {
  static const std::vector<PlasticKeys> list{
      {"j2", "Von Mises plasticity: metals.", declare_j2, read_j2},
      {"johnson_cook",
       "Von Mises plasticity after Johnson and Cook: metals that flow fast and hot.",
       declare_johnson_cook, read_johnson_cook},
      drucker_prager_keys(),
      mohr_coulomb_keys(),
      holmquist_keys(),
  };
  return list;
}

}  // namespace breccia
