#include "modules/fracture/fracture.hpp"

#include "fields/interface_fields.hpp"
#include "loops/fault_force.hpp"
#include "loops/interface_books.hpp"
#include "loops/interface_breaks.hpp"
#include "loops/interface_force.hpp"
#include "modules/fracture/crack_pictures.hpp"
#include "modules/fracture/existing_laws.hpp"
#include "modules/fracture/fracture_fields.hpp"
#include "step/friction_keys.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

namespace breccia {

namespace {

void add_to(const Array<double>& sum, const Array<double>& more, Index n) {
  for_each(
      "breccia::fracture::add_stiffness", n, KOKKOS_LAMBDA(Index i) { sum(i) += more(i); });
}

}  // namespace

template <int D>
bool Fracture<D>::wanted(const Settings& scene) {
  return !scene.children("fracture").empty() || !scene.list("interface").empty() ||
         has_existing_laws(scene);
}

template <int D>
void Fracture<D>::declare(Model<D>& model) {
  laws_ = read_interface_laws(*model.scene, model.materials);
  check_interface_laws(laws_, model);
  // Without contact, broken pairs go on pressing by themselves.
  contact_follows_ = model.scene->has("contact");
  Store& s = model.store;
  const auto faces = static_cast<Index>(model.topology.shared.size());
  s.set_size(Entity::face, faces, faces);
  const Index words = (model.elements() + kWordBits - 1) / kWordBits;
  s.set_size(Entity::element_word, words, words);
  s.add<FaceStatus>(key());
  s.add<FaceElements>(key());
  s.add<FaceCode>(key());
  s.add<FaceInterface>(key());
  s.add<ElementFaces<D>>(key());
  s.add<ElementHot>(key());
  s.add<InterfaceForce<D>>(key());
  s.add<InterfaceRecords>(key());
  s.add<InterfaceLife>(key());
  s.add<InterfaceActive<D>>(key());
  s.add<InterfaceStates<D>>(key());
  s.add<InterfaceEnergies<D>>(key());
  s.add<InterfacePairForce<D>>(key());
  has_faults_ = std::any_of(laws_.laws.begin(), laws_.laws.end(),
                            [](const InterfaceLaw& law) { return law.fault; });
  if (has_faults_) s.add<InterfaceFaults<D>>(key());
  s.add<InterfaceBreakTime>(key());
  s.add<InterfaceStiffness>(key());
  if (contact_follows_) s.add<InterfaceSlip<D>>(key());
  if (contact_remembers(*model.scene)) s.add<InterfaceRubbed<D>>(key());
  if (model.part.whole()) return;
  s.add<FaceLife>(key());
  s.add<FaceOnset>(key());
  s.add<FaceTipOnset>(key());
}

template <int D>
void Fracture<D>::bind(Model<D>& model) {
  const auto status = Kokkos::create_mirror_view(model.store.template get<FaceStatus>());
  const std::vector<Index> law = law_of_faces(laws_, model);
  for (std::size_t f = 0; f < law.size(); ++f)
    status(f) = law[f] == kNone ? face_status::tied : face_status::bonded;
  Kokkos::deep_copy(model.store.template get<FaceStatus>(), status);
  Kokkos::deep_copy(model.store.template get<FaceInterface>(), kNone);
  resume(model);
  insertion_.start(model);
  rebuild(model);
  lists_are_stale_ = false;
}

template <int D>
void Fracture<D>::resume(Model<D>& model) {
  fill_faces(model);
  std::vector<std::uint8_t> kind;
  for (const InterfaceLaw& law : laws_.laws)
    kind.push_back(law.fault     ? law_kind::fault
                   : law.z_curve ? law_kind::z_curve
                                 : law_kind::linear);
  kind_ = to_device("breccia::fracture::law_kind", kind);
  insertion_.prepare(model, laws_);
  for (Block& block : model.blocks) block.watch = watch_for(laws_, block.material);
  // A checkpoint holds neither the stiffness of the nodes nor the lists; the next forces make them.
  Kokkos::deep_copy(insertion_.touched(), std::uint8_t{1});
  lists_are_stale_ = true;
  changes_seen_ = model.surface_changes;
}

/// What the topology says about faces, on the device.
template <int D>
void Fracture<D>::fill_faces(Model<D>& model) {
  Store& s = model.store;
  const auto& shared = model.topology.shared;
  const auto elements = Kokkos::create_mirror_view(s.get<FaceElements>());
  const auto code = Kokkos::create_mirror_view(s.get<FaceCode>());
  const auto of_element = Kokkos::create_mirror_view(s.get<ElementFaces<D>>());
  Kokkos::deep_copy(of_element, kNone);
  for (std::size_t f = 0; f < shared.size(); ++f) {
    const SharedFace& face = shared[f];
    elements(f, 0) = face.left;
    elements(f, 1) = face.right;
    code(f) = static_cast<std::uint8_t>(face.left_face | face.right_face << 2 | face.rotation << 4);
    of_element(face.left, face.left_face) = static_cast<Index>(f);
    of_element(face.right, face.right_face) = static_cast<Index>(f);
  }
  const std::vector<Index> law = law_of_faces(laws_, model);
  breakable_ = 0;
  for (std::size_t f = 0; f < law.size(); ++f)
    if (law[f] != kNone && model.part.owns_element(shared[f].left)) ++breakable_;
  Kokkos::deep_copy(s.get<FaceElements>(), elements);
  Kokkos::deep_copy(s.get<FaceCode>(), code);
  Kokkos::deep_copy(s.get<ElementFaces<D>>(), of_element);
}

template <int D>
void Fracture<D>::enlist(Model<D>& model, Plan& plan) {
  if (!model.part.whole()) return enlist_shared(model, plan);
  plan.add(Stage::interface_force, "fracture::interface_force", key(),
           [this, &model](const Clock& clock) { forces(model, clock); })
      .template reading<NodePosition<D>, ElementNodes<D>>()
      .template writing<InterfaceForce<D>, InterfaceStates<D>, FaceStatus>();
  plan.add(Stage::split, "fracture::split", key(),
           [this, &model](const Clock&) {
             if (changes_seen_ != model.surface_changes) open_rims(model);
             const Index found = insertion_.check(model);
             if (found > 0) join(model, found);
           })
      .template reading<ElementHot, ElementForce<D>, InterfaceForce<D>, NodePosition<D>>()
      .template writing<FaceStatus, NodeCorners, CornerList, ElementNodes<D>, InterfaceForce<D>>();
}

template <int D>
void Fracture<D>::forces(Model<D>& model, const Clock& clock) {
  if (lists_are_stale_ || leaving_ > 0) retire(model);
  if (lists_.size() == 0) return;
  const Index aged = act(model, clock);
  book_forces(model);
  if (aged > 0) collect_breaks(model, clock);
}

/// Interfaces that left in the last step are gone, their forces with them.
template <int D>
void Fracture<D>::retire(Model<D>& model) {
  const Store& s = model.store;
  retire_interfaces<D>(
      s.count(Entity::interface),
      {face_map<D>(s), s.get<InterfaceRecords>(), s.get<ElementNodes<D>>(), s.get<NodeFamily>(),
       s.get<InterfaceLife>(), s.get<InterfacePairForce<D>>(), insertion_.touched()});
  insertion_.renew_stiffness(model);
  if (lists_.leave(leaving_) || lists_are_stale_) rebuild(model);
  lists_are_stale_ = false;
  leaving_ = 0;
}

template <int D>
void Fracture<D>::rebuild(const Model<D>& model) {
  clear_corner_forces<D>(lists_.elements(), lists_.element_count(),
                         model.store.template get<InterfaceForce<D>>());
  lists_.rebuild(model, laws_.laws.size());
}

/// New interfaces join the lists; the forces at their corners act in this step already.
template <int D>
void Fracture<D>::join(const Model<D>& model, Index found) {
  if (lists_.join(model, model.store.count(Entity::interface) - found))
    lists_.renew(model, insertion_.families(), insertion_.family_count());
  else
    book_forces(model);
}

/// Nodes at the rim of what was excavated come apart where only that held them together.
template <int D>
void Fracture<D>::open_rims(Model<D>& model) {
  changes_seen_ = model.surface_changes;
  insertion_.split_rims(model);
  if (lists_.size() > 0) lists_.renew(model, insertion_.families(), insertion_.family_count());
}

template <int D>
Index Fracture<D>::act(const Model<D>& model, const Clock& clock) const {
  const Store& s = model.store;
  InterfaceForceIn<D> in;
  in.x = s.get<NodePosition<D>>();
  in.nodes = lists_.nodes();
  in.record = s.get<InterfaceRecords>();
  in.active = s.get<InterfaceActive<D>>();
  in.rate = clock.dt_before > 0 ? 1 / clock.dt_before : 0;
  in.leave_broken = contact_follows_;
  in.thickness = model.thickness;
  in.sure = model.part.sure_face;
  const InterfaceForceOut<D> out{s.get<InterfaceStates<D>>(), s.get<InterfaceEnergies<D>>(),
                                 s.get<InterfacePairForce<D>>(), s.get<InterfaceLife>()};
  const FaultForceOut<D> at_fault{
      s.get_or_empty<InterfaceFaults<D>>(), out.state, out.energy, out.force, out.life,
      s.get_or_empty<InterfaceRubbed<D>>()};
  Index aged = 0;
  for (std::size_t l = 0; l < laws_.laws.size(); ++l) {
    in.list = lists_.list(l);
    in.count = lists_.size(l);
    in.strength = laws_.laws[l].strength;
    if (laws_.laws[l].fault)
      aged += fault_force<D>(in, laws_.laws[l].friction, at_fault);
    else
      aged += laws_.laws[l].z_curve ? interface_force<D, ZCurve>(in, out)
                                    : interface_force<D, LinearSoftening>(in, out);
  }
  return aged;
}

template <int D>
void Fracture<D>::book_forces(const Model<D>& model) const {
  const Store& s = model.store;
  book_pair_forces<D>(lists_.elements(), lists_.element_count(), lists_.sources(),
                      s.get<InterfacePairForce<D>>(), s.get<InterfaceForce<D>>());
}

/// Called when lives have changed. Faces whose corners have all broken in this step are released;
/// interfaces that leave do so before the next step's forces.
template <int D>
void Fracture<D>::collect_breaks(Model<D>& model, const Clock& clock) {
  const Store& s = model.store;
  const Index count = s.count(Entity::interface);
  make_room(changed_, "breccia::fracture::broken", count);
  const InterfaceBreaks<D> breaks{interface_map<D>(s), count, s.get<FaceStatus>()};
  const Index found = breaks.find(changed_);
  if (found > 0) {
    breaks.release(changed_, found, s.get<ElementNodes<D>>(), s.get<NodePosition<D>>(),
                   s.get<InterfaceStates<D>>(), s.get_or_empty<InterfaceSlip<D>>(),
                   s.get_or_empty<InterfaceRubbed<D>>());
    Index counted = found;
    if (!model.part.whole()) {
      make_room(counted_, "breccia::fracture::counted", found);
      counted = breaks.keep_own(changed_, found, model.part.own, counted_);
    }
    const std::vector<Event> events =
        break_events(model, model.part.whole() ? changed_ : counted_, counted, clock.time);
    events_.insert(events_.end(), events.begin(), events.end());
    released_ += counted;
    ++model.releases;
  }
  leaving_ = breaks.leaving();
}

template <int D>
void Fracture<D>::add_stiffness(Model<D>& model, const Array<double>& stiffness) const {
  const Store& s = model.store;
  if (s.count(Entity::interface) == 0) return;
  add_to(stiffness, s.get<InterfaceStiffness>(), model.nodes());
}

template <int D>
InterfaceSums Fracture<D>::sums(const Model<D>& model) const {
  const Store& s = model.store;
  return InterfaceBooks<D>{interface_map<D>(s)}.energies(
      s.get<InterfaceStates<D>>(), s.get_or_empty<InterfaceFaults<D>>(),
      s.get<InterfaceEnergies<D>>(), kind_, model.part.own, s.count(Entity::interface));
}

template <int D>
void Fracture<D>::book(Model<D>& model, Ledger& ledger) const {
  const InterfaceSums sum = sums(model);
  ledger.add("IF_stored", EnergyKind::stored, sum.stored);
  ledger.add("IF_G1", EnergyKind::dissipated, sum.tension);
  ledger.add("IF_G2", EnergyKind::dissipated, sum.shear);
  ledger.add("IF_friction", EnergyKind::dissipated, sum.friction);
  ledger.add("IF_viscous", EnergyKind::dissipated, sum.viscous);
}

template <int D>
void Fracture<D>::observe(Model<D>& model, const Clock&, Moment moment, Row& row) {
  if (moment != Moment::before) return;
  const InterfaceSums sum = sums(model);
  row.set("inserted", sum.count, Merge::sum);
  row.set("released", static_cast<double>(released_), Merge::sum);
  row.set("crack_area", sum.broken_area, Merge::sum);
  row.set("crack_energy", sum.tension + sum.shear, Merge::sum);
}

template <int D>
void Fracture<D>::draw(Model<D>& model, Picture& picture) const {
  const std::vector<CrackFace> faces = crack_faces(model);
  picture.cracks.insert(picture.cracks.end(), faces.begin(), faces.end());
}

template <int D>
std::vector<Event> Fracture<D>::take_events() {
  return std::exchange(events_, {});
}

template <int D>
void Fracture<D>::count(Model<D>& model, Counts& counts) const {
  const auto made = static_cast<std::int64_t>(sums(model).count);
  counts.bonded += breakable_ - made;
  counts.inserted += made - released_;
  counts.released += released_;
}

template <int D>
void Fracture<D>::archive(Archive& archive) {
  static_assert(sizeof(Event) % sizeof(double) == 0);
  constexpr std::size_t kNumbers = sizeof(Event) / sizeof(double);
  archive.total("fracture.released", released_);
  std::vector<double> events(events_.size() * kNumbers);
  std::memcpy(events.data(), events_.data(), events.size() * sizeof(double));
  archive.list("fracture.events", events);
  events_.resize(events.size() / kNumbers);
  std::memcpy(events_.data(), events.data(), events.size() * sizeof(double));
}

template class Fracture<2>;
template class Fracture<3>;

}  // namespace breccia
