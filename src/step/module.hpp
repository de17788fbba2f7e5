#pragma once
#include "step/clock.hpp"
#include "step/ledger.hpp"
#include "step/model.hpp"
#include "step/observation.hpp"
#include "step/plan.hpp"

#include <string>

namespace breccia {

/// The contract of an effect. Host code; virtual calls happen a few times per step at most.
/// A module sees the model and the kernels; it never includes another module, MPI or files.
/// Modules meet through fields of the store.
template <int D>
class Module {
 public:
  virtual ~Module() = default;

  /// Name of the effect in the plan, the cost sheet and the report.
  virtual std::string key() const = 0;

  /// Adds its fields to the store. Sizes of nodes, elements, families and faces are known.
  virtual void declare(Model<D>&) {}
  /// Fills its fields at the start of a fresh run.
  virtual void bind(Model<D>&) {}
  /// Called instead of `bind` after a checkpoint has filled the fields and `archive` the rest;
  /// rebuilds what is derived.
  virtual void resume(Model<D>& model) { bind(model); }
  /// Puts its tasks into the plan.
  virtual void enlist(Model<D>& model, Plan& plan) = 0;

  /// Adds the stiffness of its springs, each counted twice at both ends (|a - b|^2 <= 2 a^2 +
  /// 2 b^2), to each node, N/m; the stable step is 2 / sqrt of the largest nodal rate.
  virtual void add_stiffness(Model<D>&, const Array<double>& /*stiffness*/) const {}
  /// Whether it has any springs to add; else no stiffness is kept at the nodes.
  virtual bool has_springs() const { return false; }

  /// Books its energies at t^n.
  virtual void book(Model<D>&, Ledger&) const {}
  /// Sets its history columns.
  virtual void observe(Model<D>&, const Clock&, Moment, Row&) {}
  /// Whether what it draws is known only to who has computed the last forces.
  virtual bool draws_forces() const { return false; }
  /// Adds its fields to a frame.
  virtual void draw(Model<D>&, Picture&) const {}
  /// Events since the last call, in a fixed order.
  virtual std::vector<Event> take_events() { return {}; }
  virtual void count(Model<D>&, Counts&) const {}
  virtual Overlap deepest_overlap(Model<D>&) const { return {}; }
  /// Memory that is not in the store.
  virtual std::size_t bytes() const { return 0; }
  /// State that is not in the store.
  virtual void archive(Archive&) {}
};

}  // namespace breccia
