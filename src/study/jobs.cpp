#include "study/jobs.hpp"

#include "core/error.hpp"
#include "core/log.hpp"
#include "io/aside_file.hpp"
#include "io/json.hpp"
#include "io/json_reader.hpp"
#include "scene/interrupt.hpp"
#include "study/process.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <fstream>
#include <map>
#include <memory>
#include <thread>

namespace breccia {

namespace {

namespace fs = std::filesystem;
constexpr const char* kJobFile = "job.json";
constexpr double kPatience = 30;  // s that a job has to stop when it is asked to

/// The last message of a run, without what follows it.
std::string last_error(const std::string& log) {
  std::ifstream file(log);
  std::string found;
  for (std::string line; std::getline(file, line);)
    if (line.rfind("error: ", 0) == 0) found = line.substr(7);
  return found;
}

/// Why a run has no result; empty where it has one.
std::string trouble_of(const Ending& ending, const std::string& folder) {
  if (ending.signal != 0) return signal_text(ending.signal);
  if (ending.status != 0 && ending.status != 3) {  // 3: a check failed, which is a result
    const std::string said = last_error(folder + "/log.txt");
    return said.empty() ? fmt::format("exit status {}", ending.status) : said;
  }
  const Json report = read_json(folder + "/report.json");
  if (report["status"].text() != "complete") return report["reason"].text();
  const bool rests = report["rest"].object().empty() || report["rest"]["reached"].flag();
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
  Runner(const Study& study, const Inspector& inspect) : study_(study), inspect_(inspect) {
    runs_.outcomes.resize(study.jobs.size());
  }

  Runs all() {
    fs::create_directories(study_.output);
    take_over();
    watch_for_interrupt();
    while (!waiting_.empty() || !running_.empty()) {
      if (interrupted() && !runs_.interrupted) stop();
      while (!runs_.interrupted && !waiting_.empty() &&
             running_.size() < static_cast<std::size_t>(study_.side_by_side)) {
        start(waiting_.front());
        waiting_.pop_front();
      }
      if (running_.empty()) break;
      look();
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    for (std::size_t i = 0; i < study_.jobs.size(); ++i)
      runs_.outcomes[i] = runs_.outcomes[study_.jobs[i].same_as];
    return std::move(runs_);
  }

 private:
  struct Running {
    std::size_t job;
    std::unique_ptr<Process> process;
    bool late = false;
  };

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
      for (std::size_t r = runs_.outcomes[i].wall.size(); r < repeats; ++r) waiting_.push_back(i);
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

  void start(std::size_t i) {
    const Job& job = study_.jobs[i];
    if (!runs_.outcomes[i].reason.empty()) return;  // a repeat of what has failed
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
    running_.push_back({i, std::make_unique<Process>(command, folder(i) + "/log.txt"), false});
  }

  void look() {
    for (std::size_t r = 0; r < running_.size();) {
      Running& one = running_[r];
      one.late = study_.time_limit && one.process->seconds() > *study_.time_limit;
      if (one.late || (runs_.interrupted && since_stop() > kPatience)) one.process->kill();
      const auto ending = one.process->ended();
      if (!ending) {
        ++r;
        continue;
      }
      finish(one, *ending);
      running_.erase(running_.begin() + static_cast<std::ptrdiff_t>(r));
    }
  }

  void finish(const Running& one, const Ending& ending) {
    if (runs_.interrupted || interrupted())
      return;  // not a result: the next call begins this job anew
    JobResult& outcome = runs_.outcomes[one.job];
    try {
      outcome.reason = one.late ? fmt::format("longer than {}", duration_text(*study_.time_limit))
                                : trouble_of(ending, folder(one.job));
      if (outcome.reason.empty()) {
        read_report(folder(one.job), outcome);
        outcome.wall.push_back(ending.wall);
        outcome.processor.push_back(ending.processor);
      }
    } catch (const Error& e) {
      outcome.reason = e.what();
    }
    outcome.complete = outcome.reason.empty();
    outcome.reused = false;
    write_job(folder(one.job), study_.jobs[one.job], outcome);
    say(one.job, outcome);
    if (outcome.complete && inspect_) inspect_(one.job);
  }

  void say(std::size_t job, const JobResult& outcome) {
    const std::string what = outcome.complete ? fmt::format("{:.3g} s", outcome.wall.back())
                                              : "failed: " + outcome.reason;
    log::info(
        fmt::format("{} of {}  {}: {}", job + 1, study_.jobs.size(), study_.jobs[job].label, what));
  }

  void stop() {
    runs_.interrupted = true;
    stopped_ = Clock::now();
    for (const Running& one : running_) one.process->interrupt();
  }

  [[nodiscard]] double since_stop() const {
    return std::chrono::duration<double>(Clock::now() - stopped_).count();
  }

  using Clock = std::chrono::steady_clock;
  const Study& study_;
  const Inspector& inspect_;
  Runs runs_;
  std::deque<std::size_t> waiting_;
  std::vector<Running> running_;
  Clock::time_point stopped_;
};

}  // namespace

Runs run_jobs(const Study& study, const Inspector& inspect) {
  return Runner(study, inspect).all();
}

}  // namespace breccia
