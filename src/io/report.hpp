#pragma once

#include <cstdint>
#include <iosfwd>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace breccia {

/// What a run has to tell at its end: report.json, and the same as a table.
struct Report {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();  ///< written as null

  struct TimeStep {
    double min = kNone, mean = kNone, max = kNone;  ///< [s]
    double added_mass = 0;  ///< share of the whole that mass scaling has added
    std::string set_by;     ///< element, interface, contact, ... with its place
  };
  struct Interfaces {
    std::int64_t bonded = 0, inserted = 0, released = 0;
  };
  /// Of a run that was to come to rest.
  struct Rest {
    bool wanted = false, reached = false;
    double time = kNone;                       ///< [s] when
    double unbalance = kNone, motion = kNone;  ///< shares of forces and energies at the last look
  };
  /// What the looks of [run.guard] saw.
  struct Guard {
    std::int64_t looks = 0;
    double made = 0;     ///< largest energy from nowhere, over the largest energy in play
    double overlap = 0;  ///< deepest, in heights of the elements at the face
  };
  struct Effect {
    std::string name;
    double seconds = 0;
    std::int64_t bytes = 0, launches = 0;
  };
  struct Check {
    std::string name;
    double value = kNone, reference = kNone;
    double tolerance = 0;  ///< in the unit of the value, or a share of the reference
    bool relative = true;  ///< how `tolerance` is meant
    bool pass = false;
    std::string unit;
    std::string note;  ///< why there is no value, say
  };
  struct Version {
    std::string release, commit, build;
  };

  std::string title;
  std::string status;  ///< complete, stopped or failed
  std::string reason;  ///< empty when complete
  std::int64_t steps = 0;
  double time = 0;  ///< [s] simulated
  double wall_seconds = 0;
  int threads = 1, ranks = 1;
  std::string backend;    ///< Serial, OpenMP, Cuda, ...
  std::string precision;  ///< double or mixed
  std::int64_t elements = 0, nodes = 0;
  double element_steps_per_second = 0;
  TimeStep time_step;
  Interfaces interfaces;
  std::int64_t fragments = 0;
  Rest rest;
  Guard guard;
  std::vector<std::pair<std::string, double>>
      ledger;                           ///< [J] energies by their name in A-13.8, in order
  double res_1 = kNone, res_2 = kNone;  ///< relative residuals of the ledger (A-8.6)
  std::vector<Effect> effects;
  std::vector<std::string> effects_off;                 ///< those that the scene does not call for
  std::vector<std::pair<std::string, double>> numbers;  ///< what [[check]] calls by name
  std::vector<Check> checks;
  std::int64_t peak_memory_bytes = 0;
  std::string state_hash;
  Version version;
};

/// The text of report.json.
std::string report_json(const Report& report);

/// Writes report.json whole or not at all. Throws Error.
void write_report(const Report& report, const std::string& path);

/// Prints the report as a table: run, time step, cost sheet, ledger, checks.
void print_report(const Report& report, std::ostream& out);

}  // namespace breccia
