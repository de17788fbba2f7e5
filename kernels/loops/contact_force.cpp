#include "loops/contact_force.hpp"

#include "loops/contact_point.hpp"
#include "loops/list_tools.hpp"
#include "point/contact_potential.hpp"

namespace breccia {

namespace {

template <int D>
struct ContactForceLoop {
  ContactForceIn<D> in;
  ContactForceOut<D> out;

  /// The point, its memory on entry and on exit.
  struct Point {
    Vec<D> x, v, inwards;
    Index element[kContactSlots];
    ContactState<D> old[kContactSlots];
    Index next_element[kContactSlots];
    ContactState<D> next[kContactSlots];
    int hits = 0;
    bool counts = true;  ///< in sums and signals
    Vec<D> force;
  };

  KOKKOS_FUNCTION
  void operator()(Index a, Sums<3>& all_lost) const {
    Point point;
    Sums<3> elsewhere;
    point.counts = out.history.counts(a);
    Sums<3>& lost = point.counts ? all_lost : elsewhere;
    load(a, point);
    const Index still = still_in(a, point);
    for (Index p = in.pairs.pair_begin(a); p < in.pairs.pair_begin(a + 1); ++p) {
      const Index t = in.pairs.target(p);
      bool inside = t == still;
      if (!inside && (still == kNone || !joined(t, still))) inside = claimed(t, point.x);
      in.pairs.hit(p) = inside ? 1 : 0;
      if (inside) touch(a, p, t, point, lost);
    }
    for (int s = 0; s < kContactSlots; ++s)
      if (point.element[s] != kNone) leave(point, s, lost);
    commit(a, point);
  }

 private:
  KOKKOS_FUNCTION
  bool claimed(Index t, const Vec<D>& q) const {
    Index node[D + 1];
    Vec<D> x[D + 1];
    for (int k = 0; k <= D; ++k) {
      node[k] = in.surface.nodes(t, k);
      x[k] = row<D>(in.x, node[k]);
    }
    const int clear = clear_side<D>(x, q);
    if (clear != 0) return clear > 0;
    // Families are in the same order on all ranks, copies of nodes are not.
    for (int k = 0; k <= D && in.family.extent(0) > 0; ++k) node[k] = in.family(node[k]);
    return claims<D>(x, node, q);
  }

  KOKKOS_FUNCTION
  bool joined(Index t, Index other) const {
    bool is = false;
    for (int a = 0; a <= D; ++a)
      for (int b = 0; b <= D; ++b) is |= in.surface.nodes(t, a) == in.surface.nodes(other, b);
    return is;
  }

  /// The target that the point was in and still is: then it is in none of those that hang together
  /// with it.
  KOKKOS_FUNCTION
  Index still_in(Index a, const Point& point) const {
    if (point.element[0] == kNone) return kNone;
    for (Index p = in.pairs.pair_begin(a); p < in.pairs.pair_begin(a + 1); ++p) {
      const Index t = in.pairs.target(p);
      if (in.surface.target(t) == point.element[0]) return claimed(t, point.x) ? t : kNone;
    }
    return kNone;
  }

  KOKKOS_FUNCTION
  void load(Index a, Point& point) const {
    const int q = in.pairs.point(a) % kFacePoints<D>;
    Vec<D> x[D], v[D];
    double w[D];
    for (int k = 0; k < D; ++k) {
      const Index n = in.pairs.nodes(a, k);
      x[k] = row<D>(in.x, n);
      v[k] = row<D>(in.v, n);
      w[k] = face_weight<D>(q, k, in.surface.own_weight);
    }
    Vec<D> at = x[0] * w[0], way = v[0] * w[0];
    for (int k = 1; k < D; ++k) {
      at += x[k] * w[k];
      way += v[k] * w[k];
    }
    point.x = at;
    point.v = way;
    point.inwards = -1 * face_normal(x);
    point.force = Vec<D>::zero();
    for (int s = 0; s < kContactSlots; ++s) {
      point.element[s] = out.history.element(a, s);
      if (point.element[s] != kNone) point.old[s] = load_state(out.history, a, s);
      point.next_element[s] = kNone;
    }
  }

