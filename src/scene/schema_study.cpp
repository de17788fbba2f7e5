// [study]: what `breccia study` varies, and what it holds the results against.
#include "core/text.hpp"
#include "scene/schema_rules.hpp"

#include <algorithm>

namespace breccia {

namespace {

void declare_knobs(Schema& schema) {
  auto s = schema.section("study.knob[]").doc("What a study varies: a ladder of values.");
  s.text("key")
      .doc(
          "A known knob (mesh size, element, step factor, alpha, ...; docs/study.md) or the path "
          "of a key, as --set takes it; * stands for all of a list.")
      .example("body.*.mesh.size");
  s.texts("keys")
      .doc("Several paths that take the same value.")
      .example("[\"body.a.mesh.size\", \"body.b.mesh.size\"]");
  s.exactly_one_of({"key", "keys"});
  s.text("name").doc("How tables and pictures call it.").example("elements at the rim");
  s.values("values")
      .required()
      .doc("The rungs, from coarse to fine.")
      .example("[\"4 mm\", \"2 mm\", \"1 mm\"]");
  s.numbers("sizes", unit::none)
      .above(0)
      .doc(
          "A number for each value, where the values are words: labels show it, orders are told by "
          "it.")
      .example("[4, 2, 1]");
}

void declare_quantities(Schema& schema) {
  auto s = schema.section("study.quantity[]").doc("What a study looks at, and what is right.");
  s.text("name").doc("How tables and pictures call it.").example("tip deflection");
  s.text("check").doc("A [[check]] of the scene: its value and its reference.");
  s.formula("value").doc("An expression as in [[check]].").example("final(tip.uy)");
  s.formula("curve").doc("A column of history.csv, held against a table.").example("tip.uy");
  s.exactly_one_of({"check", "value", "curve"});
  s.formula("reference")
      .doc(
          "The right value; \"finest\" estimates it from the finest rungs (Richardson). That of "
          "the check if absent.")
      .example("finest");
  s.text("solution")
      .doc("A named closed form; `breccia study --solutions` lists them.")
      .example("cantilever.deflection");
  s.pairs("parameters")
      .doc("The parameters of the solution.")
      .example("{ force = \"1 kN\", length = \"2 m\" }");
  s.text("table")
      .names_file()
      .doc("File of the right curve, .csv, two columns in SI, the first one increasing.")
      .example("measured.csv");
  s.at_most_one_of({"reference", "solution", "table"});
  s.formula("against").doc("Column that the first one of the table stands for; time if absent.");
  s.formula("scale")
      .doc("What errors are a share of; the size of the reference if absent.")
      .example("1 mm");
  s.text("source").doc("Where the reference comes from.").example("beam theory");
}

void check_ladders(const Settings& study, Problems& problems) {
  if (study.list("knob").empty())
    problems.add(study.error("", "a study needs a [[study.knob]]", "docs/study.md shows one"));
  for (const Settings& knob : study.list("knob")) {
    std::vector<std::string> rungs = knob.texts("values");
    if (rungs.size() < 2) {
      problems.add(knob.error("values",
                              rungs.empty() ? "the ladder is empty" : "a ladder of one rung",
                              "give at least two values, from coarse to fine"));
    }
    if (knob.has("sizes") && knob.vector("sizes").size() != rungs.size())
      problems.add(knob.error("sizes", "there are not as many sizes as values", "one for each"));
    std::sort(rungs.begin(), rungs.end());
    const auto twice = std::adjacent_find(rungs.begin(), rungs.end());
    if (twice != rungs.end())
      problems.add(knob.error("values", "the value " + *twice + " stands there twice"));
  }
}

void check_quantity(const Settings& scene, const Settings& quantity, Problems& problems) {
  const auto wrong = [&](const char* key, const std::string& cause, const std::string& remedy) {
    problems.add(quantity.error(key, cause, remedy));
  };
  if (quantity.has("check") && scene.find("check", quantity.text("check")) == nullptr) {
    std::vector<std::string> names;
    for (const Settings& check : scene.list("check")) names.push_back(check.name());
    wrong("check",
          "no [[check]] '" + quantity.text("check") + "' in this scene." +
              did_you_mean(quantity.text("check"), names),
          names.empty() ? "the scene has no [[check]]" : "checks: " + join(names));
  }
  const bool judged = quantity.has("reference") || quantity.has("solution");
  if (quantity.has("value") && !judged)
    wrong("value", "has no reference to be held against",
          "add reference = a value or \"finest\", or a solution");
  if (quantity.has("curve") != quantity.has("table"))
    wrong("curve", "a curve and a table go together", "give both, or neither");
  if (quantity.has("parameters") && !quantity.has("solution"))
    wrong("parameters", "belong to a solution, and none is named",
          "breccia study --solutions lists them");
  if (quantity.has("against") && !quantity.has("curve"))
    wrong("against", "belongs to a curve, and there is none", "leave it out");
}

}  // namespace

void declare_study_keys(Schema& schema) {
  auto s = schema.section("study").doc("What accuracy costs: read by `breccia study` alone.");
  s.text("scene")
      .names_file()
      .doc("The scene that is studied, where [study] stands in a file of its own.")
      .example("../scene.toml");
  s.texts("set")
      .doc("Changes to the scene that all jobs share, as --set takes them.")
      .example("[\"output.frames = 0\"]");
  s.choice("walk", {"product", "one"})
      .by_default("product")
      .doc("Several knobs: every combination, or one at a time with the others as in the scene.");
  s.choice("cost", {"wall", "processor"})
      .by_default("wall")
      .doc("Seconds that are counted: by the clock, or of the processor (for a shared machine).");
  s.integer("repeats").between(1, 1000).by_default(1).doc(
      "Runs of each job; seconds are their median.");
  s.number("time_limit", unit::time)
      .above(0)
      .doc("A job that takes longer by the clock is ended and counts as failed.")
      .example("10 min");
  declare_knobs(schema);
  declare_quantities(schema);
}

void check_study_rules(const Settings& scene, Problems& problems) {
  if (!scene.has("study")) return;
  const Settings& study = scene.at("study");
  check_ladders(study, problems);
  if (study.list("quantity").empty()) {
    problems.add(study.error("", "a study needs a [[study.quantity]]",
                             "for example: [[study.quantity]] with check = the name of a check"));
  }
  for (const Settings& quantity : study.list("quantity")) check_quantity(scene, quantity, problems);
}

}  // namespace breccia
