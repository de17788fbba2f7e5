#include "batch/slurm.hpp"

#include "core/error.hpp"
#include "core/text.hpp"
#include "io/aside_file.hpp"
#include "io/json.hpp"
#include "io/json_reader.hpp"
#include "jobs/process.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <numeric>
#include <sstream>

namespace breccia {

namespace {

namespace fs = std::filesystem;

/// A word of the shell, whatever is in it.
std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

/// "[days-]hours:minutes:seconds" of sbatch.
std::string time_text(double seconds) {
  const auto whole = static_cast<long>(std::ceil(seconds));
  constexpr long minute = 60, hour = 3600, day = 24 * hour;
  return fmt::format("{}-{:02}:{:02}:{:02}", whole / day, whole % day / hour, whole % hour / minute,
                     whole % minute);
}

fs::path folder_of(const Sweep& sweep) {
  return fs::absolute(sweep.output) / "slurm";
}

/// What a command of Slurm prints. \throws Error when there is no such command.
std::string answer(const Sweep& sweep, const std::vector<std::string>& command, Ending& ending) {
  const fs::path said = folder_of(sweep) / (command.front() + ".txt");
  try {
    ending = Process(command, said.string()).wait();
  } catch (const Error& e) {
    throw Error(command.front(), e.cause(),
                "Slurm is not on this machine: submit where it is, or leave --slurm out to run "
                "the variants here");
  }
  std::ifstream file(said);
  std::ostringstream text;
  text << file.rdbuf();
  return trimmed(text.str());
}

/// Numbers of the tasks that take so many variants each.
std::vector<std::size_t> tasks_of(std::size_t variants, int each) {
  std::vector<std::size_t> tasks((variants - 1) / static_cast<std::size_t>(each) + 1);
  std::iota(tasks.begin(), tasks.end(), 0);
  return tasks;
}

fs::path job_file(const Sweep& sweep) {
  return folder_of(sweep) / "job.json";
}

}  // namespace

std::string array_text(const std::vector<std::size_t>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    text += (text.empty() ? "" : ",") + std::to_string(numbers[i]);
    if (last > i) text += "-" + std::to_string(numbers[last]);
    i = last + 1;
  }
  return text;
}

std::string slurm_script(const Sweep& sweep, const BatchRequest& request,
                         const std::vector<std::size_t>& numbers) {
  const fs::path output = fs::absolute(sweep.output).lexically_normal();
  const int each = sweep.slurm.variants_per_task;
  std::string text = "#!/bin/bash\n";
  const auto option = [&text](const std::string& words) { text += "#SBATCH " + words + "\n"; };
  option("--job-name=" + quoted(sweep.name));
  option("--array=" + array_text(each > 1 ? tasks_of(numbers.size(), each) : numbers) +
         (request.jobs > 0 ? "%" + std::to_string(request.jobs) : ""));
  option("--ntasks=" + std::to_string(sweep.ranks));
  option("--cpus-per-task=" + std::to_string(sweep.threads));
  if (sweep.time_limit) option("--time=" + time_text(each * *sweep.time_limit));
  if (!sweep.slurm.partition.empty()) option("--partition=" + sweep.slurm.partition);
  option("--chdir=" + quoted(fs::current_path().string()));
  option("--output=" + quoted((output / "slurm" / "%A_%a.txt").string()));
  for (const std::string& words : sweep.slurm.options) option(words);
  text += "\n";
  for (const std::string& line : sweep.slurm.setup) text += line + "\n";
  std::string variants = "--variant=$SLURM_ARRAY_TASK_ID";
  if (each > 1) {
    text += "all=(";
    for (const std::size_t number : numbers) text += " --variant=" + std::to_string(number);
    text += " )\n";
    variants = fmt::format("${{all[@]:SLURM_ARRAY_TASK_ID*{0}:{0}}}", each);
  }
  text += "exec " + quoted(sweep.program) + " batch " +
          quoted(fs::absolute(sweep.file).lexically_normal().string()) + " \"" + variants +
          "\" --jobs 1 --output " + quoted(output.string()) + " --threads " +
          std::to_string(sweep.threads);
  for (const std::string& words : request.options) text += " --set " + quoted(words);
  return text + "\n";
}

fs::path write_slurm_script(const Sweep& sweep, const BatchRequest& request,
                            const std::vector<std::size_t>& numbers) {
  const fs::path script = folder_of(sweep) / "array.sh";
  fs::create_directories(script.parent_path());
  write_whole(script.string(), slurm_script(sweep, request, numbers));
  return script;
}

std::string submit(const Sweep& sweep, const fs::path& script) {
  Ending ending;
  const std::string said = answer(sweep, {"sbatch", "--parsable", script.string()}, ending);
  if (ending.status != 0 || ending.signal != 0 || said.empty())
    throw Error("sbatch", "Slurm has refused the job: " + said, "the script is " + script.string());
  // Warnings come first; the last line is "job" or "job;cluster".
  const std::string last = split(said, '\n').back();
  const std::string job = trimmed(last.substr(0, last.find(';')));
  JsonWriter json;
  json.begin_object().member("job", job).end_object();
  write_whole(job_file(sweep).string(), json.text());
  return job;
}

std::optional<std::string> slurm_job(const Sweep& sweep) {
  std::error_code trouble;
  if (!fs::exists(job_file(sweep), trouble)) return std::nullopt;
  return read_json(job_file(sweep).string())["job"].text();
}

void forget_slurm_job(const Sweep& sweep) {
  fs::remove(job_file(sweep));
}

bool in_queue(const Sweep& sweep, const std::string& job) {
  Ending ending;
  const std::string said =
      answer(sweep, {"squeue", "--noheader", "--jobs=" + job, "--format=%i"}, ending);
  if (ending.status == 0 && ending.signal == 0) return !said.empty();
  if (said.find("Invalid job id") != std::string::npos) return false;  // gone for some minutes
  throw Error("squeue", "Slurm does not answer: " + said,
              "try again; if job " + job + " is gone for good, remove " + job_file(sweep).string());
}

}  // namespace breccia
