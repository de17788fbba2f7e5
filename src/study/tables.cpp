#include "study/tables.hpp"

#include "core/build_info.hpp"
#include "io/json.hpp"
#include "jobs/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace breccia {

namespace {

double least(const std::vector<double>& values) {
  return values.empty() ? JobResult::kNone : *std::min_element(values.begin(), values.end());
}
double most(const std::vector<double>& values) {
  return values.empty() ? JobResult::kNone : *std::max_element(values.begin(), values.end());
}

std::string state_of(const JobResult& outcome) {
  return outcome.complete ? "complete" : outcome.reason.empty() ? "not run" : "failed";
}

std::string rung_of(const Study& study, const Job& job, std::size_t knob) {
  return job.rung[knob] < 0 ? ""
                            : study.knobs[knob].words[static_cast<std::size_t>(job.rung[knob])];
}

std::string seconds_text(const Study& study, const JobResult& outcome) {
  const auto& all = study.by_processor ? outcome.processor : outcome.wall;
  const std::string middle = fmt::format("{:.3g}", median(all));
  return all.size() < 2 ? middle
                        : fmt::format("{} ({:.3g} to {:.3g})", middle, least(all), most(all));
}

void put_seconds(JsonWriter& json, const char* name, const std::vector<double>& values) {
  json.key(name).begin_object().member("median", median(values));
  json.member("min", least(values)).member("max", most(values)).key("each").begin_array();
  for (const double s : values) json.value(s);
  json.end_array().end_object();
}

void put_knobs(JsonWriter& json, const Study& study) {
  json.key("knobs").begin_array();
  for (const Knob& knob : study.knobs) {
    json.begin_object().member("name", knob.name).key("keys").begin_array();
    for (const std::string& path : knob.paths) json.value(path);
    json.end_array().key("values").begin_array();
    for (const std::string& word : knob.words) json.value(word);
    json.end_array().member("numeric", !knob.sizes.empty()).end_object();
  }
  json.end_array();
}

void put_jobs(JsonWriter& json, const Study& study, const Runs& runs) {
  json.key("jobs").begin_array();
  for (std::size_t j = 0; j < study.jobs.size(); ++j) {
    const Job& job = study.jobs[j];
    const JobResult& o = runs.outcomes[j];
    json.begin_object().member("label", job.label).member("folder", job.folder);
    json.key("rungs").begin_array();
    for (std::size_t k = 0; k < study.knobs.size(); ++k) json.value(rung_of(study, job, k));
    json.end_array().member("state", state_of(o)).member("reason", o.reason);
    json.member("elements", o.elements).member("steps", o.steps);
    json.member("element_steps", o.element_steps());
    put_seconds(json, "wall_seconds", o.wall);
    put_seconds(json, "processor_seconds", o.processor);
    json.member("res_1", o.res_1).member("res_2", o.res_2).end_object();
  }
  json.end_array();
}

template <class T>
void put_list(JsonWriter& json, const char* name, const std::vector<T>& values) {
  json.key(name).begin_array();
  for (const auto& value : values) json.value(static_cast<T>(value));
  json.end_array();
}

void put_findings(JsonWriter& json, const Study& study, const Judged& judged, const Runs& runs,
                  const Findings& f) {
  json.begin_object().member("name", judged.name).member("value", judged.value);
  json.member("reference", f.basis).member("source", judged.source);
  put_list(json, "values", f.value);
  put_list(json, "references", f.reference);
  put_list(json, "errors", f.error);
  put_list(json, "notes", f.note);
  put_list(json, "front", f.front);
  json.key("lines").begin_array();
  for (const Line& line : f.lines) {
    json.begin_object().member("knob", study.knobs[line.knob].name).member("others", line.others);
    json.member("order", line.order)
        .member("order_over_all", line.fitted)
        .member("falls", line.moves)
        .end_object();
  }
  json.end_array().key("cheapest").begin_array();
  for (const Target& target : f.targets) {
    json.begin_object().member("error", target.error).key("job");
    target.job ? json.value(static_cast<std::int64_t>(*target.job)) : json.null();
    json.end_object();
  }
  json.end_array();
  put_list(json, "sentences", sentences(study, judged, runs, f));
  json.end_object();
}

}  // namespace

void print_findings(const Study& study, const Judged& judged, const Runs& runs, const Findings& f,
                    std::ostream& out) {
  out << "\n"
      << judged.name << "  against " << f.basis
      << (judged.source.empty() ? "" : " (" + judged.source + ")") << "\n";
  std::vector<TableRow> rows{{"job", "elements", "steps", "value", "error [%]",
                              study.by_processor ? "processor [s]" : "wall [s]", ""}};
  for (std::size_t j = 0; j < study.jobs.size(); ++j) {
    const JobResult& o = runs.outcomes[j];
    if (!o.complete) {
      rows.push_back({study.jobs[j].label, "-", "-", "-", "-", "-",
                      o.reason.empty() ? "not run" : "failed: " + o.reason});
      continue;
    }
    rows.push_back({study.jobs[j].label, fmt::format("{:.0f}", o.elements),
                    fmt::format("{:.0f}", o.steps), fmt::format("{:.6g}", f.value[j]),
                    fmt::format("{:.3g}", 100 * f.error[j]), seconds_text(study, o),
                    f.note[j].empty() ? (f.front[j] ? "* front" : "") : f.note[j]});
  }
  print_rows(rows, out);
  for (const std::string& sentence : sentences(study, judged, runs, f))
    out << "  " << sentence << "\n";
}

std::string study_csv(const Study& study, const Runs& runs, const std::vector<Findings>& findings) {
  std::string text = "folder";
  for (const Knob& knob : study.knobs) text += "," + csv_cell(knob.name);
  text += ",state,elements,steps,element_steps,wall_median,wall_min,wall_max";
  text += ",processor_median,processor_min,processor_max,res_1,res_2";
  for (const Judged& judged : study.quantities)
    for (const char* what : {"value", "reference", "error", "front"})
      text += "," + csv_cell(judged.name + ": " + what);
  text += ",reason\n";
  for (std::size_t j = 0; j < study.jobs.size(); ++j) {
    const JobResult& o = runs.outcomes[j];
    text += study.jobs[j].folder;
    for (std::size_t k = 0; k < study.knobs.size(); ++k)
      text += "," + csv_cell(rung_of(study, study.jobs[j], k));
    text += "," + state_of(o);
    for (const double x :
         {o.elements, o.steps, o.element_steps(), median(o.wall), least(o.wall), most(o.wall),
          median(o.processor), least(o.processor), most(o.processor), o.res_1, o.res_2})
      text += "," + csv_cell(x);
    for (const Findings& f : findings)
      text += "," + csv_cell(f.value[j]) + "," + csv_cell(f.reference[j]) + "," +
              csv_cell(f.error[j]) + "," + (f.front[j] ? "1" : "0");
    text += "," + csv_cell(o.reason) + "\n";
  }
  return text;
}

std::string study_json(const Study& study, const Runs& runs,
                       const std::vector<Findings>& findings) {
  JsonWriter json;
  json.begin_object().member("title", study.title).member("name", study.name);
  json.member("threads", study.threads).member("repeats", study.repeats);
  json.member("cost", study.by_processor ? "processor" : "wall");
  json.member("version", build_info().version).member("commit", build_info().commit);
  put_knobs(json, study);
  put_jobs(json, study, runs);
  json.key("quantities").begin_array();
  for (std::size_t q = 0; q < findings.size(); ++q)
    put_findings(json, study, study.quantities[q], runs, findings[q]);
  json.end_array().end_object();
  return json.text();
}

}  // namespace breccia
