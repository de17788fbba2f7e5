#pragma once
#include "core/schema.hpp"
#include "loops/rigid_bodies.hpp"
#include "step/module.hpp"

namespace breccia {

/// Bodies that move as a whole: every [[body]] with `rigid = true`.
template <int D>
class Rigid final : public Module<D> {
 public:
  static bool wanted(const Settings& scene);
  std::string key() const override { return "rigid"; }
  void declare(Model<D>& model) override;
  void bind(Model<D>& model) override;
  void resume(Model<D>& model) override;
  void enlist(Model<D>& model, Plan& plan) override;
  bool has_springs() const override { return true; }
  void add_stiffness(Model<D>& model, const Array<double>& stiffness) const override;
  void observe(Model<D>& model, const Clock& clock, Moment moment, Row& row) override;
  std::size_t bytes() const override;
  void archive(Archive& archive) override;

 private:
  /// What moves a body besides forces.
  struct Drive {
    std::int64_t boundary = kNone, components = 0;
  };

  void refuse_digging(const Model<D>& model, const std::vector<std::vector<Index>>& nodes) const;
  Drive drive_of(const Model<D>& model, std::size_t body, const std::vector<Index>& nodes) const;
  void read_turning(const Model<D>& model);
  /// Nodes of each body as the elements have them now.
  std::vector<std::vector<Index>> find_nodes(const Model<D>& model) const;
  /// Lists, masses and inertia of the bodies with these nodes.
  void measure(Model<D>& model, const std::vector<std::vector<Index>>& nodes);
  /// Sets the velocities of bodies to those of their nodes, which keep their momenta.
  void take_over(Model<D>& model, const std::vector<std::vector<Index>>& nodes);
  void answer_split(Model<D>& model);
  void move(Model<D>& model, const Clock& clock);

  std::vector<Index> bodies_;  ///< number in the mesh of each rigid body
  std::vector<Drive> drives_;
  std::vector<RigidBody<D>> laws_;
  std::vector<std::array<double, 2>> tables_;
  std::int64_t splits_seen_ = 0;
  RigidForceIn<D> force_;
  RigidMotionIn<D> motion_;
  RigidLoads part_load_;
};

void declare_rigid_keys(Schema& schema);

}  // namespace breccia
