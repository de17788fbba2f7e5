#pragma once
#include "step/module.hpp"

namespace breccia {

/// Every [[sensor]] of the scene: columns of the history. Sensors are fixed to the material.
template <int D>
class Sensor final : public Module<D> {
 public:
  static bool wanted(const Settings& scene) { return !scene.list("sensor").empty(); }
  std::string key() const override { return "sensor"; }
  void bind(Model<D>& model) override;
  void resume(Model<D>& model) override;
  void enlist(Model<D>&, Plan&) override {}
  void observe(Model<D>& model, const Clock& clock, Moment moment, Row& row) override;

 private:
  enum class Kind { point, surface, reaction };
  struct Probe {
    std::string name;
    Kind kind;
    Index element = kNone;        ///< of a point, where this rank owns it
    std::vector<Index> families;  ///< original nodes
    std::vector<double> shares;   ///< weight of each
    Array<Index> nodes;           ///< their present copies
    Array<double> weights;
  };

  Probe point(const Model<D>& model, const Settings& section) const;
  Probe surface(const Model<D>& model, const Settings& section) const;
  Probe reaction(const Model<D>& model, const Settings& section) const;
  void find_copies(const Model<D>& model);
  void place_at_corners(const Model<D>& model, Probe& probe) const;
  void before(Model<D>& model, const Probe& probe, Row& row) const;
  void after(Model<D>& model, const Probe& probe, const Clock& clock, Row& row) const;

  std::vector<Probe> probes_;
  std::int64_t splits_ = -1;  ///< of the model when the copies were looked up
};

}  // namespace breccia
