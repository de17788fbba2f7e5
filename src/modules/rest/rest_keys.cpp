#include "core/text.hpp"
#include "modules/rest/rest.hpp"

namespace breccia {

void declare_rest_keys(Schema& schema) {
  auto s =
      schema.section("run.rest")
          .effect("rest")
          .doc(
              "Takes motion out until the forces hold one another; run.duration is the longest "
              "time that this may take.");
  s.choice("method", {"kinetic", "local"})
      .by_default("kinetic")
      .doc(
          "Take all velocities away at each maximum of the kinetic energy, or resist motion at "
          "each "
          "node with a share of the net force on it (wrong for what falls freely).");
  s.number("share", unit::none)
      .above(0)
      .below(1)
      .doc("That share, for the method \"local\"; 0.8 if absent.")
      .example("0.8");
  s.number("tolerance", unit::none)
      .above(0)
      .below(1)
      .by_default(1e-4)
      .doc(
          "At rest is where no node has a net force above this share of the mean force on an "
          "element's corner (and kinetic energy is below a millionth of what is stored).");
  s.number("after", unit::time)
      .at_least(0)
      .doc("Rest counts from here on; from the end of the last ramp or table if absent.")
      .example("1 ms");
  s.choice("then", {"stop", "go on"})
      .by_default("stop")
      .doc("At rest the run ends, or goes on to its duration with nothing taken out any more.");
  schema.check([](const Settings& scene, Problems& problems) {
    if (!scene.at("run").has("rest")) return;
    const Settings& rest = scene.at("run.rest");
    if (rest.has("share") && rest.text("method") != "local")
      problems.add(rest.error("share", "is for the method \"local\"", "leave it out"));
    const double duration = scene.at("run").number("duration");
    if (rest.has("after") && rest.number("after") > duration)
      problems.add(rest.error("after", number_text(rest.number("after")) +
                                           " s is beyond the run (duration " +
                                           number_text(duration) + " s)"));
  });
}

}  // namespace breccia
