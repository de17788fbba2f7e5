#include "jobs/outcome.hpp"

#include "core/log.hpp"
#include "io/json_reader.hpp"

#include <fstream>

namespace breccia {

namespace {

/// The last message of a run, without what follows it.
std::string last_error(const std::string& log) {
  std::ifstream file(log);
  std::string found;
  for (std::string line; std::getline(file, line);)
    if (line.rfind("error: ", 0) == 0) found = line.substr(7);
  return found;
}

}  // namespace

std::string trouble_of(const Ending& ending, const std::string& folder,
                       std::optional<double> time_limit) {
  constexpr int check_failed = 3;
  if (ending.late && time_limit) return "longer than " + duration_text(*time_limit);
  if (ending.signal != 0) return signal_text(ending.signal);
  if (ending.status != 0 && ending.status != check_failed) {
    const std::string said = last_error(folder + "/" + kLogFile);
    return said.empty() ? "exit status " + std::to_string(ending.status) : said;
  }
  const Json report = read_json(folder + "/report.json");
  return report["status"].text() == "complete" ? "" : report["reason"].text();
}

}  // namespace breccia
