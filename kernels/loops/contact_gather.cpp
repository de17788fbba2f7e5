#include "loops/contact_gather.hpp"

#include "loops/list_tools.hpp"
#include "point/simplex_geometry.hpp"

namespace breccia {

namespace {

/// What a contact point hands to its own face's nodes: all of its force, by its weights.
template <int D>
struct ByPoints {
  double own_weight;

  KOKKOS_FUNCTION
  void add(const ContactPairs<D>& pairs, Index a, int f, Vec<D> (&sum)[D + 1]) const {
    const int q = pairs.point(a) % kFacePoints<D>;
    const Vec<D> force = row<D>(pairs.point_force, a);
    for (int k = 0; k < D; ++k) sum[face_node<D>(f, k)] += force * face_weight<D>(q, k, own_weight);
  }
};

/// The same for a part of a face: each pair has its own place on it.
template <int D>
struct ByParts {
  KOKKOS_FUNCTION
  void add(const ContactPairs<D>& pairs, Index a, int f, Vec<D> (&sum)[D + 1]) const {
    for (Index p = pairs.pair_begin(a); p < pairs.pair_begin(a + 1); ++p)
      for (int k = 0; k < D && pairs.hit(p) != 0; ++k)
        sum[face_node<D>(f, k)] += row<D>(pairs.pair_force, p) * pairs.pair_own(p, k);
  }
};

template <int D, class Own>
struct GatherContact {
  ContactSurface<D> surface;
  ContactPairs<D> pairs;
  CornerForces<D> force;
  Own own;

  KOKKOS_FUNCTION
  void operator()(Index i) const {
    const Index t = pairs.element(i);
    Vec<D> sum[D + 1];
    for (int a = 0; a <= D; ++a) sum[a] = Vec<D>::zero();
    for (Index a = pairs.own_begin(t); a < pairs.own_begin(t + 1); ++a)
      own.add(pairs, a, (pairs.point(a) / kFacePoints<D>) % (D + 1), sum);
    for (Index c = pairs.come_begin(t); c < pairs.come_begin(t + 1); ++c) {
      const Index p = pairs.come(c);
      if (pairs.hit(p) == 0) continue;
      const Vec<D> f = row<D>(pairs.pair_force, p);
      for (int a = 0; a <= D; ++a) sum[a] -= f * pairs.pair_weight(p, a);
    }
    const Index e = surface.target(t);
    for (int a = 0; a <= D; ++a)
      for (int d = 0; d < D; ++d) force(e, a, d) = sum[a][d];
  }
};

/// Where each pair would touch, as far as it counts for the stable step.
template <int D>
struct LikelyContact {
  ContactStiffnessIn<D> in;

  KOKKOS_FUNCTION
  bool joined(Index p, Index r) const {
    for (int a = 0; a <= D; ++a)
      for (int b = 0; b <= D; ++b)
        if (in.surface.nodes(in.pairs.target(p), a) == in.surface.nodes(in.pairs.target(r), b))
          return true;
    return false;
  }

  /// Distances of a point's pairs; those for which no nearer one of the same piece stands are
  /// marked as hit.
  KOKKOS_FUNCTION
  void operator()(Index a) const {
    const Index point = in.pairs.point(a), own = in.surface.facet_target(in.pairs.facet(a));
    const int f = (point / kFacePoints<D>) % (D + 1), q = point % kFacePoints<D>;
    Vec<D> at = Vec<D>::zero();
    for (int k = 0; k < D; ++k)
      for (int d = 0; d < D; ++d)
        at[d] += face_weight<D>(q, k, in.surface.own_weight) *
                 in.surface.place(own, face_node<D>(f, k), d);
    const Index begin = in.pairs.pair_begin(a), end = in.pairs.pair_begin(a + 1);
    for (Index p = begin; p < end; ++p) {
      Vec<D> x[D + 1];
      for (int k = 0; k <= D; ++k)
        for (int d = 0; d < D; ++d) x[k][d] = in.surface.place(in.pairs.target(p), k, d);
      double l[D + 1];
      in.pairs.pair_distance(p) = square_distance_to_simplex<D>(x, at, l);
      for (int k = 0; k <= D; ++k) in.pairs.pair_weight(p, k) = l[k];
    }
    for (Index p = begin; p < end; ++p) {
      const double d2 = in.pairs.pair_distance(p);
      bool counts = true;
      for (Index r = begin; r < end && counts; ++r) {
        const double e2 = in.pairs.pair_distance(r);
        counts = r == p || e2 > d2 || (e2 == d2 && r > p) || !joined(p, r);
      }
      in.pairs.hit(p) = counts ? 1 : 0;
    }
  }

