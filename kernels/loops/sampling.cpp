#include "loops/sampling.hpp"

namespace breccia {

template <int D>
Vec<D> sample(const ConstVectors<D>& field, const Array<Index>& nodes,
              const Array<double>& weights) {
  const auto n = static_cast<Index>(nodes.extent(0));
  const ChunkSums<D> rows("breccia::sensor::sample", static_cast<std::size_t>(chunks_of(n)));
  for_each_summed<D>(
      "breccia::sensor::sample", n, rows, KOKKOS_LAMBDA(Index i, Sums<D> & sum) {
        for (int d = 0; d < D; ++d) sum[d] += weights(i) * field(nodes(i), d);
      });
  const Sums<D> total = total_of(rows);
  Vec<D> result;
  for (int d = 0; d < D; ++d) result[d] = total[d];
  return result;
}

namespace {

template <int D>
struct StressAtPoint {
  ElementStress<D> stress;
  ConstRanges corners;
  Array<Index> corner_list;
  StressPoint<D> at;
  Kokkos::View<Sym<D>, Memory> out;

  KOKKOS_FUNCTION
  void operator()(Index) const {
    Sym<D> sigma = Sym<D>::zero();
    for (int a = 0; a <= D; ++a) sigma += at_node(stress.nodes(at.element, a)) * at.shares[a];
    out() = sigma;
  }

 private:
  KOKKOS_FUNCTION
  Sym<D> at_node(Index n) const {
    Sym<D> sum = Sym<D>::zero();
    double volume = 0;
    for (Index k = corners(n, 0); k < corners(n, 1); ++k) {
      const Index e = corner_list(k) / (D + 1);
      if (stress.material(e) != stress.material(at.element)) continue;
      const double share = stress.volume(e) * (stress.share.extent(0) > 0 ? stress.share(e) : 1.0);
      if (!(share > 0)) continue;  // excavated
      sum += stress.cauchy(e) * share;
      volume += share;
    }
    return volume > 0 ? sum * (1 / volume) : sum;
  }
};

}  // namespace

template <int D>
Sym<D> sample_stress(const ElementStress<D>& stress, const ConstRanges& corners,
                     const Array<Index>& corner_list, const StressPoint<D>& at) {
  const Kokkos::View<Sym<D>, Memory> out("breccia::sensor::stress");
  run_once("breccia::sensor::stress", StressAtPoint<D>{stress, corners, corner_list, at, out});
  return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, out)();
}

template Sym<2> sample_stress<2>(const ElementStress<2>&, const ConstRanges&, const Array<Index>&,
                                 const StressPoint<2>&);
template Sym<3> sample_stress<3>(const ElementStress<3>&, const ConstRanges&, const Array<Index>&,
                                 const StressPoint<3>&);
template Vec<2> sample<2>(const ConstVectors<2>&, const Array<Index>&, const Array<double>&);
template Vec<3> sample<3>(const ConstVectors<3>&, const Array<Index>&, const Array<double>&);

}  // namespace breccia
