#include "scene/simulation.hpp"

#include "core/error.hpp"
#include "fields/solid_fields.hpp"
#include "scene/catalog.hpp"
#include "scene/initial_velocity.hpp"
#include "scene/model_builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <sstream>

namespace breccia {

namespace {

/// Most steps between two looks at the shapes of all elements, and the strain that may pass in
/// between: the factors leave room for it.
constexpr std::int64_t kRenewal = 50;
constexpr double kUnseenStrain = 0.02;

std::int64_t steps_to_next(const StableStep& now, double dt, bool changing) {
  if (changing) return 1;  // an equation of state or bulk viscosity: moduli follow the shock
  const double strain = now.strain_rate * dt;  // per step
  if (!(strain * kRenewal > kUnseenStrain)) return kRenewal;
  return std::max<std::int64_t>(1, static_cast<std::int64_t>(kUnseenStrain / strain));
}

/// Steps between two looks while faces break all the time and the limit has settled. A face that is
/// inserted in between may be stiffer than the stiffest so far; the factor for springs leaves a
/// fourfold stiffness for that.
constexpr std::int64_t kLook = 10;

/// Steps that the limit must stay above the step before the step grows. A step that follows a body
/// as it rings is long while the body swells and short while it shrinks: energy drifts.
constexpr std::int64_t kCalm = 1000;

/// Steps of a run in which nothing limits the step: rigid bodies that rest, far from one another.
constexpr double kUnlimitedSteps = 1000;

/// Largest strain of an element in one step.
constexpr double kStrainOfStep = 0.25;

/// Default shares of the stable step (ALGORITHMS ): less where springs with kinks act.
constexpr double kFactorBulk = 0.9;
constexpr double kFactorSprings = 0.5;

}  // namespace

template <int D>
Simulation<D>::Simulation(const Settings& scene, const std::filesystem::path& folder)
    : scene_(&scene) {
  build_model(scene, folder, model_);
  assemble();
  motion_->set_initial_velocity(initial_velocity(scene, model_));
}

template <int D>
Simulation<D>::Simulation(const Settings& scene, Parts<D>& parts) : scene_(&scene), parts_(&parts) {
  parts.fill(model_);
  assemble();
}

template <int D>
void Simulation<D>::assemble() {
  const Settings& scene = *scene_;
  modules_ = make_modules<D>(scene);
  model_.stored_energy = [this] {
    Ledger ledger;
    for (const auto& module : modules_) module->book(model_, ledger);
    return ledger.stored();
  };
  for (const auto& module : modules_)
    if (auto* motion = dynamic_cast<Motion<D>*>(module.get())) motion_ = motion;
  for (const auto& module : modules_) module->declare(model_);
  for (const auto& module : modules_) module->enlist(model_, plan_);
  if (parts_ != nullptr) parts_->connect(model_, plan_);
  std::vector<std::string> initial;
  for (const auto& block : model_.store.blocks()) initial.emplace_back(block.info.name);
  plan_.finish(initial);

  const Settings& run = scene.at("run");
  fixed_step_ = run.has("step") ? run.number("step") : 0.0;
  const bool given = run.has("step_factor");
  factors_.bulk = given ? run.number("step_factor") : kFactorBulk;
  factors_.springs = given ? run.number("step_factor") : kFactorSprings;
}

/// What is left of the first step where bodies are as fast as sound: nobody knows yet what they
/// will meet, and in a step of elements at rest they would cross a whole one.
template <int D>
double Simulation<D>::first_share() const {
  double slowest = std::numeric_limits<double>::infinity();
  for (std::size_t m = 0; m < model_.materials.size(); ++m)
    slowest = std::min(slowest, std::sqrt(model_.p_wave_modulus(static_cast<Index>(m)) /
                                          model_.materials[m].density));
  const auto v = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{},
                                                     model_.store.template get<NodeVelocity<D>>());
  double fastest = 0;
  for (Index n = 0; n < model_.nodes(); ++n) fastest = std::max(fastest, norm(row<D>(v, n)));
  return std::min(1.0, kStrainOfStep * slowest / fastest);
}

template <int D>
void Simulation<D>::start() {
  for (const auto& module : modules_) module->bind(model_);
  StableStep first = stable(true);
  if (scene_->at("run").has("mass_scaling")) {
    motion_->scale_mass(model_, stiffness_, factors_);
    first = stable(false);
  }
  first.dt *= fixed_step_ > 0 ? 1.0 : first_share();
  if (fixed_step_ > 0) {
    const double limit = first.dt / (first.by_springs ? factors_.springs : factors_.bulk);
    if (fixed_step_ > limit)
      throw scene_->at("run").error(
          "step",
          fmt::format("a step of {:.4g} s is not stable: the limit of this mesh is {:.4g} s",
                      fixed_step_, limit),
          fmt::format("leave run.step out, or take at most {:.4g} s", 0.9 * limit));
  }
  clock_.dt = fixed_step_ > 0 ? fixed_step_ : first.dt;
  record(first);
  model_.step_is_stale = false;
  next_renewal_ = steps_to_next(first, clock_.dt, model_.store.template has<ElementModulus>());
  kinetic_start_ = motion_->kinetic_energy(model_);
  stored_start_ = model_.stored_energy();
}

