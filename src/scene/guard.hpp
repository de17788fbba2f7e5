#pragma once
#include "io/report.hpp"
#include "scene/simulation.hpp"

#include <functional>
#include <string>

namespace breccia {

/// Watches a run for what no result may be made of: energies that are not finite, energy from
/// nowhere, bodies deep inside each other ([run.guard]). It looks now and then, changes nothing,
/// and stops the run with what it saw, where, and the likely cause.
template <int D>
class Guard {
 public:
  Guard(Simulation<D>& simulation, const Settings& run);

  /// Another simulation goes on with the same state.
  void follow(Simulation<D>& simulation) { simulation_ = &simulation; }

  /// Whether it looks in this step; if so call both, before and after the nodes move.
  bool due() const;
  void before();
  void after();

  const Report::Guard& seen() const { return seen_; }

 private:
  void judge_energy();
  void judge_overlap();
  void raise(const std::string& what, const std::string& remedy);
  void stop();
  std::string on_rank_of_largest(double value, const std::function<std::string()>& text) const;
  std::string fastest_node() const;
  std::string place_of_overlap() const;
  std::string place_of(Index element) const;
  /// The energy that grew most since the last look.
  std::string grown_most() const;

  Simulation<D>* simulation_;
  double most_made_, most_overlap_;
  std::int64_t every_;
  double floor_ = 0;    ///< J, below which energies are round-off
  double in_play_ = 0;  ///< J, the largest energy so far
  int alarms_ = 0;      ///< looks in a row that saw too much energy
  Ledger now_, last_;
  Overlap overlap_;  ///< the element where this rank knows it
  struct Alarm {
    std::string what, remedy;
  };
  Alarm alarm_;  ///< of this look
  Report::Guard seen_;
};

extern template class Guard<2>;
extern template class Guard<3>;

}  // namespace breccia
