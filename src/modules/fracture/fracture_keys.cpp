#include "modules/fracture/fracture_keys.hpp"

#include "modules/fracture/existing_laws.hpp"
#include "modules/fracture/fracture.hpp"

namespace breccia {

namespace {

void add_strength_keys(SectionBuilder& section) {
  section.number("tensile_strength", unit::pressure)
      .at_least(0)
      .required()
      .example("8 MPa")
      .doc("Normal traction that an intact face bears.");
  section.number("cohesion", unit::pressure)
      .at_least(0)
      .required()
      .example("24 MPa")
      .doc("Shear traction that an intact face bears without normal traction.");
  section.number("friction_angle", unit::angle)
      .at_least(0)
      .below(1.5)
      .by_default(0.0)
      .example("50 deg")
      .doc("Of the intact face: pressure raises its shear strength by the tangent of this angle.");
  section.number("residual_friction", unit::none)
      .at_least(0)
      .doc(
          "Friction coefficient of the broken face; the tangent of friction_angle where it is "
          "not given.");
  section.number("energy_tension", unit::surface_energy)
      .at_least(0)
      .required()
      .example("50 J/m2")
      .doc("Energy that opening a face takes, per area.");
  section.number("energy_shear", unit::surface_energy)
      .at_least(0)
      .required()
      .example("500 J/m2")
      .doc("Energy that sliding along a face takes, per area, friction apart.");
  section.number("scatter", unit::none)
      .between(1, 1000)
      .example("8")
      .doc(
          "Weibull modulus: tensile_strength and cohesion of each face are their values here times "
          "one random number of mean 1 (run.seed). All faces are alike if absent.");
  section.number("correlation", unit::length)
      .above(0)
      .example("5 mm")
      .doc(
          "Of the scatter: strengths at a distance r are alike as exp(-(r/correlation)^2). Every "
          "face has its own number if absent.");
}

void add_rate_keys(SectionBuilder& section) {
  section.number("rate_reference", unit::frequency)
      .above(0)
      .example("30 1/s")
      .doc(
          "Rate of deformation from which on tensile_strength and cohesion grow: by (rate / "
          "rate_reference)^rate_exponent, as it is when the face becomes an interface. They do "
          "not depend on the rate if absent.");
  section.number("rate_exponent", unit::none)
      .above(0)
      .at_most(1)
      .by_default(1.0 / 3)
      .doc("That power.");
  section.number("rate_limit", unit::none)
      .between(1, 100)
      .by_default(3.0)
      .doc("Most that they grow by.");
}

}  // namespace

void add_spring_keys(SectionBuilder& section) {
  section.number("stiffness_factor", unit::none)
      .between(0.5, 1000)
      .by_default(5.0)
      .doc(
          "Stiffness of an interface times half the height of its elements, over their modulus. "
          "A larger one costs time steps.");
  section.number("damping", unit::none)
      .between(0, 1)
      .by_default(0.01)
      .doc(
          "Share of critical damping in the springs of interfaces; at least 0.005 keeps the kink "
          "between opening and closing from feeding energy in.");
}

void add_law_keys(SectionBuilder section) {
  add_strength_keys(section);
  add_rate_keys(section);
  section.number("alpha", unit::none)
      .between(0, 1)
      .by_default(0.95)
      .doc(
          "Share of the strength at which a face becomes an interface: 0 inserts all at the start "
          "(intrinsic), 1 at the peak (extrinsic).");
  section.choice("criterion", {"mohr_coulomb", "elliptic"})
      .by_default("mohr_coulomb")
      .doc(
          "When a face becomes an interface: Mohr and Coulomb with tension cut-off, or the root "
          "of the squares of the tensile and the shear share.");
  section.choice("softening", {"linear", "z_curve"})
      .by_default("linear")
      .doc("How strength falls with damage: a line, or the curve of Munjiza, Andrews and White.");
  add_spring_keys(section);
}

void declare_fracture_keys(Schema& schema) {
  SectionBuilder fracture = schema.section("fracture.*");
  fracture.effect("fracture")
      .names_refer_to("material")
      .doc(
          "Faces between elements of this material may break. Without the section no interface "
          "exists.");
  add_law_keys(fracture);
  SectionBuilder interface = schema.section("interface[]");
  interface.effect("fracture")
      .doc(
          "Faces between elements of two materials, of bodies that share nodes, may break. Without "
          "the "
          "section they never do.");
  interface.texts("between")
      .required()
      .names_one_of("material")
      .example("[\"granite\", \"mortar\"]")
      .doc("The two materials.");
  add_law_keys(interface);
  declare_existing_law_keys(schema);
}

}  // namespace breccia
