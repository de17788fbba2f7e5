#include "loops/interface_books.hpp"

namespace breccia {

namespace {

template <int D>
struct BookLoop {
  InterfaceMap<D> map;
  ConstPairForces<D> pair;
  ConstArray<Index> elements;
  CornerForces<D> force;

  KOKKOS_FUNCTION
  void operator()(Index k) const {
    const Index e = elements(k);
    Vec<D> sum[D + 1];
    for (int a = 0; a <= D; ++a) sum[a] = Vec<D>::zero();
    for (int f = 0; f <= D; ++f) {
      const Index i = map.at(e, f);
      if (i == kNone) continue;
      const Index face = map.faces.of_element(e, f);
      const bool is_left = map.faces.elements(face, 0) == e;
      for (int c = 0; c < D; ++c) {
        const auto corner = is_left ? map.faces.left(face, c) : map.faces.right(face, c);
        for (int d = 0; d < D; ++d) sum[corner.node][d] += is_left ? pair(i, c, d) : -pair(i, c, d);
      }
    }
    for (int a = 0; a <= D; ++a)
      for (int d = 0; d < D; ++d) force(e, a, d) = sum[a][d];
  }
};

template <int D>
struct StiffnessLoop {
  InterfaceMap<D> map;
  ConstRanges corners;
  ConstArray<Index> corner_list;
  ConstArray<std::uint32_t> flags;
  std::uint32_t bits;
  Array<double> stiffness;

  KOKKOS_FUNCTION
  void operator()(Index n) const {
    if ((flags(n) & bits) == 0) return;
    double sum = 0;
    for (Index k = corners(n, 0); k < corners(n, 1); ++k) {
      const Index e = corner_list(k) / (D + 1);
      const int a = static_cast<int>(corner_list(k) % (D + 1));
      for (int f = 0; f <= D; ++f)
        if (f != a) sum += spring_at(e, f, a);
    }
    stiffness(n) += 2 * sum;
  }

 private:
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
  ConstCornerEnergies<D> energy;
  ConstArray<std::uint8_t> z_curve;

  KOKKOS_FUNCTION
  void operator()(Index i, Sums<6>& sum) const {
    const InterfaceRecord& r = map.record(i);
    const double area = r.area / D;
    for (int c = 0; c < D; ++c) {
      if (map.active(i, c) == 0) continue;
      const CornerEnergy& e = energy(i, c);
      const double stored = map.life(i) == interface_life::gone ? 0.0 : stored_at(r, state(i, c));
      sum[0] += area * (stored - e.encoded);
      sum[1] += area * e.tension;
      sum[2] += area * e.shear;
      sum[3] += area * e.friction;
      sum[4] += area * e.viscous;
    }
    if (map.life(i) != interface_life::acting) sum[5] += r.area;
  }

 private:
  KOKKOS_FUNCTION
  double stored_at(const InterfaceRecord& r, const CohesiveState<D>& s) const {
    if (z_curve(r.law) != 0) return Cohesive<D, ZCurve>{{}, r.springs}.stored(s);
    return Cohesive<D, LinearSoftening>{{}, r.springs}.stored(s);
  }
};

}  // namespace

template <int D>
void InterfaceBooks<D>::forces(const ConstPairForces<D>& pair, const ConstArray<Index>& elements,
                               Index count, const CornerForces<D>& force) const {
  for_each("breccia::fracture::book_forces", count, BookLoop<D>{map, pair, elements, force});
}

template <int D>
void InterfaceBooks<D>::stiffness(Index nodes, const ConstRanges& corners,
                                  const ConstArray<Index>& corner_list,
                                  const ConstArray<std::uint32_t>& flags, std::uint32_t bits,
                                  const Array<double>& stiffness) const {
  for_each("breccia::fracture::stiffness", nodes,
           StiffnessLoop<D>{map, corners, corner_list, flags, bits, stiffness});
}

template <int D>
InterfaceSums InterfaceBooks<D>::energies(const ConstCornerStates<D>& state,
                                          const ConstCornerEnergies<D>& energy,
                                          const ConstArray<std::uint8_t>& z_curve,
                                          Index count) const {
  const ChunkSums<6> rows("breccia::fracture::energies", chunks_of(count));
  for_each_summed<6>("breccia::fracture::energies", count, rows,
                     EnergyLoop<D>{map, state, energy, z_curve});
  const Sums<6> s = total_of(rows);
  return {s[0], s[1], s[2], s[3], s[4], s[5]};
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

template struct InterfaceBooks<2>;
template struct InterfaceBooks<3>;
template void clear_corner_forces<2>(const ConstArray<Index>&, Index, const CornerForces<2>&);
template void clear_corner_forces<3>(const ConstArray<Index>&, Index, const CornerForces<3>&);

}  // namespace breccia
