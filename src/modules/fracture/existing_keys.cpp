// The keys of the laws of [[fractures]]; where these lie is in scene/schema_fractures.cpp.
#include "modules/fracture/existing_laws.hpp"
#include "modules/fracture/fracture_keys.hpp"

namespace breccia {

namespace {

void add_friction_keys(SectionBuilder& s) {
  s.choice("law", {"coulomb", "static_dynamic", "slip_weakening", "velocity_weakening", "ageing",
                   "slip_law"})
      .by_default("coulomb")
      .doc(
          "coulomb: one coefficient; static_dynamic: falls with exp(-V / weakening_speed); "
          "slip_weakening: falls in a line over weakening_slip; velocity_weakening: falls with "
          "1 / (1 + V / weakening_speed); ageing, slip_law: rate and state.");
  s.number("coefficient", unit::none)
      .between(0, 10)
      .required()
      .example("0.6")
      .doc("Friction at rest; of rate and state at the reference speed in steady state.");
  s.number("dynamic", unit::none)
      .between(0, 10)
      .example("0.4")
      .doc("Friction of the sliding fault, for the laws that weaken.");
  s.number("weakening_slip", unit::length)
      .above(0)
      .example("0.4 m")
      .doc("Slip over which slip_weakening goes down to `dynamic`.");
  s.number("weakening_speed", unit::velocity)
      .above(0)
      .example("0.1 m/s")
      .doc("Slip rate of static_dynamic and velocity_weakening.");
  s.number("a", unit::none)
      .above(0)
      .at_most(1)
      .example("0.010")
      .doc("Rate and state: direct effect.");
  s.number("b", unit::none)
      .between(0, 1)
      .example("0.015")
      .doc("Rate and state: effect of the state.");
  s.number("state_slip", unit::length)
      .above(0)
      .example("10 um")
      .doc("Rate and state: slip over which the state evolves.");
  s.number("reference_speed", unit::velocity)
      .above(0)
      .by_default("1 um/s")
      .doc("Rate and state: slip rate at which friction in steady state is `coefficient`.");
  s.number("state", unit::time)
      .above(0)
      .example("10 s")
      .doc("Rate and state: state variable at the start; steady at the reference speed if absent.");
}

void add_patch_keys(Schema& schema) {
  auto s = schema.section("fractures[].patch[]")
               .effect("fracture")
               .doc(
                   "A part of a closed fracture that differs: where rupture starts, or what stops "
                   "it. Of several over one face the last counts.");
  s.vector("lower", unit::length).required().doc("Lowest corner of a box.").example("[-1, -1]");
  s.vector("upper", unit::length).required().doc("Highest corner.").example("[1, 1]");
  s.number("coefficient", unit::none).between(0, 10).example("0.3").doc("Instead of the fault's.");
  s.number("dynamic", unit::none).between(0, 10).example("0.3").doc("Instead of the fault's.");
  s.numbers("stress", unit::pressure)
      .doc("Instead of the fault's.")
      .example("[0, 0, 0, \"11.6 MPa\"]");
}

}  // namespace

void declare_existing_law_keys(Schema& schema) {
  auto law = schema.section("fractures[].law")
                 .effect("fracture")
                 .doc("Strength of the faces of healed fractures.");
  add_law_keys(law);
  auto grains = schema.section("fracture.*.grains")
                    .effect("fracture")
                    .doc(
                        "Faces between grains of this material: where a number that the mesh file "
                        "gives to its elements changes.");
  grains.text("field")
      .required()
      .doc("Name of the $ElementData in the .msh file.")
      .example("grain");
  add_law_keys(grains);
  auto friction = schema.section("fractures[].friction")
                      .effect("fracture")
                      .doc("Friction of closed fractures, which have no strength.");
  add_friction_keys(friction);
  friction.numbers("stress", unit::pressure)
      .doc(
          "A uniform stress that friction feels and the elements do not, as [[initial_stress]] is "
          "written: what stood on the fault before the start, where only its change moves the "
          "rock.")
      .example("[0, \"-120 MPa\", 0, \"70 MPa\"]");
  add_spring_keys(friction);
  add_patch_keys(schema);
}

}  // namespace breccia