  /// Stiffness of a pair that counts, else nothing.
  KOKKOS_FUNCTION
  double stiffness(Index a, Index p) const {
    if (in.pairs.hit(p) == 0) return 0;
    const Index target = in.surface.target(in.pairs.target(p));
    const Index pair = in.point.material(a) * in.materials + in.element_material(target);
    return in.point.constants(a, 0) * in.table(pair, 1);
  }
};

/// Point of a pair: the last one whose pairs begin at or before it.
KOKKOS_INLINE_FUNCTION
Index point_of(const Array<Index>& begin, Index points, Index p) {
  Index low = 0, high = points;
  while (high - low > 1) {
    const Index middle = low + (high - low) / 2;
    if (begin(middle) <= p) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return low;
}

/// Twice the stiffness at the corners of an involved element.
template <int D>
KOKKOS_FUNCTION
void element_stiffness(const LikelyContact<D>& likely, Index i) {
  const ContactStiffnessIn<D>& in = likely.in;
  const Index t = in.pairs.element(i);
  double sum[D + 1];
  for (int a = 0; a <= D; ++a) sum[a] = 0;
  for (Index a = in.pairs.own_begin(t); a < in.pairs.own_begin(t + 1); ++a) {
    double k = 0;
    for (Index p = in.pairs.pair_begin(a); p < in.pairs.pair_begin(a + 1); ++p)
      k += likely.stiffness(a, p);
    const Index point = in.pairs.point(a);
    for (int n = 0; n < D; ++n)
      sum[face_node<D>((point / kFacePoints<D>) % (D + 1), n)] +=
          2 * k * face_weight<D>(point % kFacePoints<D>, n, in.surface.own_weight);
  }
  for (Index c = in.pairs.come_begin(t); c < in.pairs.come_begin(t + 1); ++c) {
    const Index p = in.pairs.come(c), a = point_of(in.pairs.pair_begin, in.pairs.points, p);
    const double k = likely.stiffness(a, p);
    if (k == 0) continue;
    for (int n = 0; n <= D; ++n) sum[n] += 2 * k * in.pairs.pair_weight(p, n);
  }
  for (int a = 0; a <= D; ++a) in.corner(in.surface.target(t), a) = sum[a];
}

}  // namespace

template <int D>
void gather_contact(const ContactSurface<D>& surface, const ContactPairs<D>& pairs,
                    const CornerForces<D>& force) {
  for_each("breccia::contact::gather", pairs.elements,
           GatherContact<D, ByPoints<D>>{surface, pairs, force, {surface.own_weight}});
}

template <int D>
void gather_contact_distributed(const ContactSurface<D>& surface, const ContactPairs<D>& pairs,
                                const CornerForces<D>& force) {
  for_each("breccia::contact::gather_distributed", pairs.elements,
           GatherContact<D, ByParts<D>>{surface, pairs, force, {}});
}

template <int D>
void flag_contact(const ContactSurface<D>& surface, const ContactPairs<D>& pairs,
                  const ConstConnectivity<D>& element_nodes, const Array<std::uint32_t>& flags,
                  std::uint32_t bit) {
  for_each(
      "breccia::contact::flag", pairs.elements, KOKKOS_LAMBDA(Index i) {
        const Index e = surface.target(pairs.element(i));
        for (int a = 0; a <= D; ++a) Kokkos::atomic_or(&flags(element_nodes(e, a)), bit);
      });
}

template <int D>
void clear_contact(const ContactSurface<D>& surface, const ContactPairs<D>& pairs, Index nodes,
                   const Array<std::uint32_t>& flags, std::uint32_t bit,
                   const CornerForces<D>& force) {
  for_each(
      "breccia::contact::clear_flags", nodes, KOKKOS_LAMBDA(Index n) { flags(n) &= ~bit; });
  for_each(
      "breccia::contact::clear_forces", pairs.elements, KOKKOS_LAMBDA(Index i) {
        const Index e = surface.target(pairs.element(i));
        for (int a = 0; a <= D; ++a)
          for (int d = 0; d < D; ++d) force(e, a, d) = 0;
      });
}

template <int D>
void find_contact_stiffness(const ContactStiffnessIn<D>& in) {
  if (in.pairs.points == 0) return;
  const LikelyContact<D> likely{in};
  Kokkos::deep_copy(Exec(), in.corner, 0.0);
  for_each("breccia::contact::likely", in.pairs.points, likely);
  for_each(
      "breccia::contact::corner_stiffness", in.pairs.elements,
      KOKKOS_LAMBDA(Index i) { element_stiffness(likely, i); });
}

template <int D>
void add_contact_stiffness(const ContactStiffnessIn<D>& in, const Array<double>& stiffness) {
  if (in.pairs.points == 0) return;
  for_each(
      "breccia::contact::stiffness", in.nodes, KOKKOS_LAMBDA(Index n) {
        if ((in.flags(n) & in.bit) == 0) return;
        double s = 0;
        for (Index k = in.corners(n, 0); k < in.corners(n, 1); ++k)
          s += in.corner(in.corner_list(k) / (D + 1), in.corner_list(k) % (D + 1));
        stiffness(n) += s;
      });
}

template void gather_contact_distributed<2>(const ContactSurface<2>&, const ContactPairs<2>&,
                                            const CornerForces<2>&);
template void gather_contact_distributed<3>(const ContactSurface<3>&, const ContactPairs<3>&,
                                            const CornerForces<3>&);
template void gather_contact<2>(const ContactSurface<2>&, const ContactPairs<2>&,
                                const CornerForces<2>&);
template void gather_contact<3>(const ContactSurface<3>&, const ContactPairs<3>&,
                                const CornerForces<3>&);
template void flag_contact<2>(const ContactSurface<2>&, const ContactPairs<2>&,
                              const ConstConnectivity<2>&, const Array<std::uint32_t>&,
                              std::uint32_t);
template void flag_contact<3>(const ContactSurface<3>&, const ContactPairs<3>&,
                              const ConstConnectivity<3>&, const Array<std::uint32_t>&,
                              std::uint32_t);
template void clear_contact<2>(const ContactSurface<2>&, const ContactPairs<2>&, Index,
                               const Array<std::uint32_t>&, std::uint32_t, const CornerForces<2>&);
template void clear_contact<3>(const ContactSurface<3>&, const ContactPairs<3>&, Index,
                               const Array<std::uint32_t>&, std::uint32_t, const CornerForces<3>&);
template void find_contact_stiffness<2>(const ContactStiffnessIn<2>&);
template void add_contact_stiffness<2>(const ContactStiffnessIn<2>&, const Array<double>&);
template void find_contact_stiffness<3>(const ContactStiffnessIn<3>&);
template void add_contact_stiffness<3>(const ContactStiffnessIn<3>&, const Array<double>&);

}  // namespace breccia
