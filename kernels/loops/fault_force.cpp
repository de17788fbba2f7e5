#include "loops/fault_force.hpp"

#include "loops/compact.hpp"
#include "point/interface_frame.hpp"

namespace breccia {

namespace {

template <int D>
struct FaultForceLoop {
  InterfaceForceIn<D> in;
  FrictionLaw friction;
  FaultForceOut<D> out;

  KOKKOS_FUNCTION
  void operator()(Index k, Index& aged) const {
    const Index i = in.list(k);
    if (out.life(i) == interface_life::gone) return;
    const InterfaceRecord& record = in.record(i);
    const InterfaceGap<D> gap(in, i);
    const InterfaceFrame<D> frame = frame_of(gap.middle);
    const Fault<D> law{friction, record.springs};

    for (int c = 0; c < D; ++c) {
      if (in.active(i, c) == 0) continue;
      const Vec<D> t =
          law.advance(out.fault(i, c), frame.to_local(gap.jump[c]), in.rate, out.energy(i, c));
      const Vec<D> force = frame.to_global(t) * (record.area / D);
      for (int d = 0; d < D; ++d) out.force(i, c, d) = force[d];
    }
    if (in.knows(record.face)) aged += leave(i, law, gap, record.area);
  }

 private:
  KOKKOS_FUNCTION
  Index leave(Index i, const Fault<D>& law, const InterfaceGap<D>& gap, double area) const {
    constexpr double kShare = 0.5;
    if (!gap.wider_than(in.leave_broken ? kShare : 1.0, area, in.thickness) ||
        out.life(i) >= interface_life::leaving)
      return 0;
    for (int c = 0; c < D; ++c) {
      const FaultState<D>& s = out.fault(i, c);
      const Vec<D - 1> tau = law.shear(s);
      out.state(i, c).jump = s.jump;
      for (int d = 0; d < D - 1; ++d)
        out.state(i, c).plastic[d] = s.jump[d + 1] - tau[d] / law.springs.shear;
      if (out.rubbed.extent(0) == 0) continue;
      out.state(i, c).slip = s.slip;
      out.rubbed(i, c, 1) = s.rate;
      out.rubbed(i, c, 2) = s.theta;
    }
    out.life(i) = interface_life::leaving;
    return 1;
  }
};

}  // namespace

template <int D>
Index fault_force(const InterfaceForceIn<D>& in, const FrictionLaw& friction,
                  const FaultForceOut<D>& out) {
  Index aged = 0;
  if (in.count <= 0) return aged;
  count_launch();
  Kokkos::parallel_reduce("breccia::fracture::fault_force",
                          Kokkos::RangePolicy<Exec, Kokkos::IndexType<Index>>(0, in.count),
                          FaultForceLoop<D>{in, friction, out}, aged);
  return aged;
}

template Index fault_force<2>(const InterfaceForceIn<2>&, const FrictionLaw&,
                              const FaultForceOut<2>&);
template Index fault_force<3>(const InterfaceForceIn<3>&, const FrictionLaw&,
                              const FaultForceOut<3>&);

}  // namespace breccia
