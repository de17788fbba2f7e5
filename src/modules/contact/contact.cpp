#include "modules/contact/contact.hpp"

#include "loops/contact_distributed.hpp"
#include "loops/contact_gather.hpp"
#include "modules/contact/contact_fields.hpp"
#include "modules/contact/contact_pictures.hpp"
#include "step/friction_keys.hpp"

#include <algorithm>
#include <cmath>

namespace breccia {

namespace {

/// Steps over which a jump of the potential fades (ALGORITHMS ).
constexpr double kFading = 30;

double harmonic(double a, double b) {
  return 2 * a * b / (a + b);
}

ContactListKeys list_keys(const Settings& contact) {
  return {contact.number("skin"), contact.text("force") == "distributed_potential",
          contact.text("points") == "corners"};
}

/// Of contactor * materials + target.
std::vector<FrictionLaw> friction_laws(const Settings& contact,
                                       const std::vector<Material>& materials) {
  const std::size_t n = materials.size();
  std::vector<FrictionLaw> laws(n * n, read_friction(contact, "friction"));
  for (const Settings& pair : contact.list("pair")) {
    const std::string &first = pair.texts("between").front(),
                      &second = pair.texts("between").back();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        if ((materials[i].name == first && materials[j].name == second) ||
            (materials[i].name == second && materials[j].name == first))
          laws[i * n + j] = read_friction(pair, "friction");
  }
  return laws;
}

}  // namespace

template <int D>
void Contact<D>::declare(Model<D>& model) {
  Store& s = model.store;
  lists_.follow(model.part);
  s.add<ContactForce<D>>(key());
  s.add<ContactPoint>(key());
  s.add<ContactElement>(key());
  s.add<ContactMemory<D>>(key());
  if (contact_remembers(*model.scene)) s.add<ContactRubbed>(key());
}

template <int D>
void Contact<D>::read_tables(const Model<D>& model) {
  const Settings& contact = model.scene->at("contact");
  rule_.factor = contact.number("stiffness_factor");
  rule_.fixed = contact.maybe_number("stiffness").value_or(0.0);
  rule_.damping = contact.number("damping");
  smooth_ = contact.text("direction") == "smooth";
  distributed_ = contact.text("force") == "distributed_potential";
  const auto& materials = model.materials;
  const std::size_t n = materials.size();
  const std::vector<FrictionLaw> friction = friction_laws(contact, materials);
  rubs_ = std::any_of(friction.begin(), friction.end(),
                      [](const FrictionLaw& law) { return law.at_rest > 0; });
  Kokkos::View<double* [2], Rows, Memory> moduli("breccia::contact::moduli", n);
  table_ = ContactTable("breccia::contact::table", n * n);
  const auto host = Kokkos::create_mirror_view(moduli);
  const auto table = Kokkos::create_mirror_view(table_);
  for (std::size_t i = 0; i < n; ++i) {
    const double own = model.p_wave_modulus(static_cast<Index>(i));
    host(i, 0) = own;
    host(i, 1) = materials[i].density;
    for (std::size_t j = 0; j < n; ++j) {
      const double both = harmonic(own, model.p_wave_modulus(static_cast<Index>(j)));
      table(i * n + j, 0) = friction[i * n + j].at_rest;
      table(i * n + j, 1) = rule_.fixed > 0 ? 1.0 : both / own;
      table(i * n + j, 2) = harmonic(materials[i].mu(), materials[j].mu()) / both;
      // Critical for both, hence for the lighter one; 1 exactly where they are alike.
      const double mass = 2 / (1 + materials[i].density / materials[j].density);
      table(i * n + j, 3) = std::sqrt(table(i * n + j, 1) * mass);
    }
  }
  Kokkos::deep_copy(moduli, host);
  Kokkos::deep_copy(table_, table);
  if (contact_remembers(*model.scene)) laws_ = to_device("breccia::contact::laws", friction);
  rule_.material = moduli;
  corner_stiffness_ = CornerNumbers<D>("breccia::contact::corner_stiffness",
                                       static_cast<std::size_t>(model.elements()));
}

template <int D>
void Contact<D>::bind(Model<D>& model) {
  read_tables(model);
  lists_.prepare(model, list_keys(model.scene->at("contact")));
  lists_.start(model, rule_);
  // What overlaps at the start is stored from the start, not made.
  act(model, Clock{});
  Kokkos::deep_copy(lost_, 0.0);
}

template <int D>
void Contact<D>::resume(Model<D>& model) {
  read_tables(model);
  lists_.prepare(model, list_keys(model.scene->at("contact")));
  lists_.resume(model, rule_);
}

template <int D>
void Contact<D>::enlist(Model<D>& model, Plan& plan) {
  plan.add(Stage::search, "contact::search", key(),
           [this, &model](const Clock& clock) { lists_.look(model, clock, rule_); })
      .template reading<ElementNodes<D>>()
      .template reading_ghosts<NodePosition<D>, NodeVelocity<D>>()
      .template writing<NodeFlags, ContactPoint>();
  plan.add(Stage::contact_force, "contact::force", key(),
           [this, &model](const Clock& clock) { act(model, clock); })
      .template reading<ContactPoint>()
      .template reading_ghosts<NodePosition<D>, NodeVelocity<D>>()
      .template writing<ContactForce<D>, ContactMemory<D>>();
}

template <int D>
void Contact<D>::act(Model<D>& model, const Clock& clock) {
  const ContactPairs<D>& pairs = lists_.pairs();
  const bool jumped = lists_.take_jump();
  if (pairs.points == 0) return;
  const auto chunks = static_cast<std::size_t>(chunks_of(pairs.points));
  if (lost_.extent(0) < chunks) Kokkos::resize(lost_, chunks + chunks / 4);
  const Store& s = model.store;
  ContactForceIn<D> in;
  in.surface = lists_.surface();
  in.pairs = pairs;
  in.point = lists_.point();
  in.x = s.get<NodePosition<D>>();
  in.v = s.get<NodeVelocity<D>>();
  in.element_nodes = s.get<ElementNodes<D>>();
  in.element_material = s.get<ElementMaterial>();
  if (s.has<FaceStatus>()) in.family = s.get<NodeFamily>();
  in.table = table_;
  in.laws = laws_;
  in.materials = static_cast<Index>(model.materials.size());
  in.dt_before = clock.dt_before;
  in.keep = std::exp(-1 / kFading);
  in.jumped = jumped;
  in.smooth = smooth_;
  const ContactForceOut<D> out{lists_.history(model), lists_.signals(), lost_};
  if (distributed_) {
    contact_force_distributed<D>(in, out);
    gather_contact_distributed<D>(lists_.surface(), pairs, s.get<ContactForce<D>>());
  } else {
    contact_force<D>(in, out);
    gather_contact<D>(lists_.surface(), pairs, s.get<ContactForce<D>>());
  }
}

template <int D>
void Contact<D>::add_stiffness(Model<D>& model, const Array<double>& stiffness) const {
  const Store& s = model.store;
  ContactStiffnessIn<D> in;
  in.surface = lists_.surface();
  in.pairs = lists_.pairs();
  in.point = lists_.point();
  in.element_material = s.get<ElementMaterial>();
  in.table = table_;
  in.materials = static_cast<Index>(model.materials.size());
  in.element_nodes = s.get<ElementNodes<D>>();
  in.corners = s.get<NodeCorners>();
  in.corner_list = s.get<CornerList>();
  in.flags = s.get<NodeFlags>();
  in.bit = node_flag::contact;
  in.nodes = model.nodes();
  in.corner = corner_stiffness_;
  if (stiffness_of_ != lists_.version()) find_contact_stiffness(in);
  stiffness_of_ = lists_.version();
  add_contact_stiffness(in, stiffness);
}

template <int D>
void Contact<D>::book(Model<D>& model, Ledger& ledger) const {
  const Index points = model.store.count(Entity::contact_point);
  const Sums<3> lost = total_of(lost_);
  ledger.add("CT_stored", EnergyKind::stored, stored_energy(lists_.history(model), points));
  if (rubs_) ledger.add("CT_friction", EnergyKind::dissipated, lost[0]);
  ledger.add("CT_viscous", EnergyKind::dissipated, lost[1]);
  ledger.add("CT_numeric", EnergyKind::dissipated, lost[2]);
}

template <int D>
void Contact<D>::draw(Model<D>& model, Picture& picture) const {
  picture.node_fields.push_back(draw_contact_force(model));
  picture.touches = find_touches(model, lists_.surface(), lists_.pairs());
}

template <int D>
void Contact<D>::observe(Model<D>& model, const Clock&, Moment moment, Row& row) {
  if (moment != Moment::before) return;
  Counts counts;
  count(model, counts);
  row.set("contacts", static_cast<double>(counts.contact_points), Merge::sum);
  const auto signals =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, lists_.signals().value);
  row.set("contacts_lost", signals(ContactSignals::lost), Merge::sum);
  row.set("overlap", deepest_overlap(model).share, Merge::largest);
}

