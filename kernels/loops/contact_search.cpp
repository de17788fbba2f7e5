#include "loops/contact_search.hpp"

#include "base/sums.hpp"
#include "loops/contact_bins.hpp"
#include "point/simplex_geometry.hpp"

namespace breccia {

namespace {

/// Candidates of the contact points.
template <int D>
struct Candidates {
  ContactSurface<D> surface;
  ContactBins<D> bins;
  double skin;

  KOKKOS_FUNCTION
  Vec<D> place(Index point) const {
    const Index i = point / kFacePoints<D>, t = surface.facet_target(i);
    const int f = surface.facet(i) % (D + 1), q = point % kFacePoints<D>;
    Vec<D> x = Vec<D>::zero();
    for (int k = 0; k < D; ++k)
      for (int d = 0; d < D; ++d)
        x[d] += face_weight<D>(q, k, surface.own_weight) * surface.place(t, face_node<D>(f, k), d);
    return x;
  }

  /// ALGORITHMS: not the own element, not one that hangs together with the face.
  KOKKOS_FUNCTION
  bool apart(Index i, Index t) const {
    const Index own = surface.facet_target(i);
    const int f = surface.facet(i) % (D + 1);
    for (int k = 0; k < D; ++k)
      for (int a = 0; a <= D; ++a)
        if (surface.nodes(own, face_node<D>(f, k)) == surface.nodes(t, a)) return false;
    return true;
  }

  /// The distance to the plane of a face, -L_f / |grad L_f|, tells most of those that are not near.
  KOKKOS_FUNCTION
  bool near(const Vec<D>& q, Index t) const {
    Vec<D> x[D + 1];
    for (int a = 0; a <= D; ++a)
      for (int d = 0; d < D; ++d) x[a][d] = surface.place(t, a, d);
    const Mat<D> inverted = inverse(edge_matrix<D>(x));
    double l[D + 1];
    barycentric(inverted, x[0], q, l);
    Vec<D> first = Vec<D>::zero();
    bool within = true;
    for (int f = D; f >= 0; --f) {
      Vec<D> gradient = first;
      for (int d = 0; f > 0 && d < D; ++d) gradient[d] = inverted(f - 1, d);
      if (f > 0) first -= gradient;
      if (l[f] < 0 && l[f] * l[f] > skin * skin * norm2(gradient)) return false;
      within = within && l[f] >= 0;
    }
    return within || square_distance_from_outside<D>(x, q, l) <= skin * skin;
  }

  KOKKOS_FUNCTION
  bool in_box(const Vec<D>& q, Index t) const {
    bool in = true;
    for (int d = 0; d < D; ++d) in = in && q[d] >= bins.box(t, d) && q[d] <= bins.box(t, D + d);
    return in;
  }

