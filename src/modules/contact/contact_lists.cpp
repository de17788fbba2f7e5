#include "modules/contact/contact_lists.hpp"

#include "fields/interface_fields.hpp"
#include "loops/contact_distributed.hpp"
#include "loops/contact_gather.hpp"
#include "loops/list_tools.hpp"
#include "mesh/whole_pieces.hpp"
#include "modules/contact/contact_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace breccia {

namespace {

/// Nodes are looked at after this many steps at the latest. At 0.5 h per step of the fastest wave
/// and strains below 2 % they move less than a tenth of h meanwhile, the default half skin.
constexpr double kLongestBlink = 8;
/// Share of the room left in the skin that the speeds of now may use up before the next look;
/// half, so that speeds may double meanwhile.
constexpr double kRoom = 0.5;
/// Steps that one search should last for, and the widest skin for its sake, over the mean size.
constexpr double kSearchSteps = 16, kWidestSkin = 0.4;
/// Steps that a released face may stay without contact while its sides are apart. They are looked
/// at in each step; others that come near, at strains below 2 % (see above), move by a sixth of h
/// at most.
constexpr std::int64_t kPatience = 16;

}  // namespace

template <int D>
ContactHistory<D> ContactLists<D>::history(const Model<D>& model) {
  const Store& s = model.store;
  return {s.get<ContactElement>(), s.get<ContactMemory<D>>(), s.get_or_empty<ContactRubbed>(),
          s.get<ContactPoint>(), model.part.own};
}

template <int D>
void ContactLists<D>::prepare(const Model<D>& model, const ContactListKeys& keys) {
  list_free_facets(model);
  make_signals();
  skin_share_ = keys.skin;
  by_parts_ = keys.by_parts;
  surface_.own_weight = keys.at_corners ? PointWeight<D>::corners : PointWeight<D>::gauss;
}

template <int D>
void ContactLists<D>::make_signals() {
  if (signals_.value.extent(0) == 0)
    signals_.value = Array<Index>("breccia::contact::signals", ContactSignals::count);
}

/// Free faces of the elements that stay, and their faces towards what is gone. What is being
/// excavated touches nobody from its first moment on.
template <int D>
void ContactLists<D>::list_free_facets(const Model<D>& model) {
  std::vector<double> share(model.mesh.element.size(), 1.0);
  std::vector<std::uint8_t> rigid(share.size(), 0);
  for (const Block& block : model.blocks) {
    if (model.materials[static_cast<std::size_t>(block.material)].rigid)
      std::fill(rigid.begin() + block.begin, rigid.begin() + block.end, std::uint8_t{1});
    if (block.excavation != kNone)
      std::fill(share.begin() + block.begin, share.begin() + block.end,
                model.excavations[static_cast<std::size_t>(block.excavation)].share);
  }
  std::vector<Index> free;
  for (const ElementFace& f : model.topology.free)
    if (share[static_cast<std::size_t>(f.element)] == 1)
      free.push_back(f.element * (D + 1) + f.face);
  for (const SharedFace& f : model.topology.shared) {
    const double left = share[static_cast<std::size_t>(f.left)];
    const double right = share[static_cast<std::size_t>(f.right)];
    if (left == 1 && right == 0) free.push_back(f.left * (D + 1) + f.left_face);
    if (right == 1 && left == 0) free.push_back(f.right * (D + 1) + f.right_face);
  }
  free_facet_ = to_device("breccia::contact::free_facets", free);
  changes_ = model.surface_changes;
  if (!part_->whole()) {
    piece_ = to_device("breccia::contact::piece", part_->piece);
    cut_ = Array<std::uint8_t>("breccia::contact::cut", static_cast<std::size_t>(part_->pieces));
    return;
  }
  // A piece that something is taken from is no longer what it was.
  std::vector<Index> piece = whole_pieces(model.mesh, model.topology, rigid);
  std::vector<std::uint8_t> cut(piece.size(), 0);
  for (std::size_t e = 0; e < piece.size(); ++e)
    if (share[e] != 1 && piece[e] != kNone) cut[static_cast<std::size_t>(piece[e])] = 1;
  for (Index& p : piece)
    if (p != kNone && cut[static_cast<std::size_t>(p)] != 0) p = kNone;
  piece_ = to_device("breccia::contact::piece", piece);
  cut_ = Array<std::uint8_t>("breccia::contact::cut", piece.size());
}

