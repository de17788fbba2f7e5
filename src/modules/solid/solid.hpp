#pragma once
#include "base/sums.hpp"
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
  void forces(Model<D>& model, const Clock& clock);
  void stop_at(Model<D>& model, Index element, const Clock& clock) const;

  std::vector<ChunkSums<1>> viscous_;  ///< J dissipated by damping, per block
  Array<Index> bad_;
};

}  // namespace breccia