  /// Calls f(t) for each target whose box holds a point at q, that hangs apart from it and is not
  /// of its own piece, if that cannot touch itself.
  template <class F>
  KOKKOS_FUNCTION
  void each(Index point, const Vec<D>& q, const F& f) const {
    const ContactGrid<D> grid{bins.cell, bins.buckets};
    const Index facet = point / kFacePoints<D>, piece = surface.piece(surface.facet_target(facet));
    const Index own = piece == kNone ? kNone - 1 : piece;
    for (int level = 0; level < GridShape<D>::levels; ++level) {
      if ((bins.levels & (1u << level)) == 0) continue;
      const std::uint64_t tag = grid.tag_at(level, q);
      const Index bucket = grid.bucket(tag);
      for (Index k = bins.begin(bucket); k < bins.begin(bucket + 1); ++k)
        if (bins.piece(k) != own && bins.tag(k) == tag && in_box(q, bins.target(k)) &&
            apart(facet, bins.target(k)))
          f(bins.target(k));
    }
  }
};

/// Candidates of the points (face place * kFacePoints + q) that are in a box; count holds how many
/// each has. Returns the number of such points.
template <int D>
Index find_candidates(const Candidates<D>& find, Index all_points,
                      ContactSearchScratch<D>& scratch) {
  make_room(scratch.count, all_points);
  make_room(scratch.first, all_points);
  const Array<Index> count = scratch.count;
  const auto first = scratch.first;
  for_each(
      "breccia::contact::count_boxes", all_points, KOKKOS_LAMBDA(Index p) {
        Index n = 0;
        find.each(p, find.place(p), [&](Index t) {
          if (n < kFirstBoxes) first(p, n) = t;
          ++n;
        });
        count(p) = n;
      });
  const Index points = list_where(
      "breccia::contact::in_a_box", all_points, KOKKOS_LAMBDA(Index p) { return count(p) > 0; },
      scratch.active);
  const Array<Index> active = scratch.active;
  const Index room = list_begins(
      "breccia::contact::room", points, KOKKOS_LAMBDA(Index a) { return count(active(a)); },
      scratch.found_begin);
  make_room(scratch.found, room);
  const Array<Index> begin = scratch.found_begin, found = scratch.found;
  for_each(
      "breccia::contact::find_candidates", points, KOKKOS_LAMBDA(Index a) {
        const Index p = active(a);
        const Vec<D> q = find.place(p);
        Index k = begin(a);
        const auto keep = [&](Index t) {
          if (find.near(q, t)) found(k++) = t;
        };
        if (count(p) > kFirstBoxes) {
          find.each(p, q, keep);
        } else {
          for (Index n = 0; n < count(p); ++n) keep(first(p, n));
        }
        sort_list(&found(begin(a)), k - begin(a));
        count(p) = k - begin(a);
      });
  return points;
}

/// Points with candidates, and their candidates.
template <int D>
void list_pairs(const Candidates<D>& find, Index all_points, ContactSearchScratch<D>& scratch,
                ContactPairs<D>& pairs) {
  const Index points = find_candidates(find, all_points, scratch);
  const Array<Index> active = scratch.active, count = scratch.count;
  pairs.points = list_where(
      "breccia::contact::points", points, KOKKOS_LAMBDA(Index a) { return count(active(a)) > 0; },
      scratch.kept);
  const Array<Index> kept = scratch.kept;
  pairs.pairs = list_begins(
      "breccia::contact::pairs", pairs.points,
      KOKKOS_LAMBDA(Index a) { return count(active(kept(a))); }, pairs.pair_begin);
  make_room(pairs.point, pairs.points);
  make_room(pairs.facet, pairs.points);
  make_room(pairs.target, pairs.pairs);
  const ContactPairs<D> to = pairs;
  const Array<Index> begin = scratch.found_begin, found = scratch.found;
  const Array<Index> number = find.surface.facet;
  for_each(
      "breccia::contact::keep_candidates", pairs.points, KOKKOS_LAMBDA(Index a) {
        const Index p = active(kept(a)), from = begin(kept(a)), first = to.pair_begin(a);
        for (Index k = first; k < to.pair_begin(a + 1); ++k) to.target(k) = found(from + k - first);
        to.facet(a) = p / kFacePoints<D>;
        to.point(a) = number(to.facet(a)) * kFacePoints<D> + p % kFacePoints<D>;
      });
}

/// Per target: the pairs that may push it and the points on its faces.
template <int D>
void list_elements(const ContactSurface<D>& surface, Array<Index>& count, ContactPairs<D>& pairs) {
  const Index targets = surface.targets;
  make_room(count, targets);
  Kokkos::deep_copy(Exec(), count, 0);
  const Array<Index> counts = count;
  {
    const Array<Index> target = pairs.target;
    for_each(
        "breccia::contact::count_pairs", pairs.pairs,
        KOKKOS_LAMBDA(Index p) { Kokkos::atomic_inc(&counts(target(p))); });
    list_begins("breccia::contact::elements", targets, counts, pairs.come_begin);
    make_room(pairs.come, pairs.pairs);
    const Array<Index> begin = pairs.come_begin, come = pairs.come;
    for_each(
        "breccia::contact::fill_elements", pairs.pairs, KOKKOS_LAMBDA(Index p) {
          const Index t = target(p);
          come(begin(t) + Kokkos::atomic_fetch_sub(&counts(t), 1) - 1) = p;
        });
    for_each(
        "breccia::contact::sort_elements", targets,
        KOKKOS_LAMBDA(Index t) { sort_list(&come(begin(t)), begin(t + 1) - begin(t)); });
  }
  // The counts are zero again.
  const Array<Index> facet = pairs.facet, own = surface.facet_target;
  for_each(
      "breccia::contact::count_own", pairs.points,
      KOKKOS_LAMBDA(Index a) { Kokkos::atomic_inc(&counts(own(facet(a)))); });
  list_begins("breccia::contact::own", targets, counts, pairs.own_begin);
  const Array<Index> begin = pairs.come_begin, mine = pairs.own_begin;
  pairs.elements = list_where(
      "breccia::contact::involved", targets,
      KOKKOS_LAMBDA(Index t) { return begin(t + 1) > begin(t) || mine(t + 1) > mine(t); },
      pairs.element);
}

}  // namespace

template <int D>
void take_contact_places(const ConstVectors<D>& x, const ContactSurface<D>& surface) {
  for_each(
      "breccia::contact::take_places", surface.targets, KOKKOS_LAMBDA(Index t) {
        for (int a = 0; a <= D; ++a)
          for (int d = 0; d < D; ++d) surface.place(t, a, d) = x(surface.nodes(t, a), d);
      });
}

template <int D>
void list_contact_nodes(const ContactSurface<D>& surface, Index nodes, ContactNodes<D>& list) {
  make_room(list.mark, nodes);
  make_room(list.place, nodes);
  const ContactNodes<D> to = list;
  Kokkos::deep_copy(Exec(), list.mark, std::uint8_t{0});
  // Corners of one node write the same numbers.
  for_each(
      "breccia::contact::mark_nodes", surface.targets, KOKKOS_LAMBDA(Index t) {
        for (int a = 0; a <= D; ++a) {
          const Index n = surface.nodes(t, a);
          Kokkos::atomic_store(&to.mark(n), std::uint8_t{1});
          for (int d = 0; d < D; ++d) Kokkos::atomic_store(&to.place(n, d), surface.place(t, a, d));
        }
      });
  list.count = list_where(
      "breccia::contact::nodes", nodes, KOKKOS_LAMBDA(Index n) { return to.mark(n) != 0; },
      list.node);
}

template <int D>
ContactWay contact_way(const ConstVectors<D>& x, const ConstVectors<D>& v,
                       const ContactNodes<D>& list, const Kokkos::View<const Index, Memory>& rim) {
  double way = 0, speed = 0;
  Index deep = 0;
  if (list.count == 0) return {};
  count_launch();
  Kokkos::parallel_reduce(
      "breccia::contact::node_way",
      Kokkos::RangePolicy<Exec, Kokkos::IndexType<Index>>(0, list.count),
      KOKKOS_LAMBDA(Index i, double& most, double& fastest, Index& set) {
        if (i == 0) set = rim();
        const Index n = list.node(i);
        const double w = norm2(row<D>(x, n) - row<D>(list.place, n)), s = norm2(row<D>(v, n));
        most = w > most ? w : most;
        fastest = s > fastest ? s : fastest;
      },
      Kokkos::Max<double>(way), Kokkos::Max<double>(speed), Kokkos::Max<Index>(deep));
  return {Kokkos::sqrt(way), Kokkos::sqrt(speed), deep};
}

namespace {

/// 1 / height of a facet, 0 where it does not count.
template <int D>
struct InverseSize {
  ContactSurface<D> surface;
  Kokkos::View<const std::uint8_t*, Memory> own;