/// Harmonic mean of the sizes behind the surface of the whole scene, m: the sum is one of whole
/// numbers, and the same for any number of ranks.
template <int D>
double ContactLists<D>::mean_size() const {
  ContactSizes sizes = contact_sizes(surface_, part_->own);
  if (!part_->whole()) {
    sizes.finest = part_->world->largest(sizes.finest);
    sizes.facets = part_->world->sum(sizes.facets);
  }
  if (sizes.facets == 0) return 0;
  const int room = 60 - std::ilogb(static_cast<double>(sizes.facets));
  const double grain = std::exp2(std::ilogb(sizes.finest) + 1 - std::min(room, 52));
  std::int64_t sum = sum_of_inverse_sizes(surface_, part_->own, grain);
  if (!part_->whole()) sum = part_->world->sum(sum);
  return D * static_cast<double>(sizes.facets) / (static_cast<double>(sum) * grain);
}

/// A face of a piece may have been inserted where another rank knows it.
template <int D>
void ContactLists<D>::find_pieces(const Model<D>& model) {
  find_whole_pieces(faces(model), piece_, cut_, surface_);
  if (part_->whole() || part_->pieces == 0) return;
  std::vector<std::uint8_t> cut = to_host(cut_, cut_.extent(0));
  part_->world->any(cut);
  cut_ = to_device("breccia::contact::cut", cut);
  find_whole_pieces(faces(model), piece_, cut_, surface_);
}

template <int D>
void ContactLists<D>::start(Model<D>& model, const ContactStiffness<D>& rule) {
  model.store.set_count(Entity::contact_point, 0);
  make_surface(model);
  make_pairs(model, rule);
  carry(model, false);
  jumped_ = false;
}

template <int D>
void ContactLists<D>::resume(Model<D>& model, const ContactStiffness<D>& rule) {
  const ContactSurface<D> surface = surface_;
  const Array<Index> piece = piece_;
  for_each(
      "breccia::contact::pieces", surface_.targets, KOKKOS_LAMBDA(Index t) {
        if (surface.piece(t) != kNone) surface.piece(t) = piece(surface.target(t));
      });
  make_room(surface_.nodes, surface_.targets);
  refresh_contact_nodes<D>(model.store.template get<ElementNodes<D>>(), surface_);
  size_ = mean_size();
  model.part.skin = std::max(skin_share_, kWidestSkin) * size_;
  finish_contact_pairs(surface_, search_scratch_, pairs_);
  attach(model, rule);
  // Points whose candidates only others know have memories here, but are not in the lists.
  if (!part_->whole()) carry(model, false);
  const ReleasedFaces<D> in = faces(model);
  mark_known_releases(in, surface_, known_);
  if (model.releases != releases_) fresh_count_ = list_new_releases(in, known_, fresh_);
}

template <int D>
void ContactLists<D>::look(Model<D>& model, const Clock& clock, const ContactStiffness<D>& rule) {
  const bool released = model.releases != releases_;
  const bool excavated = model.surface_changes != changes_;
  if (excavated) list_free_facets(model);
  bool due = excavated || (released && pressed(model, clock)), deeper = false;
  if (!due && model.splits != splits_) {
    refresh_contact_nodes<D>(model.store.template get<ElementNodes<D>>(), surface_);
    refresh_point_nodes(surface_, pairs_);
    splits_ = model.splits;
    ++version_;
  }
  if (!due && clock.step >= next_look_) {
    const ContactWay now = way(model);
    chase_ = kSearchSteps * now.speed * clock.dt;
    due = far(model, clock, now);
    deeper = now.rim != 0 && deepen(model, clock);
  }
  if (!due && !deeper) return;
  clear(model);
  // Faces that were inserted meanwhile can wait until now: they open slowly.
  if (excavated || released || deeper || model.splits != surface_splits_) make_surface(model);
  make_pairs(model, rule);
  carry(model, released);
  last_look_ = clock.step;
  next_look_ = clock.step + 1;
  model.step_is_stale = model.step_is_stale || has_own_pairs();
}

/// Points whose element is another rank's are that one's to tell of.
template <int D>
bool ContactLists<D>::has_own_pairs() const {
  if (part_->whole()) return pairs_.pairs > 0;
  const Array<Index> point = pairs_.point;
  const Array<std::uint8_t> own = part_->own;
  return count_where(
             "breccia::contact::own_points", pairs_.points,
             KOKKOS_LAMBDA(Index a) { return own(point(a) / kFacePoints<D> / (D + 1)) != 0; }) > 0;
}

