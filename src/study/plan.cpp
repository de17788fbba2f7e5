#include "study/plan.hpp"

#include "core/expression.hpp"
#include "core/text.hpp"
#include "io/number_table.hpp"
#include "jobs/identity.hpp"
#include "jobs/knobs.hpp"
#include "jobs/source.hpp"
#include "scene/commands.hpp"
#include "study/ladder.hpp"
#include "study/solutions.hpp"

#include <algorithm>

namespace breccia {

namespace {

namespace fs = std::filesystem;
using Options = std::vector<std::string>;

/// Tables lie beside the file of the study, which need not be that of the scene.
void place_tables(SceneSource& source) {
  Config* quantities = source.section().find("quantity");
  if (source.file() == source.scene() || quantities == nullptr ||
      !quantities->is(Config::Kind::array))
    return;
  for (Config& quantity : quantities->array()) {
    Config* table = quantity.find("table");
    if (table == nullptr || !table->is(Config::Kind::text)) continue;
    const fs::path beside = fs::absolute(source.file()).parent_path() / table->text();
    *table = Config(beside.lexically_normal().string(), table->place());
  }
}

Knob read_knob(const Settings& section, const Config& scene) {
  Knob knob;
  const char* key = section.has("keys") ? "keys" : "key";
  const auto keys = section.has("keys") ? section.texts("keys") : Options{section.text("key")};
  try {
    for (const std::string& path : keys) {
      const auto found = knob_paths(path, scene);
      knob.paths.insert(knob.paths.end(), found.begin(), found.end());
    }
  } catch (const Error& e) {
    throw section.error(key, e.cause(), e.remedy());
  }
  const std::string& first = keys.front();
  knob.name = first.find('.') == std::string::npos ? first : key_path(first).back();
  knob.name = section.text_or("name", knob.name);
  knob.rungs = knob.words = section.texts("values");
  std::vector<double> numbers;
  if (section.has("sizes")) {
    numbers = section.vector("sizes");
    std::transform(numbers.begin(), numbers.end(), knob.words.begin(), number_text);
  } else {
    for (const std::string& rung : knob.rungs) numbers.push_back(rung_number(rung));
  }
  knob.sizes = falling_sizes(numbers);
  return knob;
}

Curve read_curve(const Settings& section) {
  const NumberTable table = read_number_table(section.text("table"));
  Curve curve;
  for (const auto& row : table.rows) {
    if (row.size() != 2) throw section.error("table", "the table has not two columns");
    if (!curve.x.empty() && !(row[0] > curve.x.back()))
      throw section.error("table", "its first column does not grow at " + number_text(row[0]));
    curve.x.push_back(row[0]);
    curve.y.push_back(row[1]);
  }
  if (curve.x.size() < 2) throw section.error("table", "a curve has at least two points");
  return curve;
}

void read_reference(const Settings& section, Judged& judged) {
  if (section.has("solution")) {
    const Options none;
    try {
      judged.reference =
          number_text(solve(section.text("solution"),
                            section.has("parameters") ? section.texts("parameters") : none));
    } catch (const Error& e) {
      throw section.error("solution", e.cause(), e.remedy());
    }
    for (const Solution& s : solutions())
      if (s.name == section.text("solution") && judged.source.empty()) judged.source = s.source;
  } else if (section.has("table")) {
    judged.against = Judged::Against::curve;
    judged.table = read_curve(section);
    judged.curve_x = section.text_or("against", "time");
  } else if (section.has("reference")) {
    judged.reference = section.text("reference");
  }
  if (judged.reference == "finest") judged.against = Judged::Against::finest;
}

/// A reference without names of results must have a value now.
void check_reference(const Settings& section, const Judged& judged) {
  const bool formula = judged.against == Judged::Against::value;
  if (!formula || !Expression(judged.reference).names().empty()) return;
  const char* key = section.has("reference") ? "reference"
                    : section.has("check")   ? "check"
                                             : "solution";
  double value = 0;
  try {
    value = Expression(judged.reference).evaluate({});
  } catch (const Error& e) {
    throw section.error(key, "the reference cannot be evaluated: " + e.cause(), e.remedy());
  }
  if (value == 0 && judged.scale.empty()) {
    throw section.error(key, "the reference is 0, of which an error cannot be a share",
                        "add scale, a size that errors are measured by");
  }
}

Judged read_quantity(const Settings& section, const Settings& scene) {
  Judged judged;
  judged.scale = section.text_or("scale", "");
  judged.source = section.text_or("source", "");
  if (section.has("check")) {
    const Settings& check = *scene.find("check", section.text("check"));
    judged.check = check.text("name");
    judged.value = check.text("value");
    judged.reference = check.text("reference");
    judged.source = judged.source.empty() ? check.text_or("source", "") : judged.source;
  } else {
    judged.value = section.text(section.has("curve") ? "curve" : "value");
  }
  judged.name = section.text_or("name", judged.check.empty() ? judged.value : judged.check);
  read_reference(section, judged);
  check_reference(section, judged);
  return judged;
}

/// Resolves a job; what is wrong with it is told at the place of its knobs.
void settle(Job& job, const Study& study, const SceneSource& source, const Schema& schema,
            const Settings& section) {
  try {
    job.identity =
        job_identity(schema.resolve(source.read(job.options)), std::to_string(study.threads));
  } catch (const Error& e) {
    throw Error(section.place(),
                "study: the job '" + job.label + "' is no right scene: " + e.cause(), e.remedy());
  }
}

void read_options(const Settings& section, const StudyRequest& request, Study& study) {
  study.program = request.program;
  study.threads = request.threads;
  study.side_by_side = request.jobs;
  study.repeats =
      request.repeats > 0 ? request.repeats : static_cast<int>(section.integer("repeats"));
  study.by_processor = section.text("cost") == "processor";
  study.time_limit = section.maybe_number("time_limit");
}

}  // namespace

Study plan_study(const StudyRequest& request) {
  SceneSource source("study", request.scene, request.options);
  place_tables(source);
  Schema schema;
  declare_schema(schema);
  const Settings scene = schema.resolve(source.whole());
  const Settings& section = scene.at("study");
  Study study;
  read_options(section, request, study);
  study.title = scene.text_or("title", "");
  study.name = source.name();
  study.scene = source.scene();
  study.output = request.output ? *request.output : fs::path(study.name + ".study");
  const Config base = source.read({});
  for (const Settings& knob : section.list("knob")) study.knobs.push_back(read_knob(knob, base));
  for (const Settings& quantity : section.list("quantity"))
    study.quantities.push_back(read_quantity(quantity, scene));
  study.jobs = climb(study.knobs, section.text("walk") == "product");
  for (Job& job : study.jobs) settle(job, study, source, schema, section);
  number_jobs(study.jobs);
  for (Job& job : study.jobs)
    job.options.insert(job.options.begin(), source.shared().begin(), source.shared().end());
  return study;
}

}  // namespace breccia
