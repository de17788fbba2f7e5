#include "loops/interface_tables.hpp"

namespace breccia {

namespace {

template <int D>
struct SourceLoop {
  InterfaceMap<D> map;
  ConstArray<Index> elements;
  PairSources<D> to;

  KOKKOS_FUNCTION
  void operator()(Index k) const {
    const Index e = elements(k);
    for (int a = 0; a <= D; ++a)
      for (int m = 0; m < D; ++m) {
        const int f = m < a ? m : m + 1;
        const Index i = map.at(e, f);
        to(k, a, m) = 0;
        if (i == kNone) continue;
        const Index face = map.faces.of_element(e, f);
        const Index place = i * D + map.faces.corner_at(face, e, a) + 1;
        to(k, a, m) = map.faces.elements(face, 0) == e ? place : -place;
      }
  }
};

template <int D>
struct BookLoop {
  ConstArray<Index> elements;
  Kokkos::View<const Index * [D + 1][D], Rows, Memory> sources;
  ConstPairForces<D> pair;
  CornerForces<D> force;

  KOKKOS_FUNCTION
  void operator()(Index k) const {
    const Index e = elements(k);
    for (int a = 0; a <= D; ++a) {
      Vec<D> sum = Vec<D>::zero();
      for (int m = 0; m < D; ++m) {
        const Index source = sources(k, a, m);
        if (source == 0) continue;
        const Index place = (source > 0 ? source : -source) - 1;
        for (int d = 0; d < D; ++d) {
          const double f = pair(place / D, place % D, d);
          sum[d] += source > 0 ? f : -f;
        }
      }
      for (int d = 0; d < D; ++d) force(e, a, d) = sum[d];
    }
  }
};

}  // namespace

template <int D>
void InterfaceTables<D>::fill_nodes(const ConstArray<Index>& list, Index count,
                                    const ConstConnectivity<D>& nodes,
                                    const PairNodes<D>& to) const {
  const InterfaceMap<D> m = map;
  for_each(
      "breccia::fracture::pair_nodes", count, KOKKOS_LAMBDA(Index k) {
        const Index face = m.record(list(k)).face;
        for (int c = 0; c < D; ++c) {
          const auto l = m.faces.left(face, c), r = m.faces.right(face, c);
          to(k, 0, c) = nodes(l.element, l.node);
          to(k, 1, c) = nodes(r.element, r.node);
        }
      });
}

template <int D>
void InterfaceTables<D>::fill_sources(const ConstArray<Index>& elements, Index count,
                                      const PairSources<D>& to) const {
  for_each("breccia::fracture::pair_sources", count, SourceLoop<D>{map, elements, to});
}

template <int D>
void book_pair_forces(const ConstArray<Index>& elements, Index count,
                      const Kokkos::View<const Index * [D + 1][D], Rows, Memory>& sources,
                      const ConstPairForces<D>& pair, const CornerForces<D>& force) {
  for_each("breccia::fracture::book_forces", count, BookLoop<D>{elements, sources, pair, force});
}

template <int D>
void clear_corner_forces(const ConstArray<Index>& elements, Index count,
                         const CornerForces<D>& force) {
  for_each(
      "breccia::fracture::clear_forces", count, KOKKOS_LAMBDA(Index k) {
        for (int a = 0; a <= D; ++a)
          for (int d = 0; d < D; ++d) force(elements(k), a, d) = 0;
      });
}

template struct InterfaceTables<2>;
template struct InterfaceTables<3>;
template void book_pair_forces<2>(const ConstArray<Index>&, Index,
                                  const Kokkos::View<const Index* [3][2], Rows, Memory>&,
                                  const ConstPairForces<2>&, const CornerForces<2>&);
template void book_pair_forces<3>(const ConstArray<Index>&, Index,
                                  const Kokkos::View<const Index* [4][3], Rows, Memory>&,
                                  const ConstPairForces<3>&, const CornerForces<3>&);
template void clear_corner_forces<2>(const ConstArray<Index>&, Index, const CornerForces<2>&);
template void clear_corner_forces<3>(const ConstArray<Index>&, Index, const CornerForces<3>&);

}  // namespace breccia
