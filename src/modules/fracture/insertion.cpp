#include "modules/fracture/insertion.hpp"

#include "core/log.hpp"
#include "fields/interface_fields.hpp"
#include "loops/compact.hpp"
#include "loops/face_insertion.hpp"
#include "loops/face_onset.hpp"
#include "loops/interface_books.hpp"
#include "loops/star_balance.hpp"
#include "modules/fracture/fracture_fields.hpp"
#include "modules/fracture/interface_lists.hpp"
#include "step/node_forces.hpp"
#include "step/stress_view.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace breccia {

namespace {

/// Families whose stars are looked at together before the first step.
constexpr Index kBatch = 1 << 15;

/// Forces on the corners of elements, class by class.
template <int D>
Kokkos::Array<AnyCornerForces<D>, kCornerForceClasses> corner_forces(const Store& s) {
  Kokkos::Array<AnyCornerForces<D>, kCornerForceClasses> force;
  force[0] = element_forces<D>(s);
  force[1].wide = s.get<InterfaceForce<D>>();
  force[2].wide = s.get_or_empty<ContactForce<D>>();
  force[3].wide = s.get_or_empty<LoadForce<D>>();
  return force;
}

/// Lowers the flags of the listed elements.
void lower(const Array<BitWord>& hot, const Array<Index>& list, Index count) {
  for_each(
      "breccia::fracture::lower", count,
      KOKKOS_LAMBDA(Index k) { Kokkos::atomic_store(&hot(list(k) / kWordBits), BitWord{0}); });
}

}  // namespace

template <int D>
void Insertion<D>::prepare(const Model<D>& model, const InterfaceLaws& laws) {
  table_ = laws;
  faults_started_ = std::none_of(laws.laws.begin(), laws.laws.end(),
                                 [](const InterfaceLaw& law) { return law.fault; });
  laws_ = to_device("breccia::fracture::laws", laws.laws);
  std::vector<std::uint16_t> law_of;
  for (const Index law : law_of_faces(laws, model))
    law_of.push_back(law == kNone ? 0 : static_cast<std::uint16_t>(law));
  law_of_ = to_device("breccia::fracture::law_of", law_of);
  sides_ = to_device("breccia::fracture::sides", interface_sides(model));
  std::vector<double> density;
  for (const Material& m : model.materials) density.push_back(m.density);
  density_ = to_device("breccia::fracture::density", density);
  const auto families = static_cast<std::size_t>(model.store.count(Entity::family));
  touched_ = Array<std::uint8_t>("breccia::fracture::touched", families);
  strained_ = Array<std::uint8_t>("breccia::fracture::strained", families);
  hot_ =
      allocate<Array<Index>>("breccia::fracture::hot", static_cast<std::size_t>(model.elements()));
  tips_.prepare(model);
  tips_.renew(at_tips(model), {}, model.store.count(Entity::family));
}

template <int D>
StarMap<D> Insertion<D>::star_map(const Store& s) const {
  return {face_map<D>(s),         s.get<FaceStatus>(),  s.get<ElementNodes<D>>(),
          s.get<FamilyCorners>(), s.get<NodeCorners>(), s.get<CornerList>()};
}

template <int D>
Index Insertion<D>::start(Model<D>& model) {
  std::vector<Index> faces;
  const std::vector<Index> law = law_of_faces(table_, model);
  for (std::size_t f = 0; f < law.size(); ++f) {
    if (law[f] != kNone && table_.laws[static_cast<std::size_t>(law[f])].at_start)
      faces.push_back(static_cast<Index>(f));
  }
  if (!faces.empty())
    insert(model, to_device("breccia::fracture::at_start", faces),
           static_cast<Index>(faces.size()));
  // In batches, so that the room for stars stays small beside the mesh.
  const Index families = model.store.count(Entity::family);
  for (Index begin = 0; begin < families; begin += kBatch) {
    const Index end = std::min<Index>(families, begin + kBatch);
    Kokkos::deep_copy(touched_, std::uint8_t{0});
    Kokkos::deep_copy(Kokkos::subview(touched_, std::make_pair(begin, end)), std::uint8_t{1});
    split(model);
  }
  work_ = StarWork<D>{};
  return static_cast<Index>(faces.size());
}

/// Faults wait for the first forces, so that they begin with the tractions that these ask for.
template <int D>
Index Insertion<D>::start_faults(Model<D>& model) {
  faults_started_ = true;
  const auto status = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{},
                                                          model.store.template get<FaceStatus>());
  const std::vector<Index> law = law_of_faces(table_, model);
  std::vector<Index> faces;
  for (std::size_t f = 0; f < law.size(); ++f)
    if (law[f] != kNone && table_.laws[static_cast<std::size_t>(law[f])].fault &&
        status(f) == face_status::bonded)
      faces.push_back(static_cast<Index>(f));
  if (faces.empty()) return 0;
  const auto count = static_cast<Index>(faces.size());
  insert(model, to_device("breccia::fracture::faults", faces), count);
  split(model);
  return count;
}

