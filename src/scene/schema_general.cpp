#include "scene/schema_general.hpp"

#include "scene/schema_rules.hpp"

namespace breccia {

namespace {

void declare_top(Schema& schema) {
  auto s = schema.top().doc("What the scene is about. Every scene begins with these three.");
  s.text("title").doc("The problem in one line.").example("Brazilian disc, granite, 50 mm");
  s.text("reference").doc("Where problem and data come from.").example("ISRM suggested method");
  s.text("expected")
      .doc("What a right result looks like.")
      .example("one diametral crack; 2P/(pi D t) at the peak is the tensile strength");
}

void declare_run(Schema& schema) {
  auto s = schema.section("run").required().always().doc("How long, in how many dimensions.");
  s.integer("dimension").between(2, 3).required().doc("Dimensions of space.").example("2");
  s.choice("plane", {"strain", "stress"})
      .only_in(2)
      .by_default("strain")
      .doc("Plane strain, or plane stress for thin plates.");
  s.number("thickness", unit::length)
      .only_in(2)
      .above(0)
      .by_default("1 m")
      .doc("Extent out of the plane; forces, masses and energies are for it.");
  s.number("duration", unit::time).above(0).required().doc("Time to simulate.").example("1.2 ms");
  s.number("step_factor", unit::none)
      .above(0)
      .at_most(1)
      .doc("Time step as a share of the stable one; chosen by what the scene contains if absent.")
      .example("0.8");
  s.number("step", unit::time)
      .above(0)
      .doc("A fixed time step, refused where it is above the stable one.")
      .example("50 ns");
  s.at_most_one_of({"step", "step_factor"});
  auto scaling = schema.section("run.mass_scaling")
                     .effect("motion")
                     .doc("Makes the nodes of the smallest elements heavier, for a longer step.");
  scaling.number("step", unit::time)
      .above(0)
      .required()
      .doc("The step that is wanted.")
      .example("100 ns");
  scaling.flag("quasi_static")
      .by_default(false)
      .doc("true: slow loading, inertia does not matter; else at most 5 % mass is added.");
  auto guard = schema.section("run.guard")
                   .always()
                   .doc(
                       "Looks that stop a run whose results would be worth nothing. Energies that "
                       "are not finite "
                       "always do.");
  guard.integer("every")
      .between(0, 1000000)
      .by_default(200)
      .doc("Steps between two looks; 0: nobody looks.");
  guard.number("energy", unit::none)
      .above(0)
      .by_default(0.1)
      .doc(
          "Energy from nowhere, as a share of the largest energy so far, that two looks in a row "
          "may not see; what contact gives by numerics counts.");
  guard.number("overlap", unit::none)
      .above(0)
      .by_default(1)
      .doc("Depth of bodies in one another, in heights of the elements at the face.");
  s.choice("precision", {"double", "mixed"}).by_default("double").doc("Arithmetic of the loops.");
  s.integer("seed")
      .between(0, 2147483647)
      .by_default(1)
      .doc("Seed of everything random; the same seed gives the same bits.");
}

void declare_sensors(Schema& schema) {
  auto s = schema.section("sensor[]").effect("sensor").doc("What history.csv records.");
  s.text("name")
      .required()
      .unique()
      .identifier()
      .doc("Front of its columns: load.x, load.y; [[check]] speaks of them.")
      .example("load");
  s.vector("point", unit::length)
      .doc("Displacement, velocity and stress at a material point.")
      .example("[0, \"25 mm\"]");
  s.text("surface")
      .doc("Mean displacement and velocity of a side (by area) or body (by volume).")
      .example("disc.rim");
  s.text("reaction")
      .doc("Force that a boundary (by its name or `where`) or body exerts on the scene.")
      .example("upper platen");
  s.exactly_one_of({"point", "surface", "reaction"});
}

void declare_output(Schema& schema) {
  auto s = schema.section("output").always().doc("What is written, and how often.");
  s.integer("frames").between(0, 100000).by_default(20).doc(
      "Pictures of the whole state, evenly over the run, besides the first one.");
  s.number("history", unit::time)
      .above(0)
      .doc("Interval between two rows of history.csv; a thousandth of the duration if absent.")
      .example("1 us");
  s.texts("fields")
      .doc("Fields of the frames; all that the effects offer if absent.")
      .example("[\"velocity\", \"stress\"]");
  s.number("emission_reach", unit::length)
      .above(0)
      .example("5 mm")
      .doc(
          "Faces that break within this distance, and within the time that a crack at half the "
          "speed of shear waves needs for it, are one row of emissions.csv; three times the mean "
          "size of the faces that broke if absent.");
  s.number("checkpoint", unit::time)
      .above(0)
      .by_default("10 min")
      .doc("Wall-clock time between two checkpoints.");
}

void declare_norms(Schema& schema) {
  auto s = schema.section("norm[]").doc(
      "How far fields are from what they should be, over a whole body at the end of the run: the "
      "number norm.NAME, the root of the mean square over the volume, and norm.NAME.share, that "
      "over "
      "the same of what is exact, for [[check]] and [study].");
  s.text("name").required().unique().identifier().doc("NAME.").example("stress_error");
  s.texts("fields")
      .required()
      .doc("Fields of the frames, by component.")
      .example("[\"stress.xx\", \"stress.yy\", \"stress.xy\"]");
  s.values("exact")
      .doc(
          "What each should be: a formula of x, y, z (places before anything moved, m) and time "
          "(s); "
          "nothing: the norm is that of the fields themselves.")
      .example("[\"1 MPa * x / 2 m\", 0, 0]");
  s.text("body").doc("The body; all of them if absent.").example("ring");
}

void declare_checks(Schema& schema) {
  auto s = schema.section("check[]").doc(
      "A result that the run is held against; exit status 3 when one fails.");
  s.text("name").required().unique().doc("What is checked.").example("tensile strength");
  s.formula("value")
      .required()
      .doc("Expression of sensors, energies and counts.")
      .example("2 * peak(abs(load.y)) / (pi * 50 mm)");
  s.formula("reference").required().doc("The value it should have.").example("8 MPa");
  s.formula("tolerance")
      .required()
      .doc("Largest difference: with % a share of the reference, else in the value's unit.")
      .example("10 %");
  s.text("source").doc("Where the reference comes from.").example("d'Alembert's solution");
}

}  // namespace

void declare_general_keys(Schema& schema) {
  declare_top(schema);
  declare_run(schema);
  declare_body_keys(schema);
  declare_fracture_shape_keys(schema);
  declare_material_keys(schema);
  declare_load_keys(schema);
  declare_sensors(schema);
  declare_output(schema);
  declare_norms(schema);
  declare_checks(schema);
  declare_study_keys(schema);
  declare_batch_keys(schema);
  schema.check(check_run_rules);
  schema.check(check_body_rules);
  schema.check(check_fracture_rules);
  schema.check(check_load_rules);
  schema.check(check_material_rules);
  schema.check(check_study_rules);
  schema.check(check_batch_rules);
}

}  // namespace breccia
