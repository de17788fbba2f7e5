#include "loops/excavation.hpp"

namespace breccia {

namespace {

template <int D>
struct TakeMass {
  ExcavatedMass<D> in;
  Array<double> mass;
  Vectors<D> v;

  KOKKOS_FUNCTION
  void operator()(Index t, Sums<1>& sum) const {
    const Index end = in.family_corners(in.family(t), 1);
    for (Index k = in.family_corners(in.family(t), 0); k < end;) {
      const Index node = node_at(k);
      double left = 0;
      for (; k < end && node_at(k) == node; ++k)
        left += in.corner_mass(in.corner_list(k) / (D + 1));
      if (in.added_mass.extent(0) > 0) {
        if (left > 0)
          left += in.added_mass(node);
        else
          in.added_mass(node) = 0;
      }
      sum[0] += 0.5 * (mass(node) - left) * norm2(row<D>(v, node));
      mass(node) = left;
      if (!(left > 0)) set_row<D>(v, node, Vec<D>::zero());
    }
  }

 private:
  KOKKOS_FUNCTION
  Index node_at(Index k) const {
    const Index corner = in.corner_list(k);
    return in.nodes(corner / (D + 1), corner % (D + 1));
  }
};

}  // namespace

template <int D>
double take_mass(const ExcavatedMass<D>& in, const Array<double>& mass, const Vectors<D>& v,
                 const ChunkSums<1>& rows) {
  Kokkos::deep_copy(Exec(), rows, 0.0);
  for_each_summed<1>("breccia::excavation::take_mass", static_cast<Index>(in.family.extent(0)),
                     rows, TakeMass<D>{in, mass, v});
  return total_of(rows)[0];
}

template double take_mass<2>(const ExcavatedMass<2>&, const Array<double>&, const Vectors<2>&,
                             const ChunkSums<1>&);
template double take_mass<3>(const ExcavatedMass<3>&, const Array<double>&, const Vectors<3>&,
                             const ChunkSums<1>&);

}  // namespace breccia