template <int D>
Index Insertion<D>::check(Model<D>& model) {
  if (!faults_started_) {
    const Index found = start_faults(model);
    if (found > 0) return found;
  }
  Index found = find_hot(model);
  if (found > 0) insert(model, found_, found);
  const Index at_tip = tips_.find(at_tips(model));
  if (at_tip > 0) insert(model, tips_.found(), at_tip);
  found += at_tip;
  if (found > 0) split(model);
  return found;
}

namespace {

/// Raises the marks of listed faces about which everything is known here.
void mark_sure(const Array<Index>& faces, Index count, const Array<std::uint8_t>& sure,
               const Array<std::uint8_t>& marks) {
  Kokkos::deep_copy(marks, std::uint8_t{0});
  for_each(
      "breccia::fracture::mark_sure", count,
      KOKKOS_LAMBDA(Index k) { marks(faces(k)) = sure(faces(k)); });
}

}  // namespace

template <int D>
void Insertion<D>::mark_onset(Model<D>& model) {
  inserted_ = 0;
  faults_now_ = false;
  if (!faults_started_) {
    inserted_ = start_faults(model);
    faults_now_ = model.part.any(inserted_ > 0);
  }
  const Index found = faults_now_ ? 0 : find_hot(model);
  mark_sure(found_, found, model.part.sure_face, model.store.template get<FaceOnset>());
}

template <int D>
void Insertion<D>::mark_at_tips(Model<D>& model) {
  inserted_ += insert_marked(model, model.store.template get<FaceOnset>());
  const Index found = faults_now_ ? 0 : tips_.find(at_tips(model));
  mark_sure(tips_.found(), found, model.part.sure_face, model.store.template get<FaceTipOnset>());
}

template <int D>
Index Insertion<D>::finish_check(Model<D>& model) {
  inserted_ += insert_marked(model, model.store.template get<FaceTipOnset>());
  if (inserted_ > 0) split(model);
  return inserted_;
}

template <int D>
Index Insertion<D>::insert_marked(Model<D>& model, const Array<std::uint8_t>& marks) {
  const Index faces = model.store.count(Entity::face);
  make_room(found_, "breccia::fracture::onset_faces", faces);
  const Index found = compact("breccia::fracture::marked_faces", marks, faces, found_);
  if (found > 0) insert(model, found_, found);
  return found;
}

template <int D>
TipOnsetIn<D> Insertion<D>::at_tips(const Model<D>& model) const {
  const Store& s = model.store;
  TipOnsetIn<D> in;
  in.map = star_map(s);
  in.of_face = s.get<FaceInterface>();
  in.active = s.get<InterfaceActive<D>>();
  in.force = corner_forces<D>(s);
  in.corner_mass = {stress_of(model), density_};
  in.family = s.get<NodeFamily>();
  in.flags = s.get<NodeFlags>();
  in.fixed = ((1u << D) - 1) * node_flag::fixed_x;
  in.velocity = s.get<NodeVelocity<D>>();
  in.law_of = law_of_;
  in.laws = laws_;
  in.thickness = model.thickness;
  return in;
}

/// Bonded faces beyond their onset by the mean stress of their elements.
template <int D>
Index Insertion<D>::find_hot(Model<D>& model) {
  const Store& s = model.store;
  const Index hot = compact("breccia::fracture::hot_elements", s.get<ElementHot>(), hot_);
  if (hot == 0) return 0;
  make_room(mark_, "breccia::fracture::onset_mark", hot * (D + 1));
  make_room(found_, "breccia::fracture::onset_faces", hot * (D + 1));
  const FaceOnsetIn<D> in{face_map<D>(s),
                          s.get<FaceStatus>(),
                          stress_of(model),
                          s.get<ElementHot>(),
                          law_of_,
                          laws_,
                          s.get<NodeFamily>(),
                          s.get<FaceInterface>(),
                          s.get<InterfaceActive<D>>(),
                          s.get<InterfaceRecords>(),
                          s.get<NodeVelocity<D>>(),
                          strained_};
  const bool some = s.count(Entity::interface) > 0;  // else none can be locked
  const Index strained = some ? flag_strained(in, hot_, hot) : 0;
  const Index found = find_onset(in, hot_, hot, mark_, found_);
  if (strained > 0) Kokkos::deep_copy(strained_, std::uint8_t{0});
  lower(s.get<ElementHot>(), hot_, hot);
  return found;
}

template <int D>
void Insertion<D>::insert(Model<D>& model, const Array<Index>& faces, Index count) {
  Store& s = model.store;
  const Index first = s.count(Entity::interface);
  const Index needed = first + count;
  if (needed > s.capacity(Entity::interface))
    s.set_size(Entity::interface, first,
               std::max<Index>(needed, s.capacity(Entity::interface) * 2));
  s.set_count(Entity::interface, needed);
  const FaceInsertionIn<D> in{face_map<D>(s),
                              s.get<ElementNodes<D>>(),
                              s.get<NodeReference<D>>(),
                              s.get<NodeFamily>(),
                              stress_of(model),
                              sides_,
                              law_of_,
                              laws_,
                              s.get<NodeVelocity<D>>(),
                              faces,
                              first};
  const FaceInsertionOut<D> out{s.get<FaceStatus>(),
                                s.get<FaceInterface>(),
                                s.get<InterfaceRecords>(),
                                s.get<InterfaceLife>(),
                                s.get<InterfaceActive<D>>(),
                                s.get<InterfacePairForce<D>>(),
                                touched_};
  insert_faces(count, in, out);
}