template <int D>
StableStep Simulation<D>::stable(bool renew) {
  const auto nodes = static_cast<std::size_t>(model_.store.capacity(Entity::node));
  const bool springs = std::any_of(modules_.begin(), modules_.end(),
                                   [](const auto& module) { return module->has_springs(); });
  if (springs && stiffness_.extent(0) < nodes)
    stiffness_ = Array<double>("breccia::motion::stiffness", nodes);
  if (springs) {
    Kokkos::deep_copy(stiffness_, 0.0);
    for (const auto& module : modules_) module->add_stiffness(model_, stiffness_);
  }
  StableStep step = motion_->stable(model_, stiffness_, factors_, renew);
  if (parts_ != nullptr) step = parts_->least(step);
  // Where bodies meet faster than sound an element could be crossed before its rate is known.
  if (step.strain_rate * step.dt > kStrainOfStep) step.dt = kStrainOfStep / step.strain_rate;
  if (!std::isfinite(step.dt)) step.dt = scene_->at("run").number("duration") / kUnlimitedSteps;
  return step;
}

template <int D>
void Simulation<D>::choose_step() {
  const bool renew = clock_.step >= next_renewal_;
  if (!renew && (!model_.step_is_stale || clock_.step < next_look_)) return;
  const auto begin = std::chrono::steady_clock::now();
  Tally tally;
  current_tally = &tally;
  const StableStep now = stable(renew);
  current_tally = nullptr;
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  plan_.book("motion", seconds.count(), tally.launches);
  if (renew)
    next_renewal_ =
        clock_.step + steps_to_next(now, clock_.dt, model_.store.template has<ElementModulus>());
  if (now.dt > 0.99 * clock_.dt) next_look_ = clock_.step + kLook;
  model_.step_is_stale = false;
  if (fixed_step_ > 0) {
    const double limit = now.dt / (now.by_springs ? factors_.springs : factors_.bulk);
    if (fixed_step_ > limit && !model_.stop.raised) {
      model_.stop.raised = true;
      model_.stop.cause = fmt::format(
          "at time {:.6g} s (step {}) the fixed step of {:.4g} s is above the stability limit of "
          "{:.4g} s, which has fallen since the start; leave run.step out or take a smaller one",
          clock_.time, clock_.step, fixed_step_, limit);
    }
    return;
  }
  // Keeps its length while the limit only trembles: the factors leave room for a hundredth.
  // Otherwise it falls at once and rises late and slowly (ALGORITHMS ).
  if (now.dt < 1.02 * clock_.dt) calm_from_ = clock_.step + kCalm;
  if (now.dt < 0.99 * clock_.dt) {
    clock_.dt = now.dt;
  } else if (renew && clock_.step >= calm_from_ && now.dt > 1.02 * clock_.dt) {
    clock_.dt = std::min(now.dt, 1.1 * clock_.dt);
  }
  record(now);
}

template <int D>
void Simulation<D>::record(const StableStep& stable) {
  if (record_.min > 0 && clock_.dt >= record_.min) {
    record_.max = std::max(record_.max, clock_.dt);
    return;
  }
  record_.min = clock_.dt;
  record_.max = std::max(record_.max, clock_.dt);
  if (fixed_step_ > 0) {
    record_.set_by = "run.step";
    return;
  }
  std::string place;
  if (stable.node != kNone) {
    const auto x = model_.store.template get<NodePosition<D>>();
    const auto one = Kokkos::create_mirror_view_and_copy(
        Kokkos::HostSpace{},
        Kokkos::subview(x, std::make_pair(stable.node, stable.node + 1), Kokkos::ALL));
    for (int d = 0; d < D; ++d) place += fmt::format("{}{:.5g}", d ? ", " : "", one(0, d));
  }
  if (parts_ != nullptr) parts_->world().share(place, stable.rank);
  record_.set_by = fmt::format(
      "{} at ({}) m", stable.by_springs ? "interface or contact springs" : "elements", place);
}

template <int D>
void Simulation<D>::stop_motion() {
  Clock now = clock_;
  now.dt = 0;
  plan_.run(Stage::assemble, Stage::observe, now);
  clock_.dt_before = 0;
}

namespace {
namespace news {
constexpr std::uint64_t stale = 1, stop = 2, split = 4, release = 8, wishes_from = 16;
}
}  // namespace

