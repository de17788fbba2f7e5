#include "core/log.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace breccia {

namespace log {

namespace {

bool is_quiet = false, is_silent = false;

void put(std::FILE* file, std::string_view front, std::string_view text) {
  if (is_silent) return;
  std::fwrite(front.data(), 1, front.size(), file);
  std::fwrite(text.data(), 1, text.size(), file);
  std::fputc('\n', file);
  std::fflush(file);  // a killed run leaves its last line
}

}  // namespace

void set_quiet(bool quiet) {
  is_quiet = quiet;
}
bool quiet() {
  return is_quiet || is_silent;
}
void set_silent(bool silent) {
  is_silent = silent;
}
bool on_terminal() {
  return isatty(STDOUT_FILENO) != 0;
}

void info(std::string_view line) {
  if (!quiet()) put(stdout, "", line);
}
void warning(std::string_view line) {
  std::fflush(stdout);
  put(stderr, "warning: ", line);
}
void error(std::string_view text) {
  std::fflush(stdout);
  put(stderr, "error: ", text);
}

}  // namespace log

namespace {

std::string printed(const char* format, double value) {
  char buffer[64];
  const int length = std::snprintf(buffer, sizeof buffer, format, value);
  return {buffer, static_cast<std::size_t>(std::max(length, 0))};
}

}  // namespace

std::string duration_text(double seconds) {
  if (!std::isfinite(seconds) || seconds < 0) return "?";
  if (seconds < 9.95) return printed("%.1f s", seconds);
  const double whole = std::round(seconds);
  if (whole < 60) return printed("%.0f s", whole);
  const double minutes = std::floor(whole / 60);
  if (minutes < 60) return printed("%.0f min ", minutes) + printed("%.0f s", whole - 60 * minutes);
  const double hours = std::floor(minutes / 60);
  return printed("%.0f h ", hours) + printed("%.0f min", minutes - 60 * hours);
}

Progress::Progress(double total, std::string unit_name)
    : total_(total), unit_name_(std::move(unit_name)), start_(Clock::now()), last_(start_) {}

Progress::~Progress() {
  finish();
}

std::string Progress::line(double done, double count, double elapsed_seconds) const {
  const double share = total_ > 0 ? std::clamp(done / total_, 0.0, 1.0) : 1.0;
  std::string text =
      printed("%3.0f %%", std::floor(100 * share)) + printed("  %.0f ", count) + unit_name_;
  if (elapsed_seconds > 0) {
    text += printed("  %.3g ", count / elapsed_seconds) + unit_name_ + "/s";
    if (share > 0) text += "  " + duration_text(elapsed_seconds * (1 - share) / share) + " left";
  }
  return text;
}

void Progress::update(double done, double count) {
  if (log::quiet()) return;
  const auto now = Clock::now();
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  if (log::on_terminal()) {
    constexpr double refresh_seconds = 0.2;
    if (std::chrono::duration<double>(now - last_).count() < refresh_seconds) return;
    last_ = now;
    // Back to the line start, and the rest of a longer old line erased.
    std::printf("\r%s\x1b[K", line(done, count, elapsed).c_str());
    std::fflush(stdout);
    open_line_ = true;
    return;
  }
  const int tenth = total_ > 0 ? static_cast<int>(std::floor(10 * done / total_ + 1e-9)) : 10;
  if (tenth <= tenth_) return;
  tenth_ = tenth;
  log::info(line(done, count, elapsed));
}

void Progress::finish() {
  if (!open_line_) return;
  std::printf("\r\x1b[K");
  std::fflush(stdout);
  open_line_ = false;
}

}  // namespace breccia
