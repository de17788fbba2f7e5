#pragma once
#include "base/sums.hpp"
#include "core/schema.hpp"
#include "loops/node_rest.hpp"
#include "step/module.hpp"

namespace breccia {

/// Takes motion out of a scene until its forces hold one another ([run.rest]).
template <int D>
class RestModule final : public Module<D> {
 public:
  static bool wanted(const Settings& scene) { return scene.at("run").has("rest"); }
  std::string key() const override { return "rest"; }
  void declare(Model<D>& model) override;
  void bind(Model<D>& model) override { resume(model); }
  void resume(Model<D>& model) override;
  void enlist(Model<D>& model, Plan& plan) override;
  void archive(Archive& archive) override;
  std::size_t bytes() const override { return rows_.span() * sizeof(double); }

 private:
  void watch(Model<D>& model);
  void take(Model<D>& model);
  void look(Model<D>& model, const Clock& clock);
  double kinetic(const Model<D>& model);
  void size_rows(Index entities);

  Model<D>* model_ = nullptr;
  bool by_kinetic_ = true, then_stop_ = true;
  double tolerance_ = 0, after_ = 0;
  double before_ = 0;  ///< J, kinetic energy one step ago
  ChunkSums<1> rows_;
};

/// The keys of [run.rest].
void declare_rest_keys(Schema& schema);

}  // namespace breccia
