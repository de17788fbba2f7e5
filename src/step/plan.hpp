#pragma once
#include "base/exec.hpp"
#include "fields/field.hpp"
#include "step/clock.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace breccia {

/// Stages of a step in their fixed order, named by entity and purpose.
enum class Stage {
  search,
  element_force,
  interface_force,
  contact_force,
  fluid,
  node_force,
  split,
  assemble,
  advance,
  observe,
  count_
};
inline constexpr int kStages = static_cast<int>(Stage::count_);
std::string_view name_of(Stage stage);

/// One named piece of work of one effect in one stage.
struct Task {
  Stage stage;
  std::string name;    ///< "fracture::split"
  std::string effect;  ///< "fracture"
  std::vector<std::string> reads, writes;
  std::vector<std::string> ghosts;  ///< of what it reads: also where other ranks own it
  std::function<void(const Clock&)> run;

  template <class... Fields>
  Task& reading() {
    (reads.emplace_back(Fields::info.name), ...);
    return *this;
  }
  template <class... Fields>
  Task& reading_ghosts() {
    (ghosts.emplace_back(Fields::info.name), ...);
    return reading<Fields...>();
  }
  template <class... Fields>
  Task& writing() {
    (writes.emplace_back(Fields::info.name), ...);
    return *this;
  }
};

/// Seconds and launches of one effect so far.
struct Cost {
  std::string effect;
  double seconds = 0;
  std::int64_t launches = 0;
};

/// The ordered tasks of a step. Tasks of one stage run in the order of the module list.
class Plan {
 public:
  Task& add(Stage stage, std::string name, std::string effect,
            std::function<void(const Clock&)> run);

  /// Runs the tasks of the stages from `first` to `last`, both included, booking their cost.
  void run(Stage first, Stage last, const Clock& clock);

  /// How fields get from their owners to the ranks that know them as ghosts: `run` brings all of
  /// `fields`. `finish` puts it behind the last task that writes one of them, where a task reads
  /// one with ghosts.
  void exchange_by(std::vector<std::string> fields, std::function<void(const Clock&)> run);

  /// Sorts by stage and checks that every field read in a step is written earlier in the step,
  /// later in it (so it holds the value of the step before), or is one of `initial`.
  /// Throws std::logic_error that names task and field.
  void finish(const std::vector<std::string>& initial);

  const std::vector<Task>& tasks() const { return tasks_; }
  const std::vector<Cost>& costs() const { return costs_; }
  /// Adds work that was done outside the tasks (stable step, output) to an effect's cost.
  void book(const std::string& effect, double seconds, std::int64_t launches);
  /// The list as a person reads it.
  std::string print() const;

 private:
  Cost& cost_of(const std::string& effect);
  void insert_exchanges();

  struct Exchange {
    std::vector<std::string> fields;
    std::function<void(const Clock&)> run;
  };
  std::vector<Task> tasks_;
  std::vector<Exchange> exchanges_;
  std::vector<Cost> costs_;
};

}  // namespace breccia
