#include "loops/interface_force.hpp"

#include "point/interface_frame.hpp"

namespace breccia {

namespace {

template <int D, class Softening>
struct InterfaceForceLoop {
  InterfaceForceIn<D> in;
  InterfaceForceOut<D> out;

  KOKKOS_FUNCTION
  void operator()(Index k) const {
    const Index i = in.list(k);
    const InterfaceRecord& record = in.record(i);
    Vec<D> middle[D], jump[D];
    for (int c = 0; c < D; ++c) {
      const Vec<D> l = row<D>(in.x, in.nodes(k, 0, c)), r = row<D>(in.x, in.nodes(k, 1, c));
      middle[c] = (l + r) * 0.5;
      jump[c] = r - l;
    }
    const InterfaceFrame<D> frame = frame_of(middle);
    const Cohesive<D, Softening> law{in.strength, record.springs};

    bool broken = true;
    double nearest = 1e300;
    for (int c = 0; c < D; ++c) {
      nearest = Kokkos::min(nearest, norm2(jump[c]));
      if (in.active(i, c) == 0) {
        broken = false;
        continue;
      }
      const auto r = law.respond(out.state(i, c), frame.to_local(jump[c]), in.rate);
      const Vec<D> force = frame.to_global(r.traction) * (record.area / D);
      for (int d = 0; d < D; ++d) out.force(i, c, d) = force[d];
      broken = broken && r.next.damage >= 1;
      out.state(i, c) = r.next;
      add(out.energy(i, c), r.spent);
    }
    if (broken) age(i, nearest, record.area);
  }

 private:
  KOKKOS_FUNCTION
  static void add(CornerEnergy& energy, const CohesiveSpent& spent) {
    energy.tension += spent.tension;
    energy.shear += spent.shear;
    energy.friction += spent.friction;
    energy.viscous += spent.viscous;
  }

  /// A broken pair is done when contact takes it over, or when its corners are a face apart.
  KOKKOS_FUNCTION
  void age(Index i, double nearest, double area) const {
    const double length = D == 2 ? area / in.thickness : Kokkos::sqrt(2 * area);
    const bool apart = nearest > length * length;
    const std::uint8_t next =
        in.leave_broken || apart ? interface_life::leaving : interface_life::broken;
    if (out.life(i) < next) out.life(i) = next;
  }
};

}  // namespace

template <int D, class Softening>
void interface_force(const InterfaceForceIn<D>& in, const InterfaceForceOut<D>& out) {
  for_each("breccia::fracture::interface_force", in.begin, in.end,
           InterfaceForceLoop<D, Softening>{in, out});
}

template void interface_force<2, LinearSoftening>(const InterfaceForceIn<2>&,
                                                  const InterfaceForceOut<2>&);
template void interface_force<3, LinearSoftening>(const InterfaceForceIn<3>&,
                                                  const InterfaceForceOut<3>&);
template void interface_force<2, ZCurve>(const InterfaceForceIn<2>&, const InterfaceForceOut<2>&);
template void interface_force<3, ZCurve>(const InterfaceForceIn<3>&, const InterfaceForceOut<3>&);

}  // namespace breccia