template <int D>
void Contact<D>::count(Model<D>& model, Counts& counts) const {
  counts.contact_points +=
      pressing_points(lists_.history(model), model.store.count(Entity::contact_point));
}

template <int D>
Overlap Contact<D>::deepest_overlap(Model<D>& model) const {
  const ContactPairs<D>& pairs = lists_.pairs();
  const DeepestPoint deepest =
      deepest_point(lists_.history(model), pairs.facet, lists_.surface().height, pairs.points);
  if (deepest.point == kNone) return {};
  Index point = 0;
  Kokkos::deep_copy(point, Kokkos::subview(pairs.point, deepest.point));
  return {deepest.share, point / kFacePoints<D> / (D + 1)};
}

template <int D>
void Contact<D>::archive(Archive& archive) {
  lists_.archive(archive);
  const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, lost_);
  std::vector<double> values(host.data(), host.data() + host.size());
  archive.sums("contact.lost", values, 3);
  if (!archive.loading()) return;
  lost_ = ChunkSums<3>("breccia::contact::lost", values.size() / 3);
  const auto mirror = Kokkos::create_mirror_view(lost_);
  std::copy(values.begin(), values.end(), mirror.data());
  Kokkos::deep_copy(lost_, mirror);
}

template class Contact<2>;
template class Contact<3>;

}  // namespace breccia
