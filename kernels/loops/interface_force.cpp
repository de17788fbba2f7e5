#include "loops/interface_force.hpp"

#include "loops/compact.hpp"
#include "point/interface_frame.hpp"

namespace breccia {

namespace {

template <int D, class Softening>
struct InterfaceForceLoop {
  InterfaceForceIn<D> in;
  InterfaceForceOut<D> out;

  KOKKOS_FUNCTION
  void operator()(Index k, Index& aged) const {
    const Index i = in.list(k);
    KOKKOS_IF_ON_HOST((fetch_ahead(k + kAhead);))
    if (out.life(i) == interface_life::gone) return;
    const InterfaceRecord& record = in.record(i);
    const InterfaceGap<D> gap(in, i);
    const InterfaceFrame<D> frame = frame_of(gap.middle);
    const Cohesive<D, Softening> law{in.strength, record.springs};

    bool broken = true;
    for (int c = 0; c < D; ++c) {
      if (in.active(i, c) == 0) {
        broken = false;
        continue;
      }
      CohesiveState<D>& state = out.state(i, c);
      const Vec<D> t = law.advance(state, frame.to_local(gap.jump[c]), in.rate, out.energy(i, c));
      const Vec<D> force = frame.to_global(t) * (record.area / D);
      for (int d = 0; d < D; ++d) out.force(i, c, d) = force[d];
      broken = broken && state.damage >= 1;
    }
    if (broken && in.knows(record.face)) aged += age(i, gap, record.area);
  }

 private:
  static constexpr Index kAhead = 8;

  /// Asks for the state of a later interface and for the places of its nodes.
  KOKKOS_FORCEINLINE_FUNCTION
  void fetch_ahead(Index k) const {
    if (k >= in.count) return;
    const Index i = in.list(k);
    constexpr int kLine = 64;
    const char* state = reinterpret_cast<const char*>(&out.state(i, 0));
    for (std::size_t at = 0; at < D * sizeof(CohesiveState<D>); at += kLine) fetch(state + at);
    fetch(&in.record(i));
    fetch(&out.energy(i, 0));
    fetch(&out.energy(i, D - 1));
    fetch(&out.force(i, 0, 0));
    for (int c = 0; c < D; ++c) {
      fetch(&in.x(in.nodes(i, 0, c), 0));
      fetch(&in.x(in.nodes(i, 1, c), 0));
    }
  }

  /// A broken pair is done when contact takes it over, or when its corners are a face apart. 1
  /// where its life changes.
  KOKKOS_FUNCTION
  Index age(Index i, const InterfaceGap<D>& gap, double area) const {
    const bool apart = gap.wider_than(1, area, in.thickness);
    const std::uint8_t next =
        in.leave_broken || apart ? interface_life::leaving : interface_life::broken;
    if (out.life(i) >= next) return 0;
    out.life(i) = next;
    return 1;
  }
};

}  // namespace

template <int D, class Softening>
Index interface_force(const InterfaceForceIn<D>& in, const InterfaceForceOut<D>& out) {
  Index aged = 0;
  if (in.count <= 0) return aged;
  count_launch();
  Kokkos::parallel_reduce("breccia::fracture::interface_force",
                          Kokkos::RangePolicy<Exec, Kokkos::IndexType<Index>>(0, in.count),
                          InterfaceForceLoop<D, Softening>{in, out}, aged);
  return aged;
}

template Index interface_force<2, LinearSoftening>(const InterfaceForceIn<2>&,
                                                   const InterfaceForceOut<2>&);
template Index interface_force<3, LinearSoftening>(const InterfaceForceIn<3>&,
                                                   const InterfaceForceOut<3>&);
template Index interface_force<2, ZCurve>(const InterfaceForceIn<2>&, const InterfaceForceOut<2>&);
template Index interface_force<3, ZCurve>(const InterfaceForceIn<3>&, const InterfaceForceOut<3>&);

}  // namespace breccia
