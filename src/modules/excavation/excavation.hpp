#pragma once
#include "base/sums.hpp"
#include "core/schema.hpp"
#include "step/module.hpp"

#include <vector>

namespace breccia {

/// Takes elements out of the scene ([[excavate]]): within `release` they lose stress and mass.
template <int D>
class ExcavationModule final : public Module<D> {
 public:
  static bool wanted(const Settings& scene) { return !scene.list("excavate").empty(); }
  std::string key() const override { return "excavation"; }
  void declare(Model<D>& model) override;
  void bind(Model<D>& model) override;
  void resume(Model<D>& model) override;
  void enlist(Model<D>& model, Plan& plan) override;
  void book(Model<D>& model, Ledger& ledger) const override;
  void draw(Model<D>& model, Picture& picture) const override;
  void archive(Archive& archive) override;
  std::size_t bytes() const override;

 private:
  void release(Model<D>& model, const Clock& clock);
  void take_masses(Model<D>& model) const;
  void book_release(Model<D>& model);
  double whole_energy(const Model<D>& model, std::size_t number) const;
  void warn_of_floating_pieces(const Model<D>& model) const;

  /// One excavation between two steps.
  struct Course {
    double at = 0, duration = 0;  ///< s
    double before = 1;            ///< share one step ago
    double energy = -1;           ///< J that its elements would store, one step ago; -1: not known
    Array<Index> rim;             ///< shared faces with one side in it
  };
  std::vector<Course> courses_;
  Model<D>* model_ = nullptr;
  double taken_ = 0;  ///< J, stored energy that went with the elements
  Array<Index> families_;
  Array<double> density_;
  ChunkSums<1> rows_;
};

/// The keys of [[excavate]].
void declare_excavation_keys(Schema& schema);

}  // namespace breccia
