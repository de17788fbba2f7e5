#include "io/report.hpp"

#include "io/aside_file.hpp"
#include "io/json.hpp"

namespace breccia {
namespace {

void put_run(JsonWriter& json, const Report& r) {
  json.member("title", r.title)
      .member("status", r.status)
      .member("reason", r.reason)
      .member("steps", r.steps)
      .member("time", r.time)
      .member("wall_seconds", r.wall_seconds)
      .member("threads", r.threads)
      .member("ranks", r.ranks)
      .member("backend", r.backend)
      .member("precision", r.precision)
      .member("elements", r.elements)
      .member("nodes", r.nodes)
      .member("element_steps_per_second", r.element_steps_per_second);
}

void put_counts(JsonWriter& json, const Report& r) {
  json.key("time_step").begin_object();
  json.member("min", r.time_step.min)
      .member("mean", r.time_step.mean)
      .member("max", r.time_step.max);
  json.member("added_mass", r.time_step.added_mass);
  json.member("set_by", r.time_step.set_by).end_object();
  json.key("interfaces").begin_object();
  json.member("bonded", r.interfaces.bonded).member("inserted", r.interfaces.inserted);
  json.member("released", r.interfaces.released).end_object();
  json.member("fragments", r.fragments);
  json.key("guard").begin_object();
  json.member("looks", r.guard.looks).member("made", r.guard.made);
  json.member("overlap", r.guard.overlap).end_object();
  if (!r.rest.wanted) return;
  json.key("rest").begin_object();
  json.member("reached", r.rest.reached).member("time", r.rest.time);
  json.member("unbalance", r.rest.unbalance).member("motion", r.rest.motion).end_object();
}

void put_ledger(JsonWriter& json, const Report& r) {
  json.key("ledger").begin_object();
  for (const auto& [name, energy] : r.ledger) json.member(name, energy);
  json.member("res_1", r.res_1).member("res_2", r.res_2).end_object();
}

void put_effects(JsonWriter& json, const Report& r) {
  json.key("effects").begin_object();
  for (const Report::Effect& effect : r.effects) {
    json.key(effect.name).begin_object();
    json.member("seconds", effect.seconds)
        .member("share", r.wall_seconds > 0 ? effect.seconds / r.wall_seconds : Report::kNone);
    json.member("bytes", effect.bytes).member("launches", effect.launches).end_object();
  }
  json.end_object();
  json.key("effects_off").begin_array();
  for (const std::string& name : r.effects_off) json.value(name);
  json.end_array();
}

void put_numbers(JsonWriter& json, const Report& r) {
  json.key("numbers").begin_object();
  for (const auto& [name, value] : r.numbers) json.member(name, value);
  json.end_object();
}

void put_checks(JsonWriter& json, const Report& r) {
  json.key("checks").begin_array();
  for (const Report::Check& check : r.checks) {
    json.begin_object().member("name", check.name).member("value", check.value);
    json.member("reference", check.reference).member("tolerance", check.tolerance);
    json.member("tolerance_kind", check.relative ? "relative" : "absolute")
        .member("unit", check.unit);
    json.member("pass", check.pass);
    if (!check.note.empty()) json.member("note", check.note);
    json.end_object();
  }
  json.end_array();
}

}  // namespace

std::string report_json(const Report& report) {
  JsonWriter json;
  json.begin_object();
  put_run(json, report);
  put_counts(json, report);
  put_ledger(json, report);
  put_effects(json, report);
  put_numbers(json, report);
  put_checks(json, report);
  json.member("peak_memory_bytes", report.peak_memory_bytes)
      .member("state_hash", report.state_hash);
  json.key("version").begin_object();
  json.member("release", report.version.release).member("commit", report.version.commit);
  json.member("build", report.version.build).end_object();
  json.end_object();
  return json.text();
}

void write_report(const Report& report, const std::string& path) {
  write_whole(path, report_json(report));
}

}  // namespace breccia
