#include "loops/node_rest.hpp"

#include "loops/net_force.hpp"

namespace breccia {

template <int D>
NodeBalance node_balance(Index nodes, Index corners, const NodeMotionIn<D>& in,
                         const ChunkSums<1>& rows) {
  NodeBalance balance;
  const NetForce<D> net{in};
  count_launch();
  Kokkos::parallel_reduce(
      "breccia::rest::net_force", Kokkos::RangePolicy<Exec, Kokkos::IndexType<Index>>(0, nodes),
      KOKKOS_LAMBDA(Index n, double& most) {
        Vec<D> free = net(n);
        for (int d = 0; d < D; ++d)
          if ((net.in.flags(n) & net.in.fixed_bits & (1u << d)) != 0) free[d] = 0;
        const double f = norm(free);
        if (!(f <= most)) most = f;
      },
      Kokkos::Max<double>(balance.largest));
  Kokkos::deep_copy(rows, 0.0);
  const AnyCornerForces<D> force = in.element_force;
  for_each_summed<1>(
      "breccia::rest::corner_force", corners, rows, KOKKOS_LAMBDA(Index k, Sums<1> & sum) {
        double square = 0;
        for (int d = 0; d < D; ++d) {
          const double f = force.at(k, d);
          square += f * f;
        }
        sum[0] += Kokkos::sqrt(square);
      });
  balance.corner = total_of(rows)[0] / corners;
  return balance;
}

template <int D>
double kinetic_energy(Index nodes, const Kokkos::View<const double*, Memory>& mass,
                      const ConstVectors<D>& v, const ChunkSums<1>& rows) {
  Kokkos::deep_copy(rows, 0.0);
  for_each_summed<1>(
      "breccia::rest::kinetic", nodes, rows,
      KOKKOS_LAMBDA(Index n, Sums<1> & sum) { sum[0] += 0.5 * mass(n) * norm2(row<D>(v, n)); });
  return total_of(rows)[0];
}

template <int D>
void hold_still(Index nodes, const Vectors<D>& v) {
  for_each(
      "breccia::rest::hold_still", nodes,
      KOKKOS_LAMBDA(Index n) { set_row<D>(v, n, Vec<D>::zero()); });
}

template NodeBalance node_balance<2>(Index, Index, const NodeMotionIn<2>&, const ChunkSums<1>&);
template NodeBalance node_balance<3>(Index, Index, const NodeMotionIn<3>&, const ChunkSums<1>&);
template double kinetic_energy<2>(Index, const Kokkos::View<const double*, Memory>&,
                                  const ConstVectors<2>&, const ChunkSums<1>&);
template double kinetic_energy<3>(Index, const Kokkos::View<const double*, Memory>&,
                                  const ConstVectors<3>&, const ChunkSums<1>&);
template void hold_still<2>(Index, const Vectors<2>&);
template void hold_still<3>(Index, const Vectors<3>&);

}  // namespace breccia
