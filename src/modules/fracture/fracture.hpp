#pragma once
#include "core/schema.hpp"
#include "loops/interface_books.hpp"
#include "modules/fracture/insertion.hpp"
#include "modules/fracture/interface_lists.hpp"
#include "step/module.hpp"

namespace breccia {

/// [fracture.NAME] and [[interface]].
void declare_fracture_keys(Schema& schema);

/// Interfaces between elements: inserted when the traction on a face reaches its onset, softening
/// until they are broken, then left to contact.
template <int D>
class Fracture final : public Module<D> {
 public:
  static bool wanted(const Settings& scene);
  static void declare_keys(Schema& schema) { declare_fracture_keys(schema); }

  std::string key() const override { return "fracture"; }
  void declare(Model<D>& model) override;
  void bind(Model<D>& model) override;
  void resume(Model<D>& model) override;
  void enlist(Model<D>& model, Plan& plan) override;
  void add_stiffness(Model<D>& model, const Array<double>& stiffness) const override;
  bool has_springs() const override { return true; }
  void book(Model<D>& model, Ledger& ledger) const override;
  void observe(Model<D>& model, const Clock& clock, Moment moment, Row& row) override;
  void draw(Model<D>& model, Picture& picture) const override;
  std::vector<Event> take_events() override;
  void count(Model<D>& model, Counts& counts) const override;
  std::size_t bytes() const override {
    return insertion_.bytes() + lists_.bytes() + bytes_of(kind_, changed_, counted_);
  }
  void archive(Archive& archive) override;

 private:
  void fill_faces(Model<D>& model);
  void enlist_shared(Model<D>& model, Plan& plan);
  void forces(Model<D>& model, const Clock& clock);
  void act_and_tell(Model<D>& model, const Clock& clock);
  void hear(Model<D>& model, const Clock& clock);
  void retire(Model<D>& model);
  Index act(const Model<D>& model, const Clock& clock) const;
  void book_forces(const Model<D>& model) const;
  void rebuild(const Model<D>& model);
  void join(const Model<D>& model, Index found);
  void open_rims(Model<D>& model);
  void collect_breaks(Model<D>& model, const Clock& clock);
  InterfaceSums sums(const Model<D>& model) const;

  InterfaceLaws laws_;
  Array<std::uint8_t> kind_;  ///< law_kind of each law
  bool has_faults_ = false;
  bool contact_follows_ = false;
  std::int64_t changes_seen_ = 0;  ///< of Model::surface_changes
  bool lists_are_stale_ = true;    ///< not made yet for this state
  Index leaving_ = 0;              ///< interfaces whose last force acts in this step
  Index breakable_ = 0;            ///< own faces that have a law
  Index aged_ = 0;                 ///< lives that changed in this step, with many ranks
  std::int64_t released_ = 0;
  Insertion<D> insertion_;
  InterfaceLists<D> lists_;
  Array<Index> changed_;  ///< interfaces that broke in this step
  Array<Index> counted_;  ///< those of them that this rank owns
  std::vector<Event> events_;
};

}  // namespace breccia
