#include "loops/element_stress.hpp"

namespace breccia {

template <int D>
double strain_energy(const ElementStress<D>& stress, Index begin, Index end, int group) {
  const Index n = (end - begin) / group;
  const ChunkSums<1> rows("breccia::solid::strain_energy", chunks_of(n));
  for_each_summed<1>(
      "breccia::solid::strain_energy", n, rows,
      KOKKOS_LAMBDA(Index i, Sums<1> & sum) { sum[0] += stress.energy(begin + i * group, group); });
  return total_of(rows)[0];
}

template <int D>
Kokkos::View<double**, Rows, Memory> cauchy_stress(const ElementStress<D>& stress, Index n) {
  constexpr int kSize = FullSym<D>::size;
  const Kokkos::View<double**, Rows, Memory> out(
      Kokkos::view_alloc(Kokkos::WithoutInitializing, "breccia::solid::cauchy_stress"), n, kSize);
  for_each(
      "breccia::solid::cauchy_stress", n, KOKKOS_LAMBDA(Index e) {
        const FullSym<D> sigma = stress.full_cauchy(e);
        for (int i = 0; i < kSize; ++i) out(e, i) = sigma[i];
      });
  return out;
}

template double strain_energy<2>(const ElementStress<2>&, Index, Index, int);
template double strain_energy<3>(const ElementStress<3>&, Index, Index, int);
template Kokkos::View<double**, Rows, Memory> cauchy_stress<2>(const ElementStress<2>&, Index);
template Kokkos::View<double**, Rows, Memory> cauchy_stress<3>(const ElementStress<3>&, Index);

}  // namespace breccia