  KOKKOS_FUNCTION
  void commit(Index a, const Point& point) const {
    for (int s = 0; s < kContactSlots; ++s) {
      out.history.element(a, s) = point.next_element[s];
      if (point.next_element[s] != kNone) store_state(out.history, a, s, point.next[s]);
    }
    set_row<D>(in.pairs.point_force, a, point.force);
  }

  /// The memory of the piece that the point is in: of the same element, or of one that shares a
  /// node with it.
  KOKKOS_FUNCTION
  int remembered(const Point& point, Index element, const Index (&node)[D + 1]) const {
    for (int s = 0; s < kContactSlots; ++s)
      if (point.element[s] == element) return s;
    for (int s = 0; s < kContactSlots; ++s) {
      if (point.element[s] == kNone) continue;
      for (int a = 0; a <= D; ++a)
        for (int b = 0; b <= D; ++b)
          if (in.element_nodes(point.element[s], a) == node[b]) return s;
    }
    if (in.family.extent(0) > 0) return related(point, node);
    return kNone;
  }

  /// Across a crack: an element that shared a node once.
  KOKKOS_FUNCTION
  int related(const Point& point, const Index (&node)[D + 1]) const {
    for (int s = 0; s < kContactSlots; ++s) {
      if (point.element[s] == kNone) continue;
      for (int a = 0; a <= D; ++a)
        for (int b = 0; b <= D; ++b)
          if (in.family(in.element_nodes(point.element[s], a)) == in.family(node[b])) return s;
    }
    return kNone;
  }

  KOKKOS_FUNCTION
  void touch(Index a, Index p, Index t, Point& point, Sums<3>& lost) const {
    Index node[D + 1];
    Vec<D> x[D + 1];
    for (int k = 0; k <= D; ++k) {
      node[k] = in.surface.nodes(t, k);
      x[k] = row<D>(in.x, node[k]);
    }
    const Mat<D> inverted = inverse(edge_matrix<D>(x));
    double l[D + 1];
    barycentric(inverted, x[0], point.x, l);
    ContactPotential<D> potential;
    for (int k = 0; k <= D; ++k) {
      potential.depth[k] = in.surface.depth(t, k);
      for (int j = 0; j < D; ++j) potential.slope[k][j] = in.surface.slope(t, k, j);
    }
    for (int c = 0; c < kChords<D>; ++c) potential.bubble[c] = in.surface.bubble(t, c);
    const auto depth = potential.value(l);
    const Index element = in.surface.target(t);
    const int slot = remembered(point, element, node);
    ContactMotion<D> motion;
    motion.phi = depth.phi;
    const ContactDirection<D> direction =
        contact_direction(potential, l, depth.edge, inverted, in.smooth, point.inwards);
    motion.normal = direction.normal;
    motion.slope = direction.slope;
    motion.velocity = point.v;
    for (int k = 0; k <= D; ++k) motion.velocity -= row<D>(in.v, node[k]) * l[k];
    motion.dt = in.dt_before;
    motion.keep = in.keep;
    // A new contact deeper than the last step can have brought it was there before it was seen.
    const bool fresh = slot == kNone || point.old[slot].phi == ContactHistory<D>::left;
    const bool unseen = fresh && motion.phi > 2 * norm(motion.velocity) * motion.dt;
    motion.jumped =
        (in.jumped && slot != kNone && !(point.old[slot].phi < 0)) || (unseen && motion.dt > 0);
    const ContactParameters law = contact_parameters(in, a, element);
    const ContactState<D> old =
        slot == kNone ? ContactState<D>() : before(law, point.old[slot], motion);
    const ContactResponse<D> r = contact_response(law, old, motion);
    if (slot != kNone) point.element[slot] = kNone;
    remember(point, element, r.next);
    point.force += r.next.force;
    set_row<D>(in.pairs.pair_force, p, r.next.force);
    for (int k = 0; k <= D; ++k) in.pairs.pair_weight(p, k) = l[k];
    book_contact(r, lost);
    if (in.surface.rim(t) != 0 && point.counts)
      Kokkos::atomic_store(&out.signals.value(ContactSignals::rim), Index(1));
  }

