#include "loops/contact_history.hpp"

#include "base/simplex.hpp"
#include "loops/list_tools.hpp"

namespace breccia {

namespace {

template <int D>
struct TakeOver {
  ContactHandover<D> in;
  ContactPairs<D> pairs;
  ContactHistory<D> history;

  KOKKOS_FUNCTION
  void operator()(Index a) const {
    const Index point = pairs.point(a), facet = point / kFacePoints<D>;
    if (find_in(in.old_facet, in.old_facets, facet) != kNone) return;
    const Index e = facet / (D + 1), face = in.element_faces(e, facet % (D + 1));
    if (face == kNone || in.face_interface(face) == kNone) return;
    const bool left = in.face_elements(face, 0) == e;
    const int turn = in.face_code(face) >> 4;
    for (int k = 0; k < ContactHistory<D>::kNumbers; ++k) history.state(a, 0, k) = 0;
    history.element(a, 0) = in.face_elements(face, left ? 1 : 0);
    history.state(a, 0, ContactHistory<D>::depth) = ContactHistory<D>::handed;
    for (int i = 0; i < D; ++i) {
      const int corner = left ? i : opposite_face_node<D>(turn, i);
      const double w = face_weight<D>(point % kFacePoints<D>, i, in.own_weight) * (left ? -1 : 1);
      for (int d = 0; d < D; ++d)
        history.state(a, 0, ContactHistory<D>::slip + d) +=
            w * in.slip(in.face_interface(face), corner, d);
      if (history.rubbed.extent(0) == 0) continue;
      for (int k = 0; k < 3; ++k)
        history.rubbed(a, 0, k) = (i == 0 ? 0 : history.rubbed(a, 0, k)) +
                                  Kokkos::abs(w) * in.rubbed(in.face_interface(face), corner, k);
    }
  }
};

}  // namespace

template <int D>
void carry_history(const Array<Index>& old_point, Index old_points, const ContactHistory<D>& old,
                   const Array<Index>& point, Index points, const ContactHistory<D>& now) {
  for_each(
      "breccia::contact::carry_history", points, KOKKOS_LAMBDA(Index a) {
        const Index from = find_in(old_point, old_points, point(a));
        for (int s = 0; s < kContactSlots; ++s) {
          now.element(a, s) = from == kNone ? kNone : old.element(from, s);
          for (int k = 0; k < ContactHistory<D>::kNumbers; ++k)
            now.state(a, s, k) = now.element(a, s) == kNone ? 0.0 : old.state(from, s, k);
          if (now.rubbed.extent(0) == 0) continue;
          for (int k = 0; k < 3; ++k)
            now.rubbed(a, s, k) = now.element(a, s) == kNone ? 0.0 : old.rubbed(from, s, k);
        }
      });
}

template <int D>
void copy_history(const Array<Index>& from_point, const ContactHistory<D>& from, Index points,
                  const Array<Index>& to_point, const ContactHistory<D>& to) {
  for_each(
      "breccia::contact::copy_history", points, KOKKOS_LAMBDA(Index a) {
        to_point(a) = from_point(a);
        for (int s = 0; s < kContactSlots; ++s) {
          to.element(a, s) = from.element(a, s);
          for (int k = 0; k < ContactHistory<D>::kNumbers; ++k)
            to.state(a, s, k) = from.state(a, s, k);
          if (to.rubbed.extent(0) == 0) continue;
          for (int k = 0; k < 3; ++k) to.rubbed(a, s, k) = from.rubbed(a, s, k);
        }
      });
}

template <int D>
void take_over(const ContactHandover<D>& in, const ContactPairs<D>& pairs,
               const ContactHistory<D>& history) {
  for_each("breccia::contact::take_over", pairs.points, TakeOver<D>{in, pairs, history});
}

template <int D>
double stored_energy(const ContactHistory<D>& history, Index points) {
  const ChunkSums<1> rows("breccia::contact::stored", static_cast<std::size_t>(chunks_of(points)));
  for_each_summed<1>(
      "breccia::contact::stored", points, rows, KOKKOS_LAMBDA(Index a, Sums<1> & sum) {
        for (int s = 0; s < kContactSlots && history.counts(a); ++s)
          if (history.element(a, s) != kNone)
            sum[0] += history.state(a, s, ContactHistory<D>::stored);
      });
  return total_of(rows)[0];
}

template <int D>
Index pressing_points(const ContactHistory<D>& history, Index points) {
  return count_where(
      "breccia::contact::count", points, KOKKOS_LAMBDA(Index a) {
        bool any = false;
        for (int s = 0; s < kContactSlots && history.counts(a); ++s)
          any = any || (history.element(a, s) != kNone &&
                        history.state(a, s, ContactHistory<D>::depth) > 0);
        return any;
      });
}

template <int D>
DeepestPoint deepest_point(const ContactHistory<D>& history, const Array<Index>& facet,
                           const Array<double>& height, Index points) {
  if (points == 0) return {};
  using Deepest = Kokkos::MaxLoc<double, Index>;
  Deepest::value_type found;
  count_launch();
  Kokkos::parallel_reduce(
      "breccia::contact::deepest", Kokkos::RangePolicy<Exec, Kokkos::IndexType<Index>>(0, points),
      KOKKOS_LAMBDA(Index a, Deepest::value_type & best) {
        for (int s = 0; s < kContactSlots && history.counts(a); ++s) {
          if (history.element(a, s) == kNone) continue;
          const double share =
              history.state(a, s, ContactHistory<D>::depth) / (D * height(facet(a)));
          if (share > best.val || (share == best.val && a < best.loc)) best = {share, a};
        }
      },
      Deepest(found));
  if (!(found.val > 0)) return {};
  return {found.val, found.loc};
}

template void carry_history<2>(const Array<Index>&, Index, const ContactHistory<2>&,
                               const Array<Index>&, Index, const ContactHistory<2>&);
template void carry_history<3>(const Array<Index>&, Index, const ContactHistory<3>&,
                               const Array<Index>&, Index, const ContactHistory<3>&);
template void copy_history<2>(const Array<Index>&, const ContactHistory<2>&, Index,
                              const Array<Index>&, const ContactHistory<2>&);
template void copy_history<3>(const Array<Index>&, const ContactHistory<3>&, Index,
                              const Array<Index>&, const ContactHistory<3>&);
template void take_over<2>(const ContactHandover<2>&, const ContactPairs<2>&,
                           const ContactHistory<2>&);
template void take_over<3>(const ContactHandover<3>&, const ContactPairs<3>&,
                           const ContactHistory<3>&);
template double stored_energy<2>(const ContactHistory<2>&, Index);
template double stored_energy<3>(const ContactHistory<3>&, Index);
template Index pressing_points<2>(const ContactHistory<2>&, Index);
template Index pressing_points<3>(const ContactHistory<3>&, Index);
template DeepestPoint deepest_point<2>(const ContactHistory<2>&, const Array<Index>&,
                                       const Array<double>&, Index);
template DeepestPoint deepest_point<3>(const ContactHistory<3>&, const Array<Index>&,
                                       const Array<double>&, Index);

}  // namespace breccia
