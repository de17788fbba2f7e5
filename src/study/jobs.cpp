#include "study/jobs.hpp"

#include "core/error.hpp"
#include "core/log.hpp"
#include "io/aside_file.hpp"
#include "io/json.hpp"
#include "io/json_reader.hpp"
#include "jobs/outcome.hpp"
#include "jobs/queue.hpp"
#include "scene/interrupt.hpp"

#include <fmt/format.h>

#include <map>
#include <memory>

namespace breccia {

namespace {

namespace fs = std::filesystem;
constexpr const char* kJobFile = "job.json";

/// Why a job has no result; a scene that is to come to rest must have done so.
std::string trouble_in(const Ending& ending, const std::string& folder, const Study& study) {
  const std::string trouble = trouble_of(ending, folder, study.time_limit);
  if (!trouble.empty()) return trouble;
  const Json rest = read_json(folder + "/report.json")["rest"];
  const bool rests = rest.object().empty() || rest["reached"].flag();
  return rests ? "" : "it did not come to rest; give it a longer run.duration";
}

void read_report(const std::string& folder, JobResult& outcome) {
  const Json report = read_json(folder + "/report.json");
  outcome.elements = report["elements"].number();
  outcome.steps = report["steps"].number();
  outcome.res_1 = report["ledger"]["res_1"].number();
  outcome.res_2 = report["ledger"]["res_2"].number();
}

void write_job(const std::string& folder, const Job& job, const JobResult& outcome) {
  JsonWriter json;
  json.begin_object().member("label", job.label).member("identity", job.identity);
  json.member("complete", outcome.complete).member("reason", outcome.reason);
  json.key("wall_seconds").begin_array();
  for (const double s : outcome.wall) json.value(s);
  json.end_array().key("processor_seconds").begin_array();
  for (const double s : outcome.processor) json.value(s);
  json.end_array().end_object();
  write_whole(folder + "/" + kJobFile, json.text());
}

/// Folders of an earlier call by the identity of what they hold.
std::map<std::string, fs::path> earlier(const fs::path& output) {
  std::map<std::string, fs::path> found;
  std::error_code trouble;
  for (const auto& entry : fs::directory_iterator(output, trouble)) {
    const fs::path file = entry.path() / kJobFile;
    if (!fs::exists(file, trouble)) continue;
    try {
      found.emplace(read_json(file.string())["identity"].text(), entry.path());
    } catch (const Error&) {
      continue;  // a damaged file is no result
    }
  }
  return found;
}

class Runner {
 public:
  Runner(const Study& study, const Inspector& inspect)
      : study_(study), inspect_(inspect), queue_(study.side_by_side, study.time_limit) {
    runs_.outcomes.resize(study.jobs.size());
  }

  Runs all() {
    fs::create_directories(study_.output);
    take_over();
    queue_.run([this](std::size_t job) { return start(job); },
               [this](std::size_t job, const Ending& ending) { finish(job, ending); });
    runs_.interrupted = interrupted();
    for (std::size_t i = 0; i < study_.jobs.size(); ++i)
      runs_.outcomes[i] = runs_.outcomes[study_.jobs[i].same_as];
    return std::move(runs_);
  }

 private:
  [[nodiscard]] std::string folder(std::size_t job) const {
    return (study_.output / study_.jobs[job].folder).string();
  }

  /// Results of an earlier call, moved to the number that their job has now.
  void take_over() {
    const auto found = earlier(study_.output);
    for (std::size_t i = 0; i < study_.jobs.size(); ++i) {
      const Job& job = study_.jobs[i];
      if (job.same_as != i) continue;
      const auto at = found.find(job.identity);
      if (at != found.end()) adopt(i, at->second);
      const auto repeats = static_cast<std::size_t>(study_.repeats);
      for (std::size_t r = runs_.outcomes[i].wall.size(); r < repeats; ++r) queue_.add(i);
    }
  }

  void adopt(std::size_t i, const fs::path& where) {
    const fs::path here = folder(i);
    if (where != here && !fs::exists(here)) fs::rename(where, here);
    const fs::path kept = fs::exists(where) ? where : here;
    if (kept != here) return;
    const Json said = read_json((here / kJobFile).string());
    if (!said["complete"].flag() || !fs::exists(here / "report.json")) return;
    JobResult& outcome = runs_.outcomes[i];
    outcome.complete = outcome.reused = true;
    for (const Json& s : said["wall_seconds"].array()) outcome.wall.push_back(s.number());
    for (const Json& s : said["processor_seconds"].array()) outcome.processor.push_back(s.number());
    read_report(here.string(), outcome);
  }

  std::unique_ptr<Process> start(std::size_t i) {
    const Job& job = study_.jobs[i];
    if (!runs_.outcomes[i].reason.empty()) return nullptr;  // a repeat of what has failed
    fs::create_directories(folder(i));
    std::vector<std::string> command{study_.program, "run", study_.scene.string()};
    for (const std::string& option : job.options) {
      command.emplace_back("--set");
      command.push_back(option);
    }
    for (const char* word : {"--quiet", "--overwrite", "--threads"}) command.emplace_back(word);
    command.push_back(std::to_string(study_.threads));
    command.emplace_back("--output");
    command.push_back(folder(i));
    return std::make_unique<Process>(command, folder(i) + "/" + kLogFile);
  }

  void finish(std::size_t job, const Ending& ending) {
    if (interrupted()) return;  // not a result: the next call begins this job anew
    JobResult& outcome = runs_.outcomes[job];
    try {
      outcome.reason = trouble_in(ending, folder(job), study_);
      if (outcome.reason.empty()) {
        read_report(folder(job), outcome);
        outcome.wall.push_back(ending.wall);
        outcome.processor.push_back(ending.processor);
      }
    } catch (const Error& e) {
      outcome.reason = e.what();
    }
    outcome.complete = outcome.reason.empty();
    outcome.reused = false;
    write_job(folder(job), study_.jobs[job], outcome);
    say(job, outcome);
    if (outcome.complete && inspect_) inspect_(job);
  }

  void say(std::size_t job, const JobResult& outcome) {
    const std::string what = outcome.complete ? fmt::format("{:.3g} s", outcome.wall.back())
                                              : "failed: " + outcome.reason;
    log::info(
        fmt::format("{} of {}  {}: {}", job + 1, study_.jobs.size(), study_.jobs[job].label, what));
  }

  const Study& study_;
  const Inspector& inspect_;
  Runs runs_;
  JobQueue queue_;
};

}  // namespace

Runs run_jobs(const Study& study, const Inspector& inspect) {
  return Runner(study, inspect).all();
}

}  // namespace breccia
