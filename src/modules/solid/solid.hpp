#pragma once
#include "loops/element_laws.hpp"
#include "step/module.hpp"

namespace breccia {

/// Elasticity of the elements, block by block. Always present.
template <int D>
class Solid final : public Module<D> {
 public:
  std::string key() const override { return "solid"; }
  void declare(Model<D>& model) override;
  void bind(Model<D>& model) override;
  void resume(Model<D>& model) override;
  void enlist(Model<D>& model, Plan& plan) override;
  void book(Model<D>& model, Ledger& ledger) const override;
  void draw(Model<D>& model, Picture& picture) const override;
  void archive(Archive& archive) override;

 private:
  /// Whether the elements of a block need more than their shapes: plastic flow, an equation of
  /// state, initial stress.
  bool remembers(const Model<D>& model, const Block& block) const;
  void set_start(Model<D>& model);
  AnisotropicState<D> anisotropic_state(const Model<D>& model, const Material& material) const;
  ElementForceIn<D> input(const Model<D>& model, const Block& block, const Clock& clock) const;
  void forces(Model<D>& model, const Clock& clock);
  double stored(const Model<D>& model, std::size_t block) const;
  void draw_history(const Model<D>& model, Picture& picture) const;
  void stop_at(Model<D>& model, Index element, const Clock& clock) const;

  std::vector<ElementSums> sums_;                 ///< energies of each block
  std::vector<AnisotropicState<D>> anisotropic_;  ///< per material
  Array<Index> bad_;
};

}  // namespace breccia
