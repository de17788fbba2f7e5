#include "loops/contact_distributed.hpp"

#include "loops/contact_point.hpp"
#include "loops/list_tools.hpp"
#include "point/distributed_potential.hpp"

namespace breccia {

namespace {

template <int D>
struct DistributedForceLoop {
  ContactForceIn<D> in;
  ContactForceOut<D> out;

  KOKKOS_FUNCTION
  void operator()(Index a, Sums<3>& all_lost) const {
    Sums<3> elsewhere;
    const bool counts = out.history.counts(a);
    Sums<3>& lost = counts ? all_lost : elsewhere;
    const int q = in.pairs.point(a) % kFacePoints<D>;
    Vec<D> x[D], v[D];
    for (int k = 0; k < D; ++k) {
      const Index n = in.pairs.nodes(a, k);
      x[k] = row<D>(in.x, n);
      v[k] = row<D>(in.v, n);
    }
    ContactMotion<D> motion{};
    Index most = kNone;
    double largest = 0, share = 0;
    motion.velocity = Vec<D>::zero();
    for (Index p = in.pairs.pair_begin(a); p < in.pairs.pair_begin(a + 1); ++p) {
      const double depth = overlap(p, q, x, v, counts, share, motion.velocity);
      motion.phi += depth;
      if (depth <= largest) continue;
      largest = depth;
      most = p;
    }
    const bool known = out.history.element(a, 0) != kNone;
    ContactState<D> old;
    if (known) old = load_state(out.history, a, 0);
    const bool fresh = !known || old.phi == ContactHistory<D>::left;
    if (old.phi < 0) old = from_apart(old);
    if (most == kNone) {
      if (known) end(a, q, x, v, old, lost);
      set_row<D>(in.pairs.point_force, a, Vec<D>::zero());
      return;
    }
    motion.velocity *= 1 / motion.phi;
    motion.normal = face_normal(x);
    motion.normal *= -1 / norm(motion.normal);
    motion.slope = 1;
    motion.dt = in.dt_before;
    motion.keep = in.keep;
    const bool unseen = fresh && motion.phi > 2 * norm(motion.velocity) * motion.dt;
    motion.jumped = unseen && motion.dt > 0;
    const Index element = in.surface.target(in.pairs.target(most));
    ContactParameters law = contact_parameters(in, a, element);
    law.damping *= share;  // of the area that touches
    law.tangential_damping *= share;
    const ContactResponse<D> r = contact_response(law, old, motion);
    book_contact(r, lost);
    out.history.element(a, 0) = element;
    out.history.element(a, 1) = kNone;
    store_state(out.history, a, 0, r.next);
    share_out(a, r.next.force, motion.phi);
  }

 private:
  /// Depth of a pair; adds the share of the part that it covers, and the relative velocity at its
  /// centre times the depth. The pair's force holds the depth until all pairs of the point are
  /// known.
  KOKKOS_FUNCTION
  double overlap(Index p, int q, const Vec<D> (&x)[D], const Vec<D> (&v)[D], bool counts,
                 double& share, Vec<D>& velocity) const {
    const Index t = in.pairs.target(p);
    Index node[D + 1];
    Vec<D> corner[D + 1];
    for (int k = 0; k <= D; ++k) {
      node[k] = in.surface.nodes(t, k);
      corner[k] = row<D>(in.x, node[k]);
    }
    const DistributedOverlap<D> r = distributed_overlap(x, q, corner);
    in.pairs.hit(p) = r.depth > 0 ? 1 : 0;
    if (!(r.depth > 0)) return 0;
    share += r.share;
    for (int k = 0; k < D; ++k) {
      in.pairs.pair_own(p, k) = r.own[k];
      velocity += v[k] * (r.depth * r.own[k]);
    }
    for (int k = 0; k <= D; ++k) {
      in.pairs.pair_weight(p, k) = r.l[k];
      velocity -= row<D>(in.v, node[k]) * (r.depth * r.l[k]);
    }
    in.pairs.pair_force(p, 0) = r.depth;
    if (in.surface.rim(t) != 0 && counts)
      Kokkos::atomic_store(&out.signals.value(ContactSignals::rim), Index(1));
    return r.depth;
  }

  KOKKOS_FUNCTION
  void share_out(Index a, const Vec<D>& force, double depth) const {
    for (Index p = in.pairs.pair_begin(a); p < in.pairs.pair_begin(a + 1); ++p)
      if (in.pairs.hit(p) != 0)
        set_row<D>(in.pairs.pair_force, p, force * (in.pairs.pair_force(p, 0) / depth));
    set_row<D>(in.pairs.point_force, a, force);
  }

  /// The part is out of everything that it was in.
  KOKKOS_FUNCTION
  void end(Index a, int q, const Vec<D> (&x)[D], const Vec<D> (&v)[D], const ContactState<D>& old,
           Sums<3>& lost) const {
    Vec<D> at = Vec<D>::zero(), speed = Vec<D>::zero();
    for (int k = 0; k < D; ++k) {
      at += x[k] * face_weight<D>(q, k, in.surface.own_weight);
      speed += v[k] * face_weight<D>(q, k, in.surface.own_weight);
    }
    const Vec<D> way = way_past(in, out.history.element(a, 0), at, speed);
    book_contact(contact_ended(old, way), lost);
    if (out.history.rubbed.extent(0) > 0)
      store_state(out.history, a, 0, state_apart(old));
    else
      out.history.element(a, 0) = out.history.element(a, 1) = kNone;
  }

  /// An interface has handed the part over, or it has left before: only its slip is known.
  KOKKOS_FUNCTION
  static ContactState<D> from_apart(const ContactState<D>& old) {
    ContactState<D> state;
    state.slip = old.slip;
    state.rubbed = old.rubbed;
    return state;
  }
};

}  // namespace

template <int D>
void contact_force_distributed(const ContactForceIn<D>& in, const ContactForceOut<D>& out) {
  for_each_summed<3>("breccia::contact::distributed", in.pairs.points, out.lost,
                     DistributedForceLoop<D>{in, out});
}

template <int D>
double contact_part_reach(const ContactSurface<D>& surface) {
  double longest = 0;
  count_launch();
  Kokkos::parallel_reduce(
      "breccia::contact::part_reach",
      Kokkos::RangePolicy<Exec, Kokkos::IndexType<Index>>(0, surface.facets),
      KOKKOS_LAMBDA(Index i, double& most) {
        const Index t = surface.facet_target(i);
        const int f = surface.facet(i) % (D + 1);
        for (int k = 0; k < D; ++k) {
          double square = 0;
          for (int d = 0; d < D; ++d) {
            const double along = surface.place(t, face_node<D>(f, k), d) -
                                 surface.place(t, face_node<D>(f, (k + 1) % D), d);
            square += along * along;
          }
          most = square > most ? square : most;
        }
      },
      Kokkos::Max<double>(longest));
  // The corners of a part are no farther than a third of the longest edge.
  return Kokkos::sqrt(longest) / 3;
}

template void contact_force_distributed<2>(const ContactForceIn<2>&, const ContactForceOut<2>&);
template void contact_force_distributed<3>(const ContactForceIn<3>&, const ContactForceOut<3>&);
template double contact_part_reach<2>(const ContactSurface<2>&);
template double contact_part_reach<3>(const ContactSurface<3>&);

}  // namespace breccia
