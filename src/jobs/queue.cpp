#include "jobs/queue.hpp"

#include "scene/interrupt.hpp"

#include <thread>

namespace breccia {

namespace {
constexpr double kPatience = 30;  // s that a job has to stop when it is asked to
}

void JobQueue::run(const Start& start, const Finish& finish) {
  watch_for_interrupt();
  while (!waiting_.empty() || !running_.empty()) {
    if (interrupted()) {
      waiting_.clear();
      for (Running& one : running_) ask(one);
    }
    fill(start);
    look(finish);
    if (!running_.empty()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

void JobQueue::fill(const Start& start) {
  while (!waiting_.empty() && running_.size() < side_by_side_) {
    const std::size_t job = waiting_.front();
    waiting_.pop_front();
    if (auto process = start(job)) running_.push_back({job, std::move(process)});
  }
}

void JobQueue::ask(Running& one) {
  if (one.asked > 0) return;
  one.asked = one.process->seconds();
  one.process->interrupt();
}

void JobQueue::look(const Finish& finish) {
  for (std::size_t r = 0; r < running_.size();) {
    Running& one = running_[r];
    if (time_limit_ && one.asked == 0 && one.process->seconds() > *time_limit_) {
      one.late = true;
      ask(one);
    }
    if (one.asked > 0 && one.process->seconds() > one.asked + kPatience) one.process->kill();
    auto ending = one.process->ended();
    if (!ending) {
      ++r;
      continue;
    }
    ending->late = one.late;
    const std::size_t job = one.job;
    running_.erase(running_.begin() + static_cast<std::ptrdiff_t>(r));
    finish(job, *ending);
  }
}

}  // namespace breccia
