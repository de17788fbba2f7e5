#include "modules/contact/contact.hpp"
#include "step/friction_keys.hpp"

namespace breccia {

namespace {

void check_law(const Settings& friction, Problems& problems) {
  check_friction(friction, "friction", problems);
  if (friction.text("law") != "coulomb" && !(friction.number("friction") > 0))
    problems.add(friction.error("friction", "is zero; " + friction.text("law") + " starts from it",
                                "give the friction coefficient at rest"));
}

void check_contact_rules(const Settings& scene, Problems& problems) {
  if (!scene.has("contact")) return;
  const Settings& contact = scene.at("contact");
  check_law(contact, problems);
  for (const Settings& pair : contact.list("pair")) {
    check_law(pair, problems);
    if (pair.texts("between").empty() || pair.texts("between").size() > 2)
      problems.add(pair.error("between", "a pair has two materials",
                              "write [\"a\", \"b\"], or [\"a\"] for a against itself"));
  }
}

/// What forces are made of.
void declare_force_keys(SectionBuilder& contact) {
  contact.choice("force", {"smooth", "distributed_potential"})
      .by_default("smooth")
      .doc(
          "Where forces come from: points in the nodal depth, or, to compare, faces in the "
          "potential that each element has of its own.");
  contact.choice("points", {"gauss", "corners"})
      .by_default("gauss")
      .doc(
          "Where faces feel contact: at Gauss points, which see a corner that enters a face when "
          "it "
          "is a fifth of it deep, or at their corners, which see it at once; corners suit grains "
          "of "
          "few elements.");
  contact.choice("direction", {"smooth", "conservative"})
      .by_default("smooth")
      .doc(
          "Direction of the force: the smoothed gradient of the depth, or its exact gradient, "
          "which turns between elements but keeps energy to round-off.");
}

void declare_pair_keys(Schema& schema) {
  SectionBuilder pair = schema.section("contact.pair[]");
  pair.doc("Friction between two materials, where it differs; with a law of its own.");
  pair.texts("between")
      .required()
      .names_one_of("material")
      .example("[\"steel\", \"granite\"]")
      .doc("The two materials, or one for a material against itself.");
  pair.number("friction", unit::none)
      .at_least(0)
      .required()
      .example("0.6")
      .doc("Friction coefficient at rest.");
  add_friction_keys(pair);
}

}  // namespace

void declare_contact_keys(Schema& schema) {
  SectionBuilder contact = schema.section("contact");
  contact.effect("contact").doc(
      "Bodies, fragments and the sides of cracks press and rub against each other.");
  contact.number("friction", unit::none)
      .at_least(0)
      .by_default(0.0)
      .example("0.3")
      .doc(
          "Friction coefficient between all materials, at rest; of rate and state at the reference "
          "speed in steady state.");
  add_friction_keys(contact);
  contact.number("stiffness_factor", unit::none)
      .between(0.5, 1000)
      .by_default(5.0)
      .doc(
          "Contact stiffness times half the height of the elements, over their modulus; the same "
          "as that of interfaces keeps forces continuous at release. A larger one lets bodies "
          "overlap less and costs time steps.");
  contact.number("stiffness", unit::interface_stiffness)
      .above(0)
      .example("1e14 Pa/m")
      .doc("Contact stiffness per area, instead of stiffness_factor.");
  contact.number("damping", unit::none)
      .between(0, 1)
      .by_default(0.01)
      .doc(
          "Share of critical damping in contact; at least 0.005 keeps the kink between touching "
          "and apart from feeding energy in.");
  contact.number("skin", unit::none)
      .above(0)
      .at_most(10)
      .by_default(0.2)
      .doc(
          "Least reach of the contact search over the harmonic mean of the elements at surfaces: a "
          "larger one searches less often and looks at more pairs. For fast bodies it widens "
          "itself, to 0.4 at most.");
  declare_force_keys(contact);
  declare_pair_keys(schema);
  schema.check(check_contact_rules);
}

}  // namespace breccia
