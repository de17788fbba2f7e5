#include "loops/contact_search.hpp"

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
        x[d] += face_weight<D>(q, k) * surface.place(t, face_node<D>(f, k), d);
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

  KOKKOS_FUNCTION
  bool near(const Vec<D>& q, Index t) const {
    if (!ContactBox<D>(surface.place, t, skin).holds(q)) return false;
    Vec<D> x[D + 1];
    for (int a = 0; a <= D; ++a)
      for (int d = 0; d < D; ++d) x[a][d] = surface.place(t, a, d);
    double l[D + 1];
    return square_distance_to_simplex<D>(x, q, l) <= skin * skin;
  }

  /// Calls f(t) for each candidate of contact point `point` (face place * kFacePoints + q).
  template <class F>
  KOKKOS_FUNCTION
  void each(Index point, const F& f) const {
    const ContactGrid<D> grid{bins.cell, bins.buckets};
    const Vec<D> q = place(point);
    for (int level = 0; level < GridShape<D>::levels; ++level) {
      if ((bins.levels & (1u << level)) == 0) continue;
      const std::uint64_t tag = grid.tag_at(level, q);
      const Index bucket = grid.bucket(tag);
      for (Index k = bins.begin(bucket); k < bins.begin(bucket + 1); ++k) {
        const Index t = bins.target(k);
        if (bins.tag(k) == tag && apart(point / kFacePoints<D>, t) && near(q, t)) f(t);
      }
    }
  }
};

/// Points with candidates, and their candidates.
template <int D>
void list_pairs(const Candidates<D>& find, Index all_points, Array<Index>& count,
                ContactPairs<D>& pairs) {
  make_room(count, all_points);
  const Array<Index> counts = count;
  for_each(
      "breccia::contact::count_candidates", all_points, KOKKOS_LAMBDA(Index p) {
        Index n = 0;
        find.each(p, [&](Index) { ++n; });
        counts(p) = n;
      });
  pairs.points = list_where(
      "breccia::contact::points", all_points, KOKKOS_LAMBDA(Index p) { return counts(p) > 0; },
      pairs.point);
  make_room(pairs.facet, pairs.points);
  const Array<Index> point = pairs.point, facet = pairs.facet;
  pairs.pairs = list_begins(
      "breccia::contact::pairs", pairs.points, KOKKOS_LAMBDA(Index a) { return counts(point(a)); },
      pairs.pair_begin);
  make_room(pairs.target, pairs.pairs);
  const Array<Index> begin = pairs.pair_begin, target = pairs.target;
  const Array<Index> number = find.surface.facet;
  for_each(
      "breccia::contact::fill_candidates", pairs.points, KOKKOS_LAMBDA(Index a) {
        Index k = begin(a);
        find.each(point(a), [&](Index t) { target(k++) = t; });
        sort_list(&target(begin(a)), k - begin(a));
        facet(a) = point(a) / kFacePoints<D>;
        point(a) = number(facet(a)) * kFacePoints<D> + point(a) % kFacePoints<D>;
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
ContactWay contact_way(const ConstVectors<D>& x, const ConstVectors<D>& v,
                       const ContactSurface<D>& surface,
                       const Kokkos::View<const Index, Memory>& rim) {
  double way = 0, speed = 0;
  Index deep = 0;
  if (surface.targets == 0) return {};
  count_launch();
  Kokkos::parallel_reduce(
      "breccia::contact::way",
      Kokkos::RangePolicy<Exec, Kokkos::IndexType<Index>>(0, surface.targets),
      KOKKOS_LAMBDA(Index t, double& most, double& fastest, Index& set) {
        if (t == 0) set = rim();
        for (int a = 0; a <= D; ++a) {
          const Index n = surface.nodes(t, a);
          double w = 0, s = 0;
          for (int d = 0; d < D; ++d) {
            const double u = x(n, d) - surface.place(t, a, d);
            w += u * u;
            s += v(n, d) * v(n, d);
          }
          most = w > most ? w : most;
          fastest = s > fastest ? s : fastest;
        }
      },
      Kokkos::Max<double>(way), Kokkos::Max<double>(speed), Kokkos::Max<Index>(deep));
  return {Kokkos::sqrt(way), Kokkos::sqrt(speed), deep};
}

template <int D>
double smallest_contact_size(const ContactSurface<D>& surface) {
  double least = 0;
  if (surface.facets == 0) return least;
  const Array<double> height = surface.height;
  count_launch();
  Kokkos::parallel_reduce(
      "breccia::contact::smallest",
      Kokkos::RangePolicy<Exec, Kokkos::IndexType<Index>>(0, surface.facets),
      KOKKOS_LAMBDA(Index i, double& part) { part = height(i) < part ? height(i) : part; },
      Kokkos::Min<double>(least));
  return D * least;
}

template <int D>
void search_contacts(const ContactSurface<D>& surface, double skin,
                     ContactSearchScratch<D>& scratch, ContactPairs<D>& pairs) {
  if (surface.targets > 0) fill_contact_bins(surface, skin, scratch.bins);
  const Candidates<D> find{surface, scratch.bins, skin};
  list_pairs(find, surface.facets * kFacePoints<D>, scratch.count, pairs);
  finish_contact_pairs(surface, scratch, pairs);
}

template <int D>
void finish_contact_pairs(const ContactSurface<D>& surface, ContactSearchScratch<D>& scratch,
                          ContactPairs<D>& pairs) {
  list_elements(surface, scratch.count, pairs);
  make_room(pairs.hit, pairs.pairs);
  make_room(pairs.pair_force, pairs.pairs);
  make_room(pairs.pair_weight, pairs.pairs);
  make_room(pairs.point_force, pairs.points);
  make_room(pairs.nodes, pairs.points);
}

template void take_contact_places<2>(const ConstVectors<2>&, const ContactSurface<2>&);
template void take_contact_places<3>(const ConstVectors<3>&, const ContactSurface<3>&);
template ContactWay contact_way<2>(const ConstVectors<2>&, const ConstVectors<2>&,
                                   const ContactSurface<2>&,
                                   const Kokkos::View<const Index, Memory>&);
template ContactWay contact_way<3>(const ConstVectors<3>&, const ConstVectors<3>&,
                                   const ContactSurface<3>&,
                                   const Kokkos::View<const Index, Memory>&);
template double smallest_contact_size<2>(const ContactSurface<2>&);
template double smallest_contact_size<3>(const ContactSurface<3>&);
template void search_contacts<2>(const ContactSurface<2>&, double, ContactSearchScratch<2>&,
                                 ContactPairs<2>&);
template void search_contacts<3>(const ContactSurface<3>&, double, ContactSearchScratch<3>&,
                                 ContactPairs<3>&);

template void finish_contact_pairs<2>(const ContactSurface<2>&, ContactSearchScratch<2>&,
                                      ContactPairs<2>&);
template void finish_contact_pairs<3>(const ContactSurface<3>&, ContactSearchScratch<3>&,
                                      ContactPairs<3>&);

}  // namespace breccia
