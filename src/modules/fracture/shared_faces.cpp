// What the ranks tell one another of faces that more than one of them knows.
#include "loops/compact.hpp"
#include "modules/fracture/fracture.hpp"
#include "modules/fracture/fracture_fields.hpp"

namespace breccia {

/// The same with other ranks: who knows all about a face tells those who do not.
template <int D>
void Fracture<D>::enlist_shared(Model<D>& model, Plan& plan) {
  plan.add(Stage::interface_force, "fracture::interface_force", key(),
           [this, &model](const Clock& clock) { act_and_tell(model, clock); })
      .template reading<ElementNodes<D>>()
      .template reading_ghosts<NodePosition<D>>()
      .template writing<InterfaceForce<D>, InterfaceStates<D>, FaceLife>();
  plan.add(Stage::interface_force, "fracture::breaks", key(),
           [this, &model](const Clock& clock) { hear(model, clock); })
      .template reading_ghosts<FaceLife>()
      .template writing<FaceStatus>();
  plan.add(Stage::split, "fracture::onset", key(),
           [this, &model](const Clock&) {
             if (changes_seen_ != model.surface_changes) open_rims(model);
             insertion_.mark_onset(model);
           })
      .template reading<ElementHot, NodePosition<D>>()
      .template writing<FaceOnset>();
  plan.add(Stage::split, "fracture::tips", key(),
           [this, &model](const Clock&) { insertion_.mark_at_tips(model); })
      .template reading<ElementForce<D>, InterfaceForce<D>>()
      .template reading_ghosts<FaceOnset>()
      .template writing<FaceTipOnset>();
  plan.add(Stage::split, "fracture::split", key(),
           [this, &model](const Clock&) {
             const Index found = insertion_.finish_check(model);
             if (found > 0) join(model, found);
           })
      .template reading<ElementForce<D>, InterfaceForce<D>, NodePosition<D>>()
      .template reading_ghosts<FaceTipOnset>()
      .template writing<FaceStatus, NodeCorners, CornerList, ElementNodes<D>, InterfaceForce<D>>();
}

namespace {

/// Lives of inserted faces: what is known here goes out, what only others know comes in.
void tell_lives(Index count, const ConstArray<InterfaceRecord>& record,
                const ConstArray<std::uint8_t>& life, const Array<std::uint8_t>& told) {
  for_each(
      "breccia::fracture::tell_lives", count,
      KOKKOS_LAMBDA(Index i) { told(record(i).face) = life(i); });
}

Index hear_lives(Index count, const ConstArray<InterfaceRecord>& record,
                 const ConstArray<std::uint8_t>& sure, const ConstArray<std::uint8_t>& told,
                 const Array<std::uint8_t>& life) {
  return scan(
      "breccia::fracture::hear_lives", count, KOKKOS_LAMBDA(Index i, Index & aged, bool last) {
        const Index face = record(i).face;
        if (sure(face) != 0 || told(face) <= life(i) || told(face) == interface_life::gone) return;
        ++aged;
        if (last) life(i) = told(face);
      });
}

}  // namespace

template <int D>
void Fracture<D>::act_and_tell(Model<D>& model, const Clock& clock) {
  if (lists_are_stale_ || leaving_ > 0) retire(model);
  aged_ = lists_.size() == 0 ? 0 : act(model, clock);
  if (lists_.size() > 0) book_forces(model);
  const Store& s = model.store;
  tell_lives(s.count(Entity::interface), s.get<InterfaceRecords>(), s.get<InterfaceLife>(),
             s.get<FaceLife>());
}

template <int D>
void Fracture<D>::hear(Model<D>& model, const Clock& clock) {
  const Store& s = model.store;
  aged_ += hear_lives(s.count(Entity::interface), s.get<InterfaceRecords>(), model.part.sure_face,
                      s.get<FaceLife>(), s.get<InterfaceLife>());
  if (aged_ > 0) collect_breaks(model, clock);
}

template void Fracture<2>::enlist_shared(Model<2>&, Plan&);
template void Fracture<3>::enlist_shared(Model<3>&, Plan&);
template void Fracture<2>::act_and_tell(Model<2>&, const Clock&);
template void Fracture<3>::act_and_tell(Model<3>&, const Clock&);
template void Fracture<2>::hear(Model<2>&, const Clock&);
template void Fracture<3>::hear(Model<3>&, const Clock&);

}  // namespace breccia
