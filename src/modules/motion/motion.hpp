#pragma once
#include "base/sums.hpp"
#include "loops/node_motion.hpp"
#include "loops/stable_step.hpp"
#include "step/module.hpp"

namespace breccia {

/// The nodes: their corners, masses, positions and velocities, the leapfrog that moves them, the
/// work of every class of force, and the stable step. Always present.
template <int D>
class Motion final : public Module<D> {
 public:
  std::string key() const override { return "motion"; }
  void declare(Model<D>& model) override;
  void bind(Model<D>& model) override;
  void resume(Model<D>& model) override;
  void enlist(Model<D>& model, Plan& plan) override;
  void observe(Model<D>& model, const Clock& clock, Moment moment, Row& row) override;
  void archive(Archive& archive) override;

  /// Velocities of the scene at t = 0: (node, D).
  void set_initial_velocity(std::vector<double> velocity) { initial_ = std::move(velocity); }

  /// Shares of the bound that a step uses, at nodes without and with springs.
  struct Factors {
    double bulk, springs;
  };
  /// Stable step of the present state; `stiffness` as add_stiffness left it, or empty.
  /// `renew`: look at the shapes of the elements again.
  StableStep stable(const Model<D>& model, const Array<double>& stiffness, Factors factors,
                    bool renew) const;

  /// Adds mass to the nodes whose stable step is below the one that run.mass_scaling wants
  /// (ALGORITHMS ); after `stable` has looked at the shapes. Throws Error where a dynamic run
  /// would need more than a twentieth of the whole.
  void scale_mass(Model<D>& model, const Array<double>& stiffness, Factors factors);

  /// Kinetic energies and works up to now. `before` the kick of a step, `after` it; only both
  /// together give the values at t^n.
  void book_before(const Model<D>& model, Ledger& ledger);
  void book_after(const Model<D>& model, const Clock& clock, Ledger& ledger) const;
  double kinetic_energy(const Model<D>& model) const;

 private:
  void move(Model<D>& model, const Clock& clock);
  void make_corners(Model<D>& model);
  void size_work(const Model<D>& model);
  Sums<kWorks> works(const Model<D>& model) const;

  std::vector<double> initial_;
  std::vector<double> volume_;  ///< m3 of each element, while the start state is made
  ChunkSums<kWorks> work_;
  Array<double> damping_;  ///< of each material
};

}  // namespace breccia