template <int D>
ReleasedFaces<D> ContactLists<D>::faces(const Model<D>& model) const {
  const Store& s = model.store;
  ReleasedFaces<D> in;
  if (!s.has<FaceStatus>()) return in;
  in.faces = s.count(Entity::face);
  in.status = s.get<FaceStatus>();
  in.code = s.get<FaceCode>();
  in.elements = s.get<FaceElements>();
  in.element_nodes = s.get<ElementNodes<D>>();
  in.released = face_status::released;
  in.own_weight = surface_.own_weight;
  return in;
}

/// True when released faces can wait no longer: one of them is closed, or they have waited enough.
template <int D>
bool ContactLists<D>::pressed(Model<D>& model, const Clock& clock) {
  const ReleasedFaces<D> in = faces(model);
  if (seen_releases_ == releases_) patience_ = clock.step + kPatience;
  if (seen_releases_ != model.releases) fresh_count_ = list_new_releases(in, known_, fresh_);
  seen_releases_ = model.releases;
  return clock.step >= patience_ ||
         part_->any(sides_meet<D>(in, fresh_, fresh_count_,
                                  model.store.template get<NodePosition<D>>(),
                                  model.store.template get<NodeVelocity<D>>(), clock.dt));
}

template <int D>
ContactWay ContactLists<D>::way(const Model<D>& model) {
  if (model.splits != listed_splits_) list_contact_nodes(surface_, model.nodes(), nodes_);
  listed_splits_ = model.splits;
  ContactWay way = contact_way<D>(model.store.template get<NodePosition<D>>(),
                                  model.store.template get<NodeVelocity<D>>(), nodes_,
                                  Kokkos::subview(signals_.value, ContactSignals::rim));
  if (part_->whole()) return way;
  std::vector<double> all{way.way, way.speed, static_cast<double>(way.rim)};
  part_->world->largest(all);
  return {all[0], all[1], static_cast<Index>(all[2])};
}

/// True when a node may have left its half of the skin.
template <int D>
bool ContactLists<D>::far(Model<D>& model, const Clock& clock, const ContactWay& now) {
  const double room = 0.5 * skin_ - now.way;
  if (room < 0) {
    bool late = -room > now.speed * clock.dt_before;
    if (part_->whole() && flyers_.worth_a_look()) {
      const FlyingLook look =
          flyers_.look(model, clock, surface_, skin_, clock.step - last_look_, kLongestBlink);
      late = look.late;
      if (look.steps > 0) {
        chase_ = kSearchSteps * look.speed * clock.dt;
        last_look_ = clock.step;
        next_look_ = clock.step + look.steps;
        return false;
      }
    }
    // At the step before, with which the list was still used, the node was this much nearer.
    if (clock.step > last_look_ + 1 && late && !model.stop.raised) {
      model.stop.raised = true;
      model.stop.cause = fmt::format(
          "the contact search came too late at time {:.6g} s (step {}): a surface node moved by "
          "{:.4g} m since the last one, and only {:.4g} m are covered; speeds grew more than "
          "twofold within {} steps. Likely causes are a load or impact much faster than the waves "
          "can carry, or a contact.skin that is too small",
          clock.time, clock.step, now.way, 0.5 * skin_, clock.step - last_look_);
    }
    return true;
  }
  const double way = now.speed * clock.dt;
  const double steps = way > 0 ? kRoom * room / way : kLongestBlink;
  last_look_ = clock.step;
  next_look_ = clock.step + static_cast<std::int64_t>(std::clamp(steps, 1.0, kLongestBlink));
  return false;
}

/// More layers of targets, for a point has reached the deepest.
template <int D>
bool ContactLists<D>::deepen(Model<D>& model, const Clock& clock) {
  Kokkos::deep_copy(Exec(), Kokkos::subview(signals_.value, ContactSignals::rim), Index(0));
  if (!deeper_exist_) return false;
  if (!part_->whole()) {
    model.stop.raised = true;
    model.stop.cause = fmt::format(
        "at time {:.6g} s (step {}) bodies overlap by {} layers of elements, more than ranks know "
        "of "
        "one another; make contact stiffer, or go on with one rank from the checkpoint (--restart)",
        clock.time, clock.step, layers_);
    return false;
  }
  layers_ += 2;
  return true;
}

template <int D>
void ContactLists<D>::clear(Model<D>& model) const {
  clear_contact<D>(surface_, pairs_, model.nodes(), model.store.template get<NodeFlags>(),
                   node_flag::contact, model.store.template get<ContactForce<D>>());
}

