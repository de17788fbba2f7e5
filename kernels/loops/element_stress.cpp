#include "loops/element_stress.hpp"

#include "loops/element_group.hpp"

namespace breccia {

namespace {

/// Groups first, first + 1, ... of a pack.
template <int D, int Group>
struct StrainEnergy {
  using R = Pack;
  static constexpr int W = lanes<R>();

  ElementStress<D> in;
  Index begin, groups;

  KOKKOS_FUNCTION
  void operator()(Index first, Sums<1>& sum) const {
    const GroupLanes<Group, R> lanes{begin, first, groups, in.own.data()};
    Vec<D, R> x[kGroupNodes<D, Group>];
    lanes.template gather<D>(in.nodes, in.x, x);
    FullSym<D, R> eps[Group];
    R volume[Group], jacobian[Group], now = R(0), original = R(0);
    for (int s = 0; s < Group; ++s) {
      Mat<D, R> reference;
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) reference(i, j) = lanes.read(in.reference, s, i, j);
      const Mat<D, R> f = sub_edges<D, Group, R>(x, s) * reference;
      jacobian[s] = determinant(f);
      eps[s] = {hencky_strain(left_cauchy_green(f), jacobian[s]), R(0)};
      volume[s] = R(in.thickness / kFactorial<D>) / determinant(reference);
      original = original + volume[s];
      now = now + volume[s] * jacobian[s];
    }
    const HenckyElastic law = in.law(begin);
    R energy = R(0);
    for (int s = 0; s < Group; ++s) {
      if (Group > 1 && !in.flat)
        eps[s].add_identity((log_near_one(now / original) - log_near_one(jacobian[s])) *
                            R(1.0 / 3));
      const R carried = in.share.extent(0) > 0 ? lanes.read(in.share, s) : R(1);
      energy =
          energy + R(0.5) * contract(isotropic(law, eps[s], in.flat), eps[s]) * volume[s] * carried;
    }
    double e[W];
    store(energy, e);
    for (int l = 0; l < lanes.count(); ++l)
      if (lanes.counts(l)) sum[0] += e[l];
  }
};

/// Sums of whole chunks of groups, the same for any width of a pack.
template <int D, int Group>
double add_up(const ElementStress<D>& stress, Index begin, Index end) {
  using Loop = StrainEnergy<D, Group>;
  const Index groups = (end - begin) / Group;
  const Loop loop{stress, begin, groups};
  const ChunkSums<1> rows("breccia::solid::strain_energy", chunks_of(groups));
  if constexpr (kOnDevice) {
    for_each_summed<1>("breccia::solid::strain_energy", groups, rows, loop);
  } else {
    static_assert(kChunk % Loop::W == 0);
    count_launch();
    Kokkos::parallel_for(
        "breccia::solid::strain_energy",
        Kokkos::RangePolicy<Exec, Kokkos::IndexType<Index>>(0, chunks_of(groups)),
        KOKKOS_LAMBDA(Index chunk) {
          const Index from = chunk * kChunk, to = from + kChunk < groups ? from + kChunk : groups;
          Sums<1> sum;
          for (Index first = from; first < to; first += Loop::W) loop(first, sum);
          rows(chunk, 0) = sum[0];
        });
  }
  return total_of(rows)[0];
}

}  // namespace

template <int D>
double strain_energy(const ElementStress<D>& stress, Index begin, Index end, int group) {
  if (end <= begin) return 0;
  if (group == 1) return add_up<D, 1>(stress, begin, end);
  if constexpr (D == 2)
    return add_up<2, 4>(stress, begin, end);
  else
    return group == 8 ? add_up<3, 8>(stress, begin, end) : add_up<3, 12>(stress, begin, end);
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
