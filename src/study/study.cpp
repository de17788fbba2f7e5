#include "study/study.hpp"

#include "core/error.hpp"
#include "core/log.hpp"
#include "io/aside_file.hpp"
#include "study/picture.hpp"
#include "study/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace breccia {

namespace {

int list_jobs(const Study& study) {
  for (const Job& job : study.jobs) {
    const std::string twin = study.jobs[job.same_as].label == job.label
                                 ? ""
                                 : "  same as " + study.jobs[job.same_as].label;
    std::cout << job.label << twin << "\n";
  }
  return 0;
}

/// The first finished job shows a name that no job knows, before all others have run. A formula
/// without a value there, such as an arrival on a mesh too coarse, may have one in others.
Inspector first_look(const Study& study) {
  return [&study, seen = false](std::size_t job) mutable {
    if (seen) return;
    seen = true;
    for (const Judged& judged : study.quantities) {
      try {
        check_names(judged, study.output / study.jobs[job].folder);
      } catch (const Error& e) {
        throw Error("study.quantity",
                    judged.name + ": cannot be evaluated in the job '" + study.jobs[job].label +
                        "': " + e.cause(),
                    e.remedy());
      }
    }
  };
}

/// Tells why a quantity has nothing to teach.
bool says_nothing(const Judged& judged, const Findings& findings) {
  const auto finite = [](double v) { return std::isfinite(v); };
  const auto& values = findings.value;
  const auto first = std::find_if(values.begin(), values.end(), finite);
  if (first == values.end()) {
    const auto spoken = [](const std::string& note) { return !note.empty(); };
    const auto note = std::find_if(findings.note.begin(), findings.note.end(), spoken);
    log::error(judged.name + ": has a value in no job" +
               (note == findings.note.end() ? "" : ": " + *note));
    return true;
  }
  if (!findings.constant) return false;
  log::error(
      fmt::format("{}: the value is {:.6g} in all jobs; the knobs do not move it\n  choose a "
                  "quantity that the knobs change, or knobs that change the quantity",
                  judged.name, *first));
  return true;
}

int verdict(const Study& study, const Runs& runs, const std::vector<Findings>& findings) {
  const auto complete = [](const JobResult& o) { return o.complete; };
  const auto done = std::count_if(runs.outcomes.begin(), runs.outcomes.end(), complete);
  if (done < static_cast<std::ptrdiff_t>(study.jobs.size()))
    log::warning(fmt::format("{} of {} jobs have no result; they are tried again by the next call",
                             static_cast<std::ptrdiff_t>(study.jobs.size()) - done,
                             study.jobs.size()));
  if (done == 0) {
    log::error("no job is complete\n  log.txt in the folder of a job says why it ended");
    return 1;
  }
  for (std::size_t q = 0; q < findings.size(); ++q)
    if (says_nothing(study.quantities[q], findings[q])) return 1;
  return 0;
}

}  // namespace

int study_scene(const StudyRequest& request) {
  const Study study = plan_study(request);
  if (request.list) return list_jobs(study);
  log::info(fmt::format("{}: {} jobs in {}, {} thread{} each", study.name, study.jobs.size(),
                        study.output.string(), study.threads, study.threads == 1 ? "" : "s"));
  const Runs runs = run_jobs(study, first_look(study));
  std::vector<Findings> findings;
  for (const Judged& judged : study.quantities) findings.push_back(find(study, judged, runs));
  write_whole((study.output / "study.csv").string(), study_csv(study, runs, findings));
  write_whole((study.output / "study.json").string(), study_json(study, runs, findings));
  if (runs.interrupted) {
    log::error("interrupted; finished jobs are kept, the same command goes on with the others");
    return 1;
  }
  if (!request.quiet) {
    for (std::size_t q = 0; q < findings.size(); ++q)
      print_findings(study, study.quantities[q], runs, findings[q], std::cout);
  }
  const int status = verdict(study, runs, findings);
  if (status == 0) draw_picture(study);
  return status;
}

}  // namespace breccia
