#include "loops/interface_books.hpp"

namespace breccia {

namespace {

template <int D>
struct StiffnessLoop {
  InterfaceMap<D> map;
  ConstArray<Index> families;
  ConstRanges family_corners;
  ConstArray<Index> corner_list;
  ConstConnectivity<D> nodes;
  Array<double> stiffness;

  /// The corners of a node lie side by side in the list.
  KOKKOS_FUNCTION
  void operator()(Index t) const {
    const Index end = family_corners(families(t), 1);
    for (Index k = family_corners(families(t), 0); k < end;) {
      const Index node = node_at(k);
      double sum = 0;
      for (; k < end && node_at(k) == node; ++k) {
        const Index e = corner_list(k) / (D + 1);
        const int a = static_cast<int>(corner_list(k) % (D + 1));
        for (int f = 0; f <= D; ++f)
          if (f != a) sum += spring_at(e, f, a);
      }
      stiffness(node) = 2 * sum;
    }
  }

 private:
  KOKKOS_FUNCTION
  Index node_at(Index k) const {
    const Index corner = corner_list(k);
    return nodes(corner / (D + 1), static_cast<int>(corner % (D + 1)));
  }

  KOKKOS_FUNCTION
  double spring_at(Index e, int f, int a) const {
    const Index i = map.at(e, f);
    if (i == kNone) return 0;
    const int c = map.faces.corner_at(map.faces.of_element(e, f), e, a);
    if (map.active(i, c) == 0) return 0;
    const InterfaceRecord& r = map.record(i);
    return Kokkos::max(r.springs.normal, r.springs.shear) * r.area / D;
  }
};

template <int D>
struct EnergyLoop {
  InterfaceMap<D> map;
  ConstCornerStates<D> state;
  ConstFaultStates<D> fault;
  ConstCornerEnergies<D> energy;
  ConstArray<std::uint8_t> kind, own;

  KOKKOS_FUNCTION
  void operator()(Index i, Sums<7>& sum) const {
    const InterfaceRecord& r = map.record(i);
    if (own.extent(0) > 0 && own(map.faces.elements(r.face, 0)) == 0) return;
    sum[6] += 1;
    const double area = r.area / D;
    for (int c = 0; c < D; ++c) {
      if (map.active(i, c) == 0) continue;
      const CornerEnergy& e = energy(i, c);
      const double stored = map.life(i) == interface_life::gone ? 0.0 : stored_at(r, i, c);
      sum[0] += area * (stored - e.encoded);
      sum[1] += area * e.tension;
      sum[2] += area * e.shear;
      sum[3] += area * e.friction;
      sum[4] += area * e.viscous;
    }
    if (map.life(i) != interface_life::acting && kind(r.law) != law_kind::fault) sum[5] += r.area;
  }

 private:
  KOKKOS_FUNCTION
  double stored_at(const InterfaceRecord& r, Index i, int c) const {
    const std::uint8_t k = kind(r.law);
    if (k == law_kind::fault) return Fault<D>{{}, r.springs}.stored(fault(i, c));
    if (k == law_kind::z_curve) return Cohesive<D, ZCurve>{{}, r.springs}.stored(state(i, c));
    return Cohesive<D, LinearSoftening>{{}, r.springs}.stored(state(i, c));
  }
};

}  // namespace

template <int D>
void InterfaceBooks<D>::stiffness(const ConstArray<Index>& families, Index count,
                                  const ConstRanges& family_corners,
                                  const ConstArray<Index>& corner_list,
                                  const ConstConnectivity<D>& nodes,
                                  const Array<double>& stiffness) const {
  for_each("breccia::fracture::stiffness", count,
           StiffnessLoop<D>{map, families, family_corners, corner_list, nodes, stiffness});
}

template <int D>
InterfaceSums InterfaceBooks<D>::energies(const ConstCornerStates<D>& state,
                                          const ConstFaultStates<D>& fault,
                                          const ConstCornerEnergies<D>& energy,
                                          const ConstArray<std::uint8_t>& kind,
                                          const ConstArray<std::uint8_t>& own, Index count) const {
  const ChunkSums<7> rows("breccia::fracture::energies", chunks_of(count));
  for_each_summed<7>("breccia::fracture::energies", count, rows,
                     EnergyLoop<D>{map, state, fault, energy, kind, own});
  const Sums<7> s = total_of(rows);
  return {s[0], s[1], s[2], s[3], s[4], s[5], s[6]};
}

template struct InterfaceBooks<2>;
template struct InterfaceBooks<3>;

}  // namespace breccia
