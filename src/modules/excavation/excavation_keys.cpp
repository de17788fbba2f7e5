#include "core/text.hpp"
#include "modules/excavation/excavation.hpp"
#include "step/selection.hpp"

namespace breccia {

namespace {

void check_excavations(const Settings& scene, Problems& problems) {
  const double duration = scene.at("run").number("duration");
  for (const Settings& section : scene.list("excavate")) {
    if (section.number("at") > duration)
      problems.add(section.error("at", number_text(section.number("at")) +
                                           " s is beyond the run (duration " +
                                           number_text(duration) + " s)"));
    check_box(section, problems);
  }
}

}  // namespace

void declare_excavation_keys(Schema& schema) {
  auto s = schema.section("excavate[]")
               .effect("excavation")
               .doc(
                   "Elements that are taken out: they lose stress and mass within a time, and are "
                   "gone after it.");
  s.text("where").doc("A body, or a region with elements.").example("tunnel");
  s.number("at", unit::time).at_least(0).by_default("0 s").doc("When it begins.").example("2 ms");
  s.number("release", unit::time)
      .above(0)
      .required()
      .doc(
          "How long it takes, with a smooth begin and end. Long against the time that waves need "
          "across the hole makes few of them; short ones are a blast.")
      .example("5 ms");
  s.exactly_one_of({"where", "box"});
  auto box = schema.section("excavate[].box").doc("Elements whose centroids lie in a box.");
  box.vector("lower", unit::length).required().doc("Lowest corner.").example("[0, 0]");
  box.vector("upper", unit::length).required().doc("Highest corner.").example("[\"3 m\", \"2 m\"]");
  schema.check(check_excavations);
}

}  // namespace breccia
