#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace breccia {

/// How a program ended.
struct Ending {
  int status = 0;        ///< exit status
  int signal = 0;        ///< that ended it; 0: none
  double processor = 0;  ///< [s] of the processor, all threads
  double wall = 0;       ///< [s]
  bool late = false;     ///< it was ended because it took too long
};

/// A program that runs beside this one; what it prints goes into a file.
class Process {
 public:
  /// \throws Error when it cannot be started.
  Process(const std::vector<std::string>& command, const std::string& log);
  ~Process();  ///< ends it if it still runs
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// Nothing while it runs.
  std::optional<Ending> ended();
  Ending wait();                         ///< for its end
  [[nodiscard]] double seconds() const;  ///< since the start

  void interrupt() const;  ///< asks it to stop (SIGINT)
  void kill() const;

 private:
  std::optional<Ending> look(int options);

  std::chrono::steady_clock::time_point start_;
  int id_ = 0;
  bool running_ = false;
};

/// "segmentation fault (signal 11)".
std::string signal_text(int signal);

/// Path of the executable that runs; `called` is how it was called, where the system cannot tell.
std::string own_program(const std::string& called);

}  // namespace breccia
