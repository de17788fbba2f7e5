#include "step/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <stdexcept>

namespace breccia {

std::string_view name_of(Stage stage) {
  static constexpr std::string_view names[kStages] = {
      "search",     "element_force", "interface_force", "contact_force", "fluid",
      "node_force", "split",         "assemble",        "advance",       "observe"};
  return names[static_cast<int>(stage)];
}

Task& Plan::add(Stage stage, std::string name, std::string effect,
                std::function<void(const Clock&)> run) {
  return tasks_.emplace_back(
      Task{stage, std::move(name), std::move(effect), {}, {}, {}, std::move(run)});
}

void Plan::exchange_by(std::vector<std::string> fields, std::function<void(const Clock&)> run) {
  exchanges_.push_back({std::move(fields), std::move(run)});
}

namespace {

bool meet(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  return std::any_of(a.begin(), a.end(), [&b](const std::string& name) {
    return std::find(b.begin(), b.end(), name) != b.end();
  });
}

}  // namespace

void Plan::insert_exchanges() {
  for (const Exchange& exchange : exchanges_) {
    const bool wanted = std::any_of(tasks_.begin(), tasks_.end(), [&](const Task& task) {
      return meet(task.ghosts, exchange.fields);
    });
    const auto last = std::find_if(tasks_.rbegin(), tasks_.rend(), [&](const Task& task) {
      return meet(task.writes, exchange.fields);
    });
    if (!wanted || last == tasks_.rend()) continue;
    tasks_.insert(last.base(), Task{last->stage,
                                    "exchange::" + exchange.fields.front(),
                                    "exchange",
                                    exchange.fields,
                                    exchange.fields,
                                    {},
                                    exchange.run});
  }
}

void Plan::finish(const std::vector<std::string>& initial) {
  std::stable_sort(tasks_.begin(), tasks_.end(),
                   [](const Task& a, const Task& b) { return a.stage < b.stage; });
  insert_exchanges();
  std::set<std::string> known(initial.begin(), initial.end());
  for (const Task& task : tasks_) known.insert(task.writes.begin(), task.writes.end());
  for (const Task& task : tasks_)
    for (const std::string& field : task.reads)
      if (known.count(field) == 0)
        throw std::logic_error("task " + task.name + " reads '" + field + "', which nobody writes");
  for (const Task& task : tasks_) cost_of(task.effect);
}

void Plan::run(Stage first, Stage last, const Clock& clock) {
  using Watch = std::chrono::steady_clock;
  for (const Task& task : tasks_) {
    if (task.stage < first || task.stage > last) continue;
    Tally tally;
    current_tally = &tally;
    const auto start = Watch::now();
    task.run(clock);
    const double seconds = std::chrono::duration<double>(Watch::now() - start).count();
    current_tally = nullptr;
    book(task.effect, seconds, tally.launches);
  }
}

void Plan::book(const std::string& effect, double seconds, std::int64_t launches) {
  Cost& cost = cost_of(effect);
  cost.seconds += seconds;
  cost.launches += launches;
}

Cost& Plan::cost_of(const std::string& effect) {
  for (Cost& cost : costs_)
    if (cost.effect == effect) return cost;
  return costs_.emplace_back(Cost{effect});
}

std::string Plan::print() const {
  std::string text = fmt::format("{:<16} {:<28} {}\n", "stage", "task", "effect");
  for (const Task& task : tasks_)
    text += fmt::format("{:<16} {:<28} {}\n", name_of(task.stage), task.name, task.effect);
  return text;
}

}  // namespace breccia
