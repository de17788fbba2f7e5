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

template Vec<2> sample<2>(const ConstVectors<2>&, const Array<Index>&, const Array<double>&);
template Vec<3> sample<3>(const ConstVectors<3>&, const Array<Index>&, const Array<double>&);

}  // namespace breccia
