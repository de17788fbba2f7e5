#include "jobs/process.hpp"

#include "core/error.hpp"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

extern char** environ;  // POSIX declares it nowhere

namespace breccia {

namespace {

double seconds_of(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

/// Where a new program reads and prints.
class Streams {
 public:
  explicit Streams(const std::string& log) {
    constexpr mode_t readable = 0644;
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, 1, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                     readable);
    posix_spawn_file_actions_adddup2(&actions_, 1, 2);
  }
  ~Streams() { posix_spawn_file_actions_destroy(&actions_); }
  Streams(const Streams&) = delete;
  Streams& operator=(const Streams&) = delete;
  [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

}  // namespace

Process::Process(const std::vector<std::string>& command, const std::string& log)
    : start_(std::chrono::steady_clock::now()) {
  const Streams streams(log);
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  pid_t id = 0;
  const int trouble =
      posix_spawnp(&id, words.front(), streams.get(), nullptr, words.data(), environ);
  if (trouble != 0)
    throw Error(command.front(), std::string("cannot be started: ") + std::strerror(trouble));
  id_ = static_cast<int>(id);
  running_ = true;
}

Process::~Process() {
  if (!running_) return;
  kill();
  int ignored = 0;
  waitpid(id_, &ignored, 0);
}

std::optional<Ending> Process::look(int options) {
  int how = 0;
  rusage used{};
  const pid_t done = wait4(id_, &how, options, &used);
  if (done == 0 || (done < 0 && errno == EINTR)) return std::nullopt;
  running_ = false;
  Ending ending;
  ending.wall = seconds();
  ending.processor = seconds_of(used.ru_utime) + seconds_of(used.ru_stime);
  if (WIFSIGNALED(how)) ending.signal = WTERMSIG(how);
  if (WIFEXITED(how)) ending.status = WEXITSTATUS(how);
  return ending;
}

std::optional<Ending> Process::ended() {
  return look(WNOHANG);
}

Ending Process::wait() {
  std::optional<Ending> ending;
  while (!(ending = look(0))) continue;
  return *ending;
}

double Process::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void Process::interrupt() const {
  ::kill(id_, SIGINT);
}

void Process::kill() const {
  ::kill(id_, SIGKILL);
}

std::string signal_text(int signal) {
  const char* name = strsignal(signal);
  return (name != nullptr ? std::string(name) : std::string("ended")) + " (signal " +
         std::to_string(signal) + ")";
}

std::string own_program(const std::string& called) {
  std::error_code trouble;
  const auto link = std::filesystem::read_symlink("/proc/self/exe", trouble);
  return trouble ? called : link.string();
}

}  // namespace breccia
