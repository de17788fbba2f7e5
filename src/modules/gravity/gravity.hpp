#pragma once
#include "step/module.hpp"

namespace breccia {

/// A uniform acceleration of everything. The motion loop applies it; nothing is stored.
template <int D>
class Gravity final : public Module<D> {
 public:
  static bool wanted(const Settings& scene) { return scene.has("gravity"); }
  std::string key() const override { return "gravity"; }
  void bind(Model<D>& model) override;
  void enlist(Model<D>&, Plan&) override {}
};

}  // namespace breccia