template <int D>
void ContactLists<D>::make_surface(Model<D>& model) {
  const Store& s = model.store;
  std::swap(old_facet_, surface_.facet);
  old_facets_ = surface_.facets;
  ContactSurfaceIn<D> in;
  in.nodes = model.nodes();
  in.elements = model.elements();
  in.element_nodes = s.get<ElementNodes<D>>();
  in.reference = s.get<NodeReference<D>>();
  in.corners = s.get<NodeCorners>();
  in.corner_list = s.get<CornerList>();
  in.free_facet = free_facet_;
  if (s.has<FaceStatus>()) {
    in.faces = s.count(Entity::face);
    in.face_status = s.get<FaceStatus>();
    in.face_code = s.get<FaceCode>();
    in.face_elements = s.get<FaceElements>();
    in.released = face_status::released;
    in.inserted = face_status::inserted;
  }
  in.share = s.get_or_empty<ElementShare>();
  if (!part_->whole()) in.mass = s.get<NodeMass>();
  in.thickness = model.thickness;
  in.layers = static_cast<Index>(layers_);
  deeper_exist_ = update_contact_surface(in, scratch_, surface_);
  deeper_exist_ = part_->any(deeper_exist_);
  size_ = mean_size();
  find_pieces(model);
  mark_known_releases(faces(model), surface_, known_);
  releases_ = seen_releases_ = model.releases;
  splits_ = surface_splits_ = model.splits;
  jumped_ = true;
}

/// Each of two nodes may go half of the skin.
template <int D>
double ContactLists<D>::skin() const {
  const double widest = std::max(skin_share_, kWidestSkin) * size_;
  return std::clamp(2 * chase_, skin_share_ * size_, widest);
}

template <int D>
void ContactLists<D>::make_pairs(Model<D>& model, const ContactStiffness<D>& rule) {
  skin_ = skin();
  model.part.skin = std::max(skin_share_, kWidestSkin) * size_;
  take_contact_places<D>(model.store.template get<NodePosition<D>>(), surface_);
  const double reach = by_parts_ ? contact_part_reach(surface_) : 0;
  search_contacts(surface_, skin_ + reach, search_scratch_, pairs_);
  flyers_.start();
  listed_splits_ = -1;
  attach(model, rule);
}

template <int D>
void ContactLists<D>::attach(Model<D>& model, const ContactStiffness<D>& rule) {
  const Store& s = model.store;
  ++version_;
  if (by_parts_) make_room(pairs_.pair_own, pairs_.pairs);
  refresh_point_nodes(surface_, pairs_);
  flag_contact<D>(surface_, pairs_, s.get<ElementNodes<D>>(), s.get<NodeFlags>(),
                  node_flag::contact);
  set_contact_points<D>(surface_, pairs_, s.get<ElementMaterial>(), rule, point_);
}

/// Memories follow their points into the new list; released faces bring those of their interfaces.
template <int D>
void ContactLists<D>::carry(Model<D>& model, bool released) {
  Store& s = model.store;
  const Index points = pairs_.points;
  make_room(spare_.element, points);
  make_room(spare_.state, points);
  if (s.has<ContactRubbed>()) make_room(spare_.rubbed, points);
  carry_history<D>(s.get<ContactPoint>(), s.count(Entity::contact_point), history(model),
                   pairs_.point, points, spare_);
  if (released && s.has<InterfaceSlip<D>>()) {
    ContactHandover<D> in;
    in.old_facet = old_facet_;
    in.old_facets = old_facets_;
    in.own_weight = surface_.own_weight;
    in.element_faces = s.get<ElementFaces<D>>();
    in.face_elements = s.get<FaceElements>();
    in.face_code = s.get<FaceCode>();
    in.face_interface = s.get<FaceInterface>();
    in.slip = s.get<InterfaceSlip<D>>();
    in.rubbed = s.get_or_empty<InterfaceRubbed<D>>();
    take_over<D>(in, pairs_, spare_);
  }
  if (points > s.capacity(Entity::contact_point))
    s.set_size(Entity::contact_point, 0, points + points / 4 + 16);
  s.set_count(Entity::contact_point, points);
  copy_history<D>(pairs_.point, spare_, points, s.get<ContactPoint>(), history(model));
}

template class ContactLists<2>;
template class ContactLists<3>;

}  // namespace breccia
