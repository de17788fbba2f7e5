#include "loops/interface_tables.hpp"

namespace breccia {

namespace {

/// Sum of the pair forces at local node a of element e. An entry without a pair reads the first
/// pair and takes nothing of it: no branch that cannot be foretold.
template <int D>
KOKKOS_FORCEINLINE_FUNCTION
void book_corner(const ConstPairSources<D>& sources, const ConstPairForces<D>& pair, Index e, int a,
                 const CornerForces<D>& force) {
  Vec<D> sum = Vec<D>::zero();
  for (int m = 0; m < D; ++m) {
    const Index source = sources(e, a, m);
    const int sign = (source > 0) - (source < 0);
    const Index place = sign * source - sign * sign;
    const auto share = static_cast<double>(sign);
    const double* f = pair.data() + static_cast<std::ptrdiff_t>(place) * D;
    for (int d = 0; d < D; ++d) sum[d] += share * f[d];
  }
  for (int d = 0; d < D; ++d) force(e, a, d) = sum[d];
}

template <int D>
KOKKOS_FUNCTION
void fill_sources(const InterfaceTables<D>& in, Index e, int a) {
  for (int m = 0; m < D; ++m) {
    const int f = m < a ? m : m + 1;
    const Index i = in.map.at(e, f);
    in.sources(e, a, m) = 0;
    if (i == kNone) continue;
    const Index face = in.map.faces.of_element(e, f);
    const int c = in.map.faces.corner_at(face, e, a);
    const bool left = in.map.faces.elements(face, 0) == e;
    in.sources(e, a, m) = left ? i * D + c + 1 : -(i * D + c + 1);
    in.nodes(i, left ? 0 : 1, c) = in.element_nodes(e, a);
  }
}

template <int D>
struct RenewLoop {
  InterfaceTables<D> in;
  ConstArray<Index> families;
  ConstRanges family_corners;
  ConstArray<Index> corner_list;
  ConstPairForces<D> pair;
  CornerForces<D> force;

  KOKKOS_FUNCTION
  void operator()(Index t) const {
    const Index end = family_corners(families(t), 1);
    for (Index k = family_corners(families(t), 0); k < end; ++k) {
      const Index e = corner_list(k) / (D + 1);
      const int a = static_cast<int>(corner_list(k) % (D + 1));
      fill_sources(in, e, a);
      book_corner<D>(in.sources, pair, e, a, force);
    }
  }
};

}  // namespace

template <int D>
void InterfaceTables<D>::fill(Index interfaces, Index elements) const {
  const InterfaceTables<D> in = *this;
  for_each(
      "breccia::fracture::clear_pair_nodes", interfaces, KOKKOS_LAMBDA(Index i) {
        for (int c = 0; c < D; ++c) in.nodes(i, 0, c) = in.nodes(i, 1, c) = 0;
      });
  for_each(
      "breccia::fracture::fill_tables", elements, KOKKOS_LAMBDA(Index e) {
        for (int a = 0; a <= D; ++a) fill_sources(in, e, a);
      });
}

template <int D>
void InterfaceTables<D>::renew(const ConstArray<Index>& families, Index count,
                               const ConstRanges& family_corners,
                               const ConstArray<Index>& corner_list, const ConstPairForces<D>& pair,
                               const CornerForces<D>& force) const {
  for_each("breccia::fracture::renew_tables", count,
           RenewLoop<D>{*this, families, family_corners, corner_list, pair, force});
}

template <int D>
void book_pair_forces(const ConstArray<Index>& elements, Index count,
                      const ConstPairSources<D>& sources, const ConstPairForces<D>& pair,
                      const CornerForces<D>& force) {
  for_each(
      "breccia::fracture::book_forces", count, KOKKOS_LAMBDA(Index k) {
        const Index e = elements(k);
        for (int a = 0; a <= D; ++a) book_corner<D>(sources, pair, e, a, force);
      });
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
template void book_pair_forces<2>(const ConstArray<Index>&, Index, const ConstPairSources<2>&,
                                  const ConstPairForces<2>&, const CornerForces<2>&);
template void book_pair_forces<3>(const ConstArray<Index>&, Index, const ConstPairSources<3>&,
                                  const ConstPairForces<3>&, const CornerForces<3>&);
template void clear_corner_forces<2>(const ConstArray<Index>&, Index, const CornerForces<2>&);
template void clear_corner_forces<3>(const ConstArray<Index>&, Index, const CornerForces<3>&);

}  // namespace breccia
