#pragma once
#include "core/schema.hpp"
#include "loops/contact_force.hpp"
#include "modules/contact/contact_lists.hpp"
#include "step/module.hpp"

namespace breccia {

/// [contact] and [[contact.pair]].
void declare_contact_keys(Schema& schema);

/// Bodies, fragments and the two sides of broken faces press and rub against each other.
template <int D>
class Contact final : public Module<D> {
 public:
  static bool wanted(const Settings& scene) { return scene.has("contact"); }
  static void declare_keys(Schema& schema) { declare_contact_keys(schema); }

  std::string key() const override { return "contact"; }
  void declare(Model<D>& model) override;
  void bind(Model<D>& model) override;
  void resume(Model<D>& model) override;
  void enlist(Model<D>& model, Plan& plan) override;
  void add_stiffness(Model<D>& model, const Array<double>& stiffness) const override;
  bool has_springs() const override { return true; }
  void book(Model<D>& model, Ledger& ledger) const override;
  bool draws_forces() const override { return true; }
  void draw(Model<D>& model, Picture& picture) const override;
  void observe(Model<D>& model, const Clock& clock, Moment moment, Row& row) override;
  void count(Model<D>& model, Counts& counts) const override;
  Overlap deepest_overlap(Model<D>& model) const override;
  std::size_t bytes() const override {
    return lists_.bytes() + corner_stiffness_.span() * sizeof(double);
  }
  void archive(Archive& archive) override;

 private:
  void act(Model<D>& model, const Clock& clock);
  void read_tables(const Model<D>& model);

  ContactLists<D> lists_;
  ContactStiffness<D> rule_;
  ContactTable table_;
  Kokkos::View<FrictionLaw*, Memory> laws_;  ///< as the table; empty: all are Coulomb's
  CornerNumbers<D> corner_stiffness_;        ///< of the pairs of that version, N/m
  mutable std::int64_t stiffness_of_ = 0;
  bool smooth_ = true, distributed_ = false;
  bool rubs_ = false;  ///< some friction coefficient is above zero
  ChunkSums<3> lost_;  ///< J: friction, viscous, numeric
};

}  // namespace breccia
