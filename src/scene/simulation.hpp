#pragma once
#include "modules/motion/motion.hpp"
#include "scene/parts.hpp"
#include "step/module.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace breccia {

/// Extremes of the step length of a run and who set the smallest.
struct StepRecord {
  double min = 0, max = 0;
  std::string set_by;
};

/// A scene as a running system: the model, its modules in the order of the one list
/// (catalog.hpp), their plan, and the clock. The only step of the code is `Simulation::step`.
template <int D>
class Simulation {
 public:
  /// Meshes the bodies (files are looked for in `folder`), allocates the fields of the modules
  /// that the scene calls for. Throws Error where the scene cannot be built.
  Simulation(const Settings& scene, const std::filesystem::path& folder);
  /// This rank's part of a scene that is dealt out; take_state (scene/part_state.hpp) gives it its
  /// state. `parts` outlives it. Collective.
  Simulation(const Settings& scene, Parts<D>& parts);

  /// Fills the state at t = 0 and chooses the first step. Throws Error when a step that the
  /// user fixed is not stable.
  void start();

  /// Called between the last force and the motion of a step; then after the motion.
  struct Watchers {
    std::function<void()> before;
    std::function<void()> after;
  };
  /// One step, no longer than to `end`.
  void step(double end, const Watchers& watchers);
  /// Asked in each step; what some rank has said is in wishes() after the step, on all ranks.
  void ask_for(std::function<std::uint64_t()> wishes) { ask_ = std::move(wishes); }
  std::uint64_t wishes() const { return wishes_; }
  const std::function<std::uint64_t()>& asked() const { return ask_; }

  /// Half a kick at the end of a run brings the velocities to the time of the positions.
  void close(const Watchers& watchers);

  /// Reads or writes everything that is not in the store.
  void archive(Archive& archive);
  /// After the store and the archive have been filled from a checkpoint.
  void resume();

  /// Energies at t^n: call the first before, the second after the motion.
  void book_before(Ledger& ledger);
  void book_after(Ledger& ledger);

  Model<D>& model() { return model_; }
  const Model<D>& model() const { return model_; }
  Motion<D>& motion() { return *motion_; }
  Plan& plan() { return plan_; }
  const Clock& clock() const { return clock_; }
  const StepRecord& step_record() const { return record_; }
  const std::vector<std::unique_ptr<Module<D>>>& modules() const { return modules_; }
  const Settings& scene() const { return *scene_; }
  Counts counts();

  /// Stable step now, with the factors of the scene.
  StableStep stable(bool renew);

 private:
  void assemble();
  /// What one rank has seen happens on all of them: splits, releases, stops.
  void agree();
  void choose_step();
  /// Share of the first stable step that fast bodies may take.
  double first_share() const;
  /// Half a kick to t^n, where the rest module takes the velocities.
  void stop_motion();
  void record(const StableStep& stable);

  const Settings* scene_;
  Parts<D>* parts_ = nullptr;
  Model<D> model_;
  std::vector<std::unique_ptr<Module<D>>> modules_;
  Motion<D>* motion_ = nullptr;
  Plan plan_;
  Clock clock_;
  StepRecord record_;
  double fixed_step_ = 0;  ///< s; 0: automatic
  typename Motion<D>::Factors factors_{};
  double kinetic_start_ = 0, stored_start_ = 0;
  std::int64_t next_renewal_ = 0;
  std::int64_t next_look_ = 0;  ///< step before which a stale step is good enough
  std::int64_t calm_from_ = 0;  ///< step before which it does not grow
  Array<double> stiffness_;
  std::function<std::uint64_t()> ask_;
  std::uint64_t wishes_ = 0;
  std::int64_t splits_known_ = 0, releases_known_ = 0;  ///< by all ranks
};

}  // namespace breccia
