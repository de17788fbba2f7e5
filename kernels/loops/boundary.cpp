#include "loops/boundary.hpp"

namespace breccia {

template <int D>
void boundary_motion(const BoundaryMotionIn<D>& in, const Vectors<D>& velocity) {
  for_each(
      "breccia::boundary::motion", static_cast<Index>(in.source.extent(0)),
      KOKKOS_LAMBDA(Index row) {
        for (int d = 0; d < D; ++d) {
          const Index i = in.source(row, d);
          velocity(row, d) =
              i < 0 ? 0.0 : in.law(i).value[d] * in.law(i).ramp.factor(in.time, in.table);
        }
      });
}

template <int D>
void surface_load(const SurfaceLoadIn<D>& in, const CornerForces<D>& force) {
  for_each(
      "breccia::boundary::surface_load", static_cast<Index>(in.element.extent(0)),
      KOKKOS_LAMBDA(Index i) {
        const Index e = in.element(i);
        Vec<D> f[D + 1];
        for (int a = 0; a <= D; ++a) f[a] = Vec<D>::zero();
        for (Index k = in.faces(i, 0); k < in.faces(i, 1); ++k) {
          const BoundaryLaw<D>& law = in.law(in.face_law(k));
          Vec<D> x[D];
          for (int j = 0; j < D; ++j) x[j] = row<D>(in.x, in.nodes(e, face_node<D>(in.face(k), j)));
          const double factor =
              in.reach(k, 0) * law.ramp.factor(in.time - in.reach(k, 1), in.table) / D;
          const Vec<D> share =
              (row<D>(in.dead, k) - area_vector(x) * (law.pressure * in.thickness)) * factor;
          for (int j = 0; j < D; ++j) f[face_node<D>(in.face(k), j)] += share;
        }
        const double carried = in.share.extent(0) > 0 ? in.share(e) : 1.0;
        for (int a = 0; a <= D; ++a)
          for (int d = 0; d < D; ++d) force(e, a, d) = carried * f[a][d];
      });
}

template void boundary_motion<2>(const BoundaryMotionIn<2>&, const Vectors<2>&);
template void boundary_motion<3>(const BoundaryMotionIn<3>&, const Vectors<3>&);
template void surface_load<2>(const SurfaceLoadIn<2>&, const CornerForces<2>&);
template void surface_load<3>(const SurfaceLoadIn<3>&, const CornerForces<3>&);

}  // namespace breccia
