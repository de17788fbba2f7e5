#include "loops/node_rest.hpp"

namespace breccia {

namespace {

template <int D>
struct NetForce {
  NodeMotionIn<D> in;

  KOKKOS_FUNCTION
  Vec<D> operator()(Index n) const {
    const std::uint32_t flags = in.flags(n);
    const double added = in.added_mass.extent(0) > 0 ? in.added_mass(n) : 0.0;
    Vec<D> f = in.gravity * (in.mass(n) - added);
    for (Index k = in.corners(n, 0); k < in.corners(n, 1); ++k) {
      const auto at = static_cast<std::ptrdiff_t>(in.corner_list(k)) * D;
      for (int d = 0; d < D; ++d) f[d] += in.element_force.data()[at + d];
      for (int c = 0; c < kExtraClasses; ++c) {
        if ((flags & in.extra_bit[c]) == 0) continue;
        for (int d = 0; d < D; ++d) f[d] += in.extra[c].data()[at + d];
      }
    }
    for (int d = 0; d < D; ++d)
      if ((flags & in.fixed_bits & (1u << d)) != 0) f[d] = 0;
    return f;
  }
};

}  // namespace

template <int D>
NodeBalance node_balance(Index nodes, Index corners, const NodeMotionIn<D>& in,
                         const ChunkSums<1>& rows) {
  NodeBalance balance;
  const NetForce<D> net{in};
  count_launch();
  Kokkos::parallel_reduce(
      "breccia::rest::net_force", Kokkos::RangePolicy<Exec, Kokkos::IndexType<Index>>(0, nodes),
      KOKKOS_LAMBDA(Index n, double& most) {
        const double f = norm(net(n));
        if (!(f <= most)) most = f;
      },
      Kokkos::Max<double>(balance.largest));
  Kokkos::deep_copy(rows, 0.0);
  const ConstCornerForces<D> force = in.element_force;
  for_each_summed<1>(
      "breccia::rest::corner_force", corners, rows, KOKKOS_LAMBDA(Index k, Sums<1> & sum) {
        double square = 0;
        for (int d = 0; d < D; ++d) {
          const double f = force.data()[static_cast<std::ptrdiff_t>(k) * D + d];
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
