#include "scene/guard.hpp"

#include "base/views.hpp"
#include "fields/solid_fields.hpp"
#include "mesh/geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace breccia {

namespace {

/// Looks in a row that must see energy from nowhere: one may be a ripple.
constexpr int kAlarms = 2;

/// Above this share of the largest energy nobody waits for the next look.
constexpr double kRunaway = 0.5;

constexpr const char* kShorterSteps =
    "take a smaller run.step_factor, more damping or a finer mesh there";

/// Faster than any node: the speed of one whose velocity is not finite.
constexpr double kNoNumber = std::numeric_limits<double>::infinity();

/// Energies of strains below this are round-off.
constexpr double kStrainOfRoundOff = 1e-9;

template <int D>
double energy_of_round_off(const Model<D>& model) {
  double sum = 0;
  for (const Block& block : model.blocks)
    for (Index e = block.begin; e < block.end; ++e)
      if (model.part.owns_element(e))
        sum += signed_volume<D>(corners(model.mesh, e)) * model.p_wave_modulus(block.material);
  return model.part.sum(sum) * model.thickness * kStrainOfRoundOff * kStrainOfRoundOff;
}

template <class Field>
auto host_copy(const Store& store) {
  return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, store.get<Field>());
}

template <int D>
std::string text_of(const Vec<D>& place) {
  std::string text = "(";
  for (int d = 0; d < D; ++d) text += fmt::format("{}{:.5g}", d ? ", " : "", place[d]);
  return text + ") m";
}

}  // namespace

template <int D>
Guard<D>::Guard(Simulation<D>& simulation, const Settings& run)
    : simulation_(&simulation),
      most_made_(run.at("guard").number("energy")),
      most_overlap_(run.at("guard").number("overlap")),
      every_(run.at("guard").integer("every")),
      floor_(energy_of_round_off(simulation.model())) {}

template <int D>
bool Guard<D>::due() const {
  return every_ > 0 && simulation_->clock().step > 0 && simulation_->clock().step % every_ == 0;
}

template <int D>
void Guard<D>::before() {
  now_ = Ledger{};
  simulation_->book_before(now_);
  overlap_ = Overlap{};
  for (const auto& module : simulation_->modules()) {
    const Overlap found = module->deepest_overlap(simulation_->model());
    if (found.share > overlap_.share) overlap_ = found;
  }
  const Part& part = simulation_->model().part;
  const double deepest = part.largest(overlap_.share);
  if (deepest != overlap_.share) overlap_.element = kNone;
  overlap_.share = deepest;
}

template <int D>
void Guard<D>::after() {
  simulation_->book_after(now_);
  ++seen_.looks;
  alarm_ = {};
  judge_energy();
  judge_overlap();
  last_ = now_;
  // The first rank decides: sums of an MPI need not be the same to the last bit everywhere.
  if (const World* world = simulation_->model().part.world)
    for (std::string* text : {&alarm_.what, &alarm_.remedy}) world->share(*text, 0);
  if (!alarm_.what.empty()) stop();
}

template <int D>
void Guard<D>::judge_energy() {
  const double made = now_.made();
  if (!std::isfinite(made)) {
    raise("energies are not finite", kShorterSteps);
    return;
  }
  in_play_ = std::max({in_play_, now_.scale(), floor_});
  const double share = made / in_play_;
  seen_.made = std::max(seen_.made, share);
  alarms_ = share > most_made_ ? alarms_ + 1 : 0;
  if (alarms_ < kAlarms && !(share > kRunaway)) return;
  raise(fmt::format("{:.3g} J of {:.3g} J came from nowhere ({:.2g} %; {})", made, in_play_,
                    100 * share, grown_most()),
        std::string(kShorterSteps) + ", or allow it with run.guard.energy");
}

template <int D>
void Guard<D>::judge_overlap() {
  seen_.overlap = std::max(seen_.overlap, overlap_.share);
  if (!(overlap_.share > most_overlap_)) return;
  raise(fmt::format("bodies overlap by {:.2g} heights of an element at {}", overlap_.share,
                    place_of_overlap()),
        "make contact stiffer or elements there smaller, or allow it with run.guard.overlap");
}

template <int D>
void Guard<D>::raise(const std::string& what, const std::string& remedy) {
  if (alarm_.what.empty()) alarm_ = {what, remedy};
}

template <int D>
void Guard<D>::stop() {
  Stop& stop = simulation_->model().stop;
  if (stop.raised) return;
  stop.raised = true;
  stop.cause = fmt::format("at time {:.6g} s (step {}) {}; {}; {}", simulation_->clock().time,
                           simulation_->clock().step, alarm_.what, fastest_node(), alarm_.remedy);
}

template <int D>
std::string Guard<D>::fastest_node() const {
  const Store& store = simulation_->model().store;
  const auto x = host_copy<NodePosition<D>>(store);
  const auto v = host_copy<NodeVelocity<D>>(store);
  Index fastest = 0;
  for (Index n = 0; n < simulation_->model().nodes(); ++n)
    if (!(norm2(row<D>(v, n)) <= norm2(row<D>(v, fastest)))) fastest = n;
  const double speed = norm(row<D>(v, fastest));
  return on_rank_of_largest(std::isfinite(speed) ? speed : kNoNumber, [&] {
    return fmt::format("the fastest node, {:.4g} m/s, is at {}", speed,
                       text_of<D>(row<D>(x, fastest)));
  });
}

/// Text of the rank whose value is largest, on all ranks.
template <int D>
std::string Guard<D>::on_rank_of_largest(double value,
                                         const std::function<std::string()>& text) const {
  const Part& part = simulation_->model().part;
  if (part.whole()) return text();
  const int rank = part.rank_of_largest(value);
  std::string said = rank == part.world->rank() ? text() : std::string();
  part.world->share(said, rank);
  return said;
}

template <int D>
std::string Guard<D>::place_of_overlap() const {
  return on_rank_of_largest(overlap_.element == kNone ? -1.0 : overlap_.share,
                            [this] { return place_of(overlap_.element); });
}

template <int D>
std::string Guard<D>::place_of(Index element) const {
  const Store& store = simulation_->model().store;
  const auto x = host_copy<NodePosition<D>>(store);
  const auto nodes = host_copy<ElementNodes<D>>(store);
  Vec<D> centre = Vec<D>::zero();
  for (int a = 0; a <= D; ++a) centre += row<D>(x, nodes(element, a)) * (1.0 / (D + 1));
  return text_of<D>(centre);
}

template <int D>
std::string Guard<D>::grown_most() const {
  std::string name = "KE";
  double most = now_.kinetic - last_.kinetic;
  for (const Ledger::Entry& entry : now_.entries()) {
    const double growth = std::abs(entry.joule - last_.value(entry.name));
    if (growth > most) {
      name = entry.name;
      most = growth;
    }
  }
  return fmt::format("{} changed most since step {}, by {:.3g} J", name,
                     simulation_->clock().step - every_, most);
}

template class Guard<2>;
template class Guard<3>;

}  // namespace breccia