  /// State at the last step. A point that an interface has just handed over was pressed by the
  /// same springs there: it is put where it came from.
  KOKKOS_FUNCTION
  static ContactState<D> before(const ContactParameters& law, const ContactState<D>& old,
                                const ContactMotion<D>& motion) {
    if (!(old.phi < 0)) return old;
    ContactState<D> handed;
    handed.rubbed = old.rubbed;
    if (old.phi == ContactHistory<D>::left) return handed;
    handed.slip = old.slip;
    ContactMotion<D> then = motion;
    then.phi += motion.slope * dot(motion.velocity, motion.normal) * motion.dt;
    then.dt = 0;
    then.jumped = false;
    ContactState<D> state = contact_response(law, handed, then).next;
    state.rubbed = old.rubbed;
    return state;
  }

  KOKKOS_FUNCTION
  void remember(Point& point, Index element, const ContactState<D>& state) const {
    if (point.hits == kContactSlots) {
      if (point.counts) Kokkos::atomic_inc(&out.signals.value(ContactSignals::crowded));
      return;
    }
    point.next_element[point.hits] = element;
    point.next[point.hits] = state;
    ++point.hits;
  }

  /// The point is out of a piece that it was in. Having been deeper than it can have moved is a
  /// loss.
  KOKKOS_FUNCTION
  void leave(Point& point, int slot, Sums<3>& lost) const {
    const ContactState<D>& old = point.old[slot];
    if (out.history.rubbed.extent(0) > 0 && point.hits < kContactSlots)
      remember(point, point.element[slot], state_apart(old));
    if (old.phi < 0) return;  // it was apart
    const Vec<D> way = way_past(in, point.element[slot], point.x, point.v);
    book_contact(contact_ended(old, way), lost);
    if (old.phi - old.offset > 3 * norm(way) && point.counts)
      Kokkos::atomic_inc(&out.signals.value(ContactSignals::lost));
  }
};

}  // namespace

template <int D>
void contact_force(const ContactForceIn<D>& in, const ContactForceOut<D>& out) {
  for_each_summed<3>("breccia::contact::force", in.pairs.points, out.lost,
                     ContactForceLoop<D>{in, out});
}

template <int D>
void set_contact_points(const ContactSurface<D>& surface, const ContactPairs<D>& pairs,
                        const Kokkos::View<const Index*, Memory>& element_material,
                        const ContactStiffness<D>& rule, ContactPointData<D>& point) {
  make_room(point.constants, pairs.points);
  make_room(point.material, pairs.points);
  const ContactPointData<D> to = point;
  for_each(
      "breccia::contact::set_points", pairs.points, KOKKOS_LAMBDA(Index a) {
        const Index i = pairs.facet(a), m = element_material(surface.facet(i) / (D + 1));
        const double modulus = rule.material(m, 0), h = surface.height(i);
        const double per_area = rule.fixed > 0 ? rule.fixed : rule.factor * modulus / h;
        const double mass = 0.5 * rule.material(m, 1) * h;  // per area
        const double dashpot = 2 * rule.damping * Kokkos::sqrt(per_area * mass);
        const double share = 0.5 * surface.area(i) / kFacePoints<D>;
        to.constants(a, 0) = share * per_area;
        to.constants(a, 1) = share * dashpot;
        to.material(a) = m;
      });
}

template <int D>
void refresh_point_nodes(const ContactSurface<D>& surface, const ContactPairs<D>& pairs) {
  for_each(
      "breccia::contact::point_nodes", pairs.points, KOKKOS_LAMBDA(Index a) {
        const Index i = pairs.facet(a), t = surface.facet_target(i);
        const int f = surface.facet(i) % (D + 1);
        for (int k = 0; k < D; ++k) pairs.nodes(a, k) = surface.nodes(t, face_node<D>(f, k));
      });
}

template void contact_force<2>(const ContactForceIn<2>&, const ContactForceOut<2>&);
template void contact_force<3>(const ContactForceIn<3>&, const ContactForceOut<3>&);
template void set_contact_points<2>(const ContactSurface<2>&, const ContactPairs<2>&,
                                    const Kokkos::View<const Index*, Memory>&,
                                    const ContactStiffness<2>&, ContactPointData<2>&);
template void set_contact_points<3>(const ContactSurface<3>&, const ContactPairs<3>&,
                                    const Kokkos::View<const Index*, Memory>&,
                                    const ContactStiffness<3>&, ContactPointData<3>&);
template void refresh_point_nodes<2>(const ContactSurface<2>&, const ContactPairs<2>&);
template void refresh_point_nodes<3>(const ContactSurface<3>&, const ContactPairs<3>&);

}  // namespace breccia