  KOKKOS_FUNCTION
  double operator()(Index i) const {
    if (own.extent(0) > 0 && own(surface.facet(i) / (D + 1)) == 0) return 0;
    return 1 / surface.height(i);
  }
};

}  // namespace

template <int D>
ContactSizes contact_sizes(const ContactSurface<D>& surface,
                           const Kokkos::View<const std::uint8_t*, Memory>& own) {
  ContactSizes sizes;
  if (surface.facets == 0) return sizes;
  const InverseSize<D> inverse{surface, own};
  count_launch();
  Kokkos::parallel_reduce(
      "breccia::contact::finest",
      Kokkos::RangePolicy<Exec, Kokkos::IndexType<Index>>(0, surface.facets),
      KOKKOS_LAMBDA(Index i, double& finest, std::int64_t& count) {
        const double size = inverse(i);
        finest = size > finest ? size : finest;
        count += size > 0 ? 1 : 0;
      },
      Kokkos::Max<double>(sizes.finest), Kokkos::Sum<std::int64_t>(sizes.facets));
  return sizes;
}

template <int D>
std::int64_t sum_of_inverse_sizes(const ContactSurface<D>& surface,
                                  const Kokkos::View<const std::uint8_t*, Memory>& own,
                                  double grain) {
  std::int64_t sum = 0;
  if (surface.facets == 0) return sum;
  const InverseSize<D> inverse{surface, own};
  count_launch();
  Kokkos::parallel_reduce(
      "breccia::contact::sizes",
      Kokkos::RangePolicy<Exec, Kokkos::IndexType<Index>>(0, surface.facets),
      KOKKOS_LAMBDA(Index i, std::int64_t & part) {
        part += static_cast<std::int64_t>(inverse(i) / grain);
      },
      sum);
  return sum;
}

template <int D>
void search_contacts(const ContactSurface<D>& surface, double skin,
                     ContactSearchScratch<D>& scratch, ContactPairs<D>& pairs) {
  if (surface.targets > 0) fill_contact_bins(surface, skin, scratch.bins);
  const Candidates<D> find{surface, scratch.bins, skin};
  list_pairs(find, surface.facets * kFacePoints<D>, scratch, pairs);
  finish_contact_pairs(surface, scratch, pairs);
}

template <int D>
void finish_contact_pairs(const ContactSurface<D>& surface, ContactSearchScratch<D>& scratch,
                          ContactPairs<D>& pairs) {
  list_elements(surface, scratch.count, pairs);
  make_room(pairs.hit, pairs.pairs);
  make_room(pairs.pair_distance, pairs.pairs);
  make_room(pairs.pair_force, pairs.pairs);
  make_room(pairs.pair_weight, pairs.pairs);
  make_room(pairs.point_force, pairs.points);
  make_room(pairs.nodes, pairs.points);
}

template void take_contact_places<2>(const ConstVectors<2>&, const ContactSurface<2>&);
template void take_contact_places<3>(const ConstVectors<3>&, const ContactSurface<3>&);
template void list_contact_nodes<2>(const ContactSurface<2>&, Index, ContactNodes<2>&);
template void list_contact_nodes<3>(const ContactSurface<3>&, Index, ContactNodes<3>&);
template ContactWay contact_way<2>(const ConstVectors<2>&, const ConstVectors<2>&,
                                   const ContactNodes<2>&,
                                   const Kokkos::View<const Index, Memory>&);
template ContactWay contact_way<3>(const ConstVectors<3>&, const ConstVectors<3>&,
                                   const ContactNodes<3>&,
                                   const Kokkos::View<const Index, Memory>&);
template ContactSizes contact_sizes<2>(const ContactSurface<2>&,
                                       const Kokkos::View<const std::uint8_t*, Memory>&);
template ContactSizes contact_sizes<3>(const ContactSurface<3>&,
                                       const Kokkos::View<const std::uint8_t*, Memory>&);
template std::int64_t sum_of_inverse_sizes<2>(const ContactSurface<2>&,
                                              const Kokkos::View<const std::uint8_t*, Memory>&,
                                              double);
template std::int64_t sum_of_inverse_sizes<3>(const ContactSurface<3>&,
                                              const Kokkos::View<const std::uint8_t*, Memory>&,
                                              double);
template void search_contacts<2>(const ContactSurface<2>&, double, ContactSearchScratch<2>&,
                                 ContactPairs<2>&);
template void search_contacts<3>(const ContactSurface<3>&, double, ContactSearchScratch<3>&,
                                 ContactPairs<3>&);

template void finish_contact_pairs<2>(const ContactSurface<2>&, ContactSearchScratch<2>&,
                                      ContactPairs<2>&);
template void finish_contact_pairs<3>(const ContactSurface<3>&, ContactSearchScratch<3>&,
                                      ContactPairs<3>&);

}  // namespace breccia
