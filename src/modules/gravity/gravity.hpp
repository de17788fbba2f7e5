#pragma once
#include "point/ramp.hpp"
#include "step/module.hpp"

namespace breccia {

/// A uniform acceleration of everything. The motion loop applies it; nothing is stored.
template <int D>
class Gravity final : public Module<D> {
 public:
  static bool wanted(const Settings& scene) { return scene.has("gravity"); }
  std::string key() const override { return "gravity"; }
  void bind(Model<D>& model) override;
  void enlist(Model<D>& model, Plan& plan) override;

 private:
  Vec<D> full_ = Vec<D>::zero();  ///< m/s2, at the end of the ramp
  Ramp ramp_;
};

}  // namespace breccia
