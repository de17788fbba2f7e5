// The keys of the laws of [[fractures]]; where these lie is in scene/schema_fractures.cpp.
#include "modules/fracture/existing_laws.hpp"
#include "modules/fracture/fracture_keys.hpp"
#include "step/friction_keys.hpp"

namespace breccia {

namespace {

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
  friction.number("coefficient", unit::none)
      .between(0, 10)
      .required()
      .example("0.6")
      .doc("Friction at rest; of rate and state at the reference speed in steady state.");
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
