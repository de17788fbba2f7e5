#include "loops/interface_breaks.hpp"

#include "loops/compact.hpp"
#include "point/interface_frame.hpp"

namespace breccia {

namespace {

constexpr std::uint8_t kInserted = 1, kReleased = 2;  // fields/common_fields.hpp

template <int D>
struct ReleaseLoop {
  InterfaceBreaks<D> in;
  Array<Index> broken;
  ConstConnectivity<D> nodes;
  ConstVectors<D> x;
  ConstCornerStates<D> state;
  PairForces<D> slip;
  CornerRubbed<D> rubbed;

  KOKKOS_FUNCTION
  void operator()(Index k) const {
    const Index i = broken(k), face = in.map.record(i).face;
    in.status(face) = kReleased;
    if (slip.extent(0) == 0) return;
    Vec<D> middle[D];
    for (int c = 0; c < D; ++c)
      middle[c] = (face_point(in.map.faces, nodes, x, face, 0, c) +
                   face_point(in.map.faces, nodes, x, face, 1, c)) *
                  0.5;
    const InterfaceFrame<D> frame = frame_of(middle);
    for (int c = 0; c < D; ++c) {
      const CohesiveState<D>& s = state(i, c);
      Vec<D> xi = s.jump;
      xi[0] = 0;
      for (int d = 1; d < D; ++d) xi[d] -= s.plastic[d - 1];
      xi = frame.to_global(xi);
      for (int d = 0; d < D; ++d) slip(i, c, d) = xi[d];
      if (rubbed.extent(0) > 0) rubbed(i, c, 0) = s.slip;
    }
  }
};

}  // namespace

template <int D>
Index InterfaceBreaks<D>::find(const Array<Index>& broken) const {
  const InterfaceMap<D> m = map;
  const Array<std::uint8_t> of_face = status;
  return scan(
      "breccia::fracture::breaks", count, KOKKOS_LAMBDA(Index i, Index & at, bool last) {
        if (m.life(i) == interface_life::acting || of_face(m.record(i).face) != kInserted) return;
        if (last) broken(at) = i;
        ++at;
      });
}

template <int D>
Index InterfaceBreaks<D>::keep_own(const Array<Index>& broken, Index n,
                                   const ConstArray<std::uint8_t>& own,
                                   const Array<Index>& counted) const {
  const InterfaceMap<D> m = map;
  return scan(
      "breccia::fracture::own_breaks", n, KOKKOS_LAMBDA(Index k, Index & at, bool last) {
        if (own(m.faces.elements(m.record(broken(k)).face, 0)) == 0) return;
        if (last) counted(at) = broken(k);
        ++at;
      });
}

template <int D>
Index InterfaceBreaks<D>::leaving() const {
  const InterfaceMap<D> m = map;
  return scan(
      "breccia::fracture::leaving", count, KOKKOS_LAMBDA(Index i, Index & n, bool) {
        if (m.life(i) == interface_life::leaving) ++n;
      });
}

template <int D>
void InterfaceBreaks<D>::release(const Array<Index>& broken, Index n,
                                 const ConstConnectivity<D>& nodes, const ConstVectors<D>& x,
                                 const ConstCornerStates<D>& state, const PairForces<D>& slip,
                                 const CornerRubbed<D>& rubbed) const {
  for_each("breccia::fracture::release", n,
           ReleaseLoop<D>{*this, broken, nodes, x, state, slip, rubbed});
}

template <int D>
void retire_interfaces(Index count, const RetireIn<D>& in) {
  for_each(
      "breccia::fracture::retire", count, KOKKOS_LAMBDA(Index i) {
        if (in.life(i) != interface_life::leaving) return;
        in.life(i) = interface_life::gone;
        for (int c = 0; c < D; ++c) {
          for (int d = 0; d < D; ++d) in.force(i, c, d) = 0;
          const Index face = in.record(i).face;
          for (const auto& at : {in.faces.left(face, c), in.faces.right(face, c)})
            raise(in.touched, in.family(in.nodes(at.element, at.node)));
        }
      });
}

template struct InterfaceBreaks<2>;
template struct InterfaceBreaks<3>;
template void retire_interfaces<2>(Index, const RetireIn<2>&);
template void retire_interfaces<3>(Index, const RetireIn<3>&);

}  // namespace breccia
