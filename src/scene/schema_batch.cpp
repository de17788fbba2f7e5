// [batch]: the variants that `breccia batch` runs.
#include "core/expression.hpp"
#include "core/text.hpp"
#include "scene/schema_rules.hpp"

#include <algorithm>
#include <map>

namespace breccia {

namespace {

void declare_variation(Schema& schema) {
  auto v = schema.section("batch.vary[]").doc("A key with the values that the variants give it.");
  v.text("key")
      .required()
      .doc(
          "The path of a key, as --set takes it, where * stands for all of a list; or a knob of "
          "docs/study.md, such as seed.")
      .example("fracture.granite.tensile_strength");
  v.values("values").required().doc("Each takes its turn.").example("[\"7 MPa\", \"9 MPa\"]");
  v.text("together")
      .doc(
          "Keys with the same word here go through their values in step; the others make every "
          "combination.")
      .example("rock");
  v.text("name").doc("How the summary calls it; the key if absent.").example("strength");

  auto u = schema.section("batch.uncertain[]").doc("A key with values drawn at random.");
  u.text("key")
      .required()
      .doc("As in [[batch.vary]].")
      .example("fracture.granite.tensile_strength");
  u.choice("distribution", {"uniform", "loguniform", "normal", "lognormal", "weibull"})
      .required()
      .doc(
          "uniform and loguniform have two bounds, normal and lognormal a mean and a std_deviation "
          "of the value itself, weibull a scale and a shape; the last three may have bounds, which "
          "cut them off.")
      .example("normal");
  u.formula("lower_bound").doc("The least value.").example("5 MPa");
  u.formula("upper_bound").doc("The largest value.").example("15 MPa");
  u.formula("mean").doc("The mean, before bounds cut.").example("9.3 MPa");
  u.formula("std_deviation").doc("The standard deviation, before bounds cut.").example("1 MPa");
  u.formula("scale").doc("Below it lie 63.2 % of the values.").example("10 MPa");
  u.number("shape", unit::none).above(0).doc("The Weibull modulus.").example("8");
  u.text("name").doc("How the summary calls it; the key if absent.").example("strength");

  auto s = schema.section("batch.sampling").doc("How often [[batch.uncertain]] is drawn.");
  s.integer("samples").required().between(1, 100000).doc("Their number.").example("50");
  s.integer("seed").at_least(0).by_default(1).doc("Another seed, other values.");
  s.choice("sample_type", {"random", "lhs"})
      .by_default("random")
      .doc(
          "random: sample i is the same however many there are. lhs (latin hypercube): each key "
          "takes one value of every equal share of its distribution.");
}

void declare_slurm(Schema& schema) {
  auto s = schema.section("batch.slurm").doc("What --slurm asks of the cluster.");
  s.text("partition").doc("The partition.").example("compute");
  s.integer("variants_per_task")
      .between(1, 100000)
      .by_default(1)
      .doc("One after the other: for short runs, and where the length of arrays is limited.");
  s.texts("options")
      .doc("Further options of sbatch, each a #SBATCH line.")
      .example("[\"--account=rock\", \"--mem=4G\"]");
  s.texts("setup")
      .doc("Lines of the shell in front of the run.")
      .example("[\"module load openmpi\"]");
}

void check_values(const Settings& batch, Problems& problems) {
  std::map<std::string, const Settings*> first;
  for (const Settings& vary : batch.list("vary")) {
    std::vector<std::string> values = vary.texts("values");
    if (values.empty()) problems.add(vary.error("values", "the list is empty", "give a value"));
    const std::size_t count = values.size();
    std::sort(values.begin(), values.end());
    const auto twice = std::adjacent_find(values.begin(), values.end());
    // Keys that go together may repeat a value.
    if (!vary.has("together")) {
      if (twice != values.end())
        problems.add(vary.error("values", "the value " + *twice + " stands there twice"));
      continue;
    }
    const Settings& leader = *first.try_emplace(vary.text("together"), &vary).first->second;
    const std::size_t wanted = leader.texts("values").size();
    if (count == wanted) continue;
    problems.add(vary.error("values",
                            "has " + std::to_string(count) + " values, '" + leader.text("key") +
                                "' has " + std::to_string(wanted) + "; they go together",
                            "give both as many, or leave `together` out"));
  }
}

void check_collect(const Settings& batch, Problems& problems) {
  if (!batch.has("collect")) return;
  for (const std::string& entry : batch.texts("collect")) {
    const auto equals = entry.find('=');
    const std::string formula = equals == std::string::npos ? entry : entry.substr(equals + 1);
    try {
      const Expression parsed(formula);
    } catch (const Error& e) {
      problems.add(batch.error("collect", e.cause(), e.remedy()));
    }
  }
}

}  // namespace

void declare_batch_keys(Schema& schema) {
  auto s = schema.section("batch").doc("Many variants of a scene: read by `breccia batch` alone.");
  s.text("scene")
      .names_file()
      .doc("The scene that is varied, where [batch] stands in a file of its own.")
      .example("../scene.toml");
  s.texts("set")
      .doc("Changes to the scene that all variants share, as --set takes them.")
      .example("[\"output.frames = 0\"]");
  s.pairs("collect")
      .doc("What the summary has of each variant beside the checks: expressions as in [[check]].")
      .example("{ peak = \"peak(abs(load.y))\" }");
  s.integer("threads").between(1, 4096).by_default(1).doc("Threads of each variant.");
  s.integer("ranks").between(1, 65536).by_default(1).doc(
      "Ranks of each variant: above one mpirun starts it, in a Slurm job srun.");
  s.number("time_limit", unit::time)
      .above(0)
      .doc(
          "A variant that takes longer by the clock is stopped and has failed; with --slurm the "
          "time that a task asks for.")
      .example("2 h");
  declare_variation(schema);
  declare_slurm(schema);
}

void check_batch_rules(const Settings& scene, Problems& problems) {
  if (!scene.has("batch")) return;
  const Settings& batch = scene.at("batch");
  if (batch.list("vary").empty() && batch.list("uncertain").empty()) {
    problems.add(batch.error("", "nothing is varied",
                             "add a [[batch.vary]] or a [[batch.uncertain]]; docs/batch.md"));
  }
  if (batch.list("uncertain").empty() && batch.has("sampling"))
    problems.add(
        batch.at("sampling")
            .error("", "nothing is drawn at random", "add a [[batch.uncertain]], or leave it out"));
  if (!batch.list("uncertain").empty() && !batch.has("sampling"))
    problems.add(batch.list("uncertain")
                     .front()
                     .error("", "how many samples are drawn is not said",
                            "add [batch.sampling] with samples = 50"));
  check_values(batch, problems);
  check_collect(batch, problems);
}

}  // namespace breccia