template <int D>
void Simulation<D>::agree() {
  std::uint64_t seen = ask_ ? ask_() * news::wishes_from : 0;
  if (parts_ == nullptr) {
    wishes_ = seen / news::wishes_from;
    return;
  }
  const World& world = parts_->world();
  if (model_.step_is_stale) seen |= news::stale;
  if (model_.stop.raised) seen |= news::stop;
  if (model_.splits != splits_known_) seen |= news::split;
  if (model_.releases != releases_known_) seen |= news::release;
  seen = world.bits(seen);
  wishes_ = seen / news::wishes_from;
  model_.step_is_stale = (seen & news::stale) != 0;
  if ((seen & news::split) != 0) {
    model_.splits = ++splits_known_;
    parts_->renew(model_);
  }
  if ((seen & news::release) != 0) {
    model_.releases = ++releases_known_;
    parts_->bring_slip(model_);
  }
  if ((seen & news::stop) == 0) return;
  const auto first =
      static_cast<int>(world.least(model_.stop.raised ? world.rank() : world.size()));
  world.share(model_.stop.cause, first);
  model_.stop.raised = true;
}

template <int D>
void Simulation<D>::step(double end, const Watchers& watchers) {
  plan_.run(Stage::search, Stage::split, clock_);
  agree();
  if (model_.rest.due) stop_motion();
  choose_step();
  const double whole = clock_.dt;
  // The last step ends on time; a sliver of a step is joined to the one before it.
  if (clock_.time + 1.000001 * clock_.dt >= end) clock_.dt = end - clock_.time;
  if (watchers.before) watchers.before();
  plan_.run(Stage::assemble, Stage::observe, clock_);
  if (watchers.after) watchers.after();
  clock_.time += clock_.dt;
  clock_.dt_before = clock_.dt;
  clock_.dt = whole;
  ++clock_.step;
}

template <int D>
void Simulation<D>::close(const Watchers& watchers) {
  plan_.run(Stage::search, Stage::split, clock_);
  agree();
  clock_.dt = 0;
  watchers.before();
  plan_.run(Stage::assemble, Stage::observe, clock_);
  watchers.after();
}

template <int D>
void Simulation<D>::book_before(Ledger& ledger) {
  ledger.kinetic_start = kinetic_start_;
  ledger.stored_start = stored_start_;
  for (const auto& module : modules_) module->book(model_, ledger);
  motion_->book_before(model_, ledger);
}

template <int D>
void Simulation<D>::book_after(Ledger& ledger) {
  motion_->book_after(model_, clock_, ledger);
  if (parts_ != nullptr) ledger.merge(parts_->world());
}

template <int D>
Counts Simulation<D>::counts() {
  Counts counts;
  for (const auto& module : modules_) module->count(model_, counts);
  if (parts_ == nullptr) return counts;
  for (std::int64_t* count :
       {&counts.bonded, &counts.inserted, &counts.released, &counts.contact_points})
    *count = parts_->world().sum(*count);
  return counts;
}

namespace {

void archive_text(Archive& archive, std::string_view name, std::string& text) {
  std::vector<std::int64_t> letters(text.begin(), text.end());
  archive.integers(name, letters);
  if (archive.loading()) text.assign(letters.begin(), letters.end());
}

/// What the run has cost before it was interrupted counts on.
void archive_costs(Archive& archive, Plan& plan) {
  std::string names;
  std::vector<double> seconds;
  std::vector<std::int64_t> launches;
  for (const Cost& cost : plan.costs()) {
    names += cost.effect + '\n';
    seconds.push_back(cost.seconds);
    launches.push_back(cost.launches);
  }
  archive_text(archive, "cost.effects", names);
  archive.numbers("cost.seconds", seconds);
  archive.integers("cost.launches", launches);
  if (!archive.loading()) return;
  std::istringstream lines(names);
  std::string effect;
  for (std::size_t i = 0; std::getline(lines, effect); ++i)
    plan.book(effect, seconds[i], launches[i]);
}

}  // namespace

template <int D>
void Simulation<D>::archive(Archive& archive) {
  archive.integer("clock.step", clock_.step);
  archive.number("clock.time", clock_.time);
  archive.number("clock.dt", clock_.dt);
  archive.number("clock.dt_before", clock_.dt_before);
  archive.number("step.min", record_.min);
  archive.number("step.max", record_.max);
  archive_text(archive, "step.set_by", record_.set_by);
  archive_costs(archive, plan_);
  archive.integer("step.next_renewal", next_renewal_);
  archive.integer("step.next_look", next_look_);
  archive.integer("step.calm_from", calm_from_);
  archive.integer("model.splits", model_.splits);
  archive.integer("model.releases", model_.releases);
  std::int64_t stale = model_.step_is_stale ? 1 : 0;
  archive.integer("model.step_is_stale", stale);
  model_.step_is_stale = stale != 0;
  archive.number("model.added_mass", model_.added_mass);
  archive.number("ledger.kinetic_start", kinetic_start_);
  archive.number("ledger.stored_start", stored_start_);
  for (const auto& module : modules_) module->archive(archive);
}

template <int D>
void Simulation<D>::resume() {
  for (const auto& module : modules_) module->resume(model_);
  splits_known_ = model_.splits;
  releases_known_ = model_.releases;
  if (parts_ != nullptr) parts_->renew(model_);
}

template class Simulation<2>;
template class Simulation<3>;

}  // namespace breccia
