#include "loops/contact_flyers.hpp"

#include "loops/list_tools.hpp"

#include <Kokkos_MathematicalConstants.hpp>

namespace breccia {

namespace {

/// Most of the members of a large piece change nothing, so that few of them wait for each other.
KOKKOS_INLINE_FUNCTION
void raise_to(double& most, double value) {
  if (value > most) Kokkos::atomic_max(&most, value);
}

KOKKOS_INLINE_FUNCTION
void lower_to(double& least, double value) {
  if (value < least) Kokkos::atomic_min(&least, value);
}

template <int D>
struct MovePieces {
  using P = ContactPieces<D>;
  ContactSurface<D> surface;
  P pieces;
  ConstVectors<D> x, v;

  KOKKOS_FUNCTION
  void operator()(Index t) const {
    const Index p = pieces.of_target(t), first = surface.nodes(pieces.first(p), 0);
    const Vec<D> v_first = row<D>(v, first);
    double most[4] = {0, 0, 0, 0};
    for (int k = 0; k <= D; ++k) {
      const Vec<D> v_node = row<D>(v, surface.nodes(t, k));
      Vec<D> by = row<D>(x, surface.nodes(t, k)), apart;
      for (int d = 0; d < D; ++d) {
        by[d] -= surface.place(t, k, d);
        apart[d] = by[d] - pieces.numbers(p, P::shift + d);
      }
      most[0] = Kokkos::max(most[0], norm2(by));
      most[1] = Kokkos::max(most[1], norm2(apart));
      most[2] = Kokkos::max(most[2], norm2(v_node));
      most[3] = Kokkos::max(most[3], norm2(v_node - v_first));
    }
    for (int c = 0; c < 4; ++c) raise_to(pieces.numbers(p, P::way + c), most[c]);
  }
};

template <int D>
struct NearTargets {
  using P = ContactPieces<D>;
  ContactSurface<D> surface;
  P pieces;
  PieceReach<D> reach;
  Array<Index> list;
  Index n;

  KOKKOS_FUNCTION
  bool operator()(Index t) const {
    const Index p = pieces.of_target(t);
    double low[D], high[D];
    for (int d = 0; d < D; ++d) {
      low[d] = high[d] = surface.place(t, 0, d);
      for (int k = 1; k <= D; ++k) {
        low[d] = Kokkos::min(low[d], surface.place(t, k, d));
        high[d] = Kokkos::max(high[d], surface.place(t, k, d));
      }
      low[d] += reach(p, d);
      high[d] += reach(p, D + d);
    }
    for (Index i = 0; i < n; ++i) {
      const Index q = list(i);
      bool apart = q == p;
      for (int d = 0; d < D; ++d)
        apart = apart || high[d] < pieces.numbers(q, P::lower + d) + reach(q, d) ||
                low[d] > pieces.numbers(q, P::upper + d) + reach(q, D + d);
      if (!apart) return true;
    }
    return false;
  }
};

}  // namespace

template <int D>
void box_pieces(const ContactSurface<D>& surface, const ContactPieces<D>& pieces) {
  using P = ContactPieces<D>;
  const P to = pieces;
  const Index targets = surface.targets;
  for_each(
      "breccia::contact::clear_pieces", pieces.count, KOKKOS_LAMBDA(Index p) {
        to.first(p) = targets;
        for (int d = 0; d < D; ++d) {
          to.numbers(p, P::lower + d) = Kokkos::Experimental::infinity_v<double>;
          to.numbers(p, P::upper + d) = -Kokkos::Experimental::infinity_v<double>;
        }
      });
  for_each(
      "breccia::contact::box_pieces", targets, KOKKOS_LAMBDA(Index t) {
        const Index p = to.of_target(t);
        if (t < to.first(p)) Kokkos::atomic_min(&to.first(p), t);
        for (int k = 0; k <= D; ++k)
          for (int d = 0; d < D; ++d) {
            lower_to(to.numbers(p, P::lower + d), surface.place(t, k, d));
            raise_to(to.numbers(p, P::upper + d), surface.place(t, k, d));
          }
      });
}

template <int D>
void move_pieces(const ContactSurface<D>& surface, const ContactPieces<D>& pieces,
                 const ConstVectors<D>& x, const ConstVectors<D>& v) {
  using P = ContactPieces<D>;
  const P to = pieces;
  for_each(
      "breccia::contact::shift_pieces", pieces.count, KOKKOS_LAMBDA(Index p) {
        const Index t = to.first(p), node = surface.nodes(t, 0);
        for (int d = 0; d < D; ++d)
          to.numbers(p, P::shift + d) = x(node, d) - surface.place(t, 0, d);
        for (int c = P::way; c < P::columns; ++c) to.numbers(p, c) = 0;
      });
  for_each("breccia::contact::move_pieces", surface.targets, MovePieces<D>{surface, pieces, x, v});
}

template <int D>
bool pieces_near(const ContactSurface<D>& surface, const ContactPieces<D>& pieces,
                 const PieceReach<D>& reach, const Array<Index>& list, Index n) {
  return count_where("breccia::contact::pieces_near", surface.targets,
                     NearTargets<D>{surface, pieces, reach, list, n}) > 0;
}

template void box_pieces<2>(const ContactSurface<2>&, const ContactPieces<2>&);
template void box_pieces<3>(const ContactSurface<3>&, const ContactPieces<3>&);
template void move_pieces<2>(const ContactSurface<2>&, const ContactPieces<2>&,
                             const ConstVectors<2>&, const ConstVectors<2>&);
template void move_pieces<3>(const ContactSurface<3>&, const ContactPieces<3>&,
                             const ConstVectors<3>&, const ConstVectors<3>&);
template bool pieces_near<2>(const ContactSurface<2>&, const ContactPieces<2>&,
                             const PieceReach<2>&, const Array<Index>&, Index);
template bool pieces_near<3>(const ContactSurface<3>&, const ContactPieces<3>&,
                             const PieceReach<3>&, const Array<Index>&, Index);

}  // namespace breccia