template <int D>
void Insertion<D>::grow_nodes(Model<D>& model, Index needed) const {
  Store& s = model.store;
  const Index before = s.capacity(Entity::node);
  if (needed <= before) return;
  const Index after = std::max<Index>(needed, before + before / 2);
  s.set_size(Entity::node, s.count(Entity::node), after);
  log::info(fmt::format("fracture: room for nodes grows from {} to {}", before, after));
}

template <int D>
void Insertion<D>::list_touched(const Model<D>& model) {
  const Index families = model.store.count(Entity::family);
  make_room(work_.family, "breccia::fracture::touched_families", families);
  work_.families = compact("breccia::fracture::touched_families", touched_, families, work_.family);
  Kokkos::deep_copy(touched_, std::uint8_t{0});
}

template <int D>
void Insertion<D>::sum_stiffness(const Model<D>& model) const {
  const Store& s = model.store;
  InterfaceBooks<D>{interface_map<D>(s)}.stiffness(
      work_.family, work_.families, s.get<FamilyCorners>(), s.get<CornerList>(),
      s.get<ElementNodes<D>>(), s.get<InterfaceStiffness>());
}

template <int D>
void Insertion<D>::renew_stiffness(const Model<D>& model) {
  list_touched(model);
  sum_stiffness(model);
}

template <int D>
void Insertion<D>::split(Model<D>& model) {
  Store& s = model.store;
  list_touched(model);
  make_room(work_.begin, "breccia::fracture::star_begin", work_.families);
  make_room(work_.fresh, "breccia::fracture::star_fresh", work_.families);
  Stars<D> stars{star_map(s), work_};
  work_.reserve(stars.place());
  stars.work = work_;
  stars.find_components();
  const Index fresh = stars.number_new_nodes();
  if (fresh == 0) {
    tips_.renew(at_tips(model), work_.family, work_.families);
    return;
  }

  const Index first = s.count(Entity::node);
  make_room(parent_, "breccia::fracture::parent", fresh);
  stars.name_owners(first, parent_);
  balance(model, stars);
  grow_nodes(model, first + fresh);
  s.set_count(Entity::node, first + fresh);
  s.copy_rows(Entity::node, parent_, first, fresh);
  stars.map = star_map(s);
  stars.relabel({stress_of(model), density_}, s.get<NodeMass>(), s.get<NodeFlags>(),
                node_flag::interface);
  sum_stiffness(model);
  tips_.renew(at_tips(model), work_.family, work_.families);
  ++model.splits;
  model.step_is_stale = true;
}

template <int D>
void Insertion<D>::split_rims(Model<D>& model) {
  const Store& s = model.store;
  const FaceMap<D> faces = face_map<D>(s);
  const Array<std::uint8_t> status = s.get<FaceStatus>(), touched = touched_;
  const Array<Index> family = s.get<NodeFamily>();
  const ConstConnectivity<D> nodes = s.get<ElementNodes<D>>();
  for_each(
      "breccia::fracture::rims", s.count(Entity::face), KOKKOS_LAMBDA(Index f) {
        if (status(f) != face_status::cut) return;
        for (int c = 0; c < D; ++c) {
          for (const auto& at : {faces.left(f, c), faces.right(f, c)})
            raise(touched, family(nodes(at.element, at.node)));
        }
      });
  split(model);
}

template <int D>
void Insertion<D>::balance(const Model<D>& model, const Stars<D>& stars) const {
  const Store& s = model.store;
  StarBalanceIn<D> in;
  in.map = stars.map;
  in.work = stars.work;
  in.force = corner_forces<D>(s);
  in.corner_mass = {stress_of(model), density_};
  in.flags = s.get<NodeFlags>();
  in.fixed_x = node_flag::fixed_x;
  in.x = s.get<NodePosition<D>>();
  in.of_face = s.get<FaceInterface>();
  in.record = s.get<InterfaceRecords>();
  in.laws = laws_;
  balance_stars(
      in, {s.get<InterfaceStates<D>>(), s.get<InterfaceEnergies<D>>(), s.get<InterfaceActive<D>>(),
           s.get<InterfacePairForce<D>>(), s.get_or_empty<InterfaceFaults<D>>()});
}

template <int D>
std::size_t Insertion<D>::bytes() const {
  const StarWork<D>& w = work_;
  return tips_.bytes() + bytes_of(laws_, law_of_, sides_, density_, hot_, found_, parent_, mark_,
                                  touched_, strained_, w.family, w.begin, w.fresh, w.root, w.owner,
                                  w.link, w.weight, w.mass, w.wanted, w.potential, w.residual,
                                  w.direction, w.image);
}

template class Insertion<2>;
template class Insertion<3>;

}  // namespace breccia
