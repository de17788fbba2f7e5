#pragma once
#include <chrono>
#include <string>
#include <string_view>

namespace breccia {

/// Plain lines for people: no time stamps, no levels, colour only on a terminal.
namespace log {

/// Silences everything but warnings.
void set_quiet(bool quiet);
[[nodiscard]] bool quiet();
/// Silences everything: of many ranks one speaks.
void set_silent(bool silent);
[[nodiscard]] bool on_terminal();

void info(std::string_view line);     ///< to standard output
void warning(std::string_view line);  ///< to standard error, "warning: " in front
void error(std::string_view text);    ///< to standard error, "error: " in front

}  // namespace log

/// "3 min 20 s", "0.8 s", "2 h 5 min".
std::string duration_text(double seconds);

/// Progress of a run: one rewritten line on a terminal, otherwise a plain line at each tenth.
class Progress {
 public:
  /// `total` in any unit (simulated seconds); `unit_name` names what the rate counts ("steps").
  Progress(double total, std::string unit_name);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `done` of `total`, and how many units were made so far. Cheap; prints when it is time to.
  void update(double done, double count);
  void finish();

  /// The line that update would print now: "42 %  1234 steps  5.1e+03 steps/s  12 s left".
  [[nodiscard]] std::string line(double done, double count, double elapsed_seconds) const;

 private:
  using Clock = std::chrono::steady_clock;
  double total_;
  std::string unit_name_;
  Clock::time_point start_, last_;
  int tenth_ = 0;
  bool open_line_ = false;
};

}  // namespace breccia
