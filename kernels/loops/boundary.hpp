#pragma once
#include "base/simplex.hpp"
#include "base/views.hpp"
#include "point/ramp.hpp"

namespace breccia {

/// One prescribed motion or surface load of the scene.
template <int D>
struct BoundaryLaw {
  Vec<D> value;     ///< m/s, of a motion
  double pressure;  ///< Pa, follows the surface
  Ramp ramp;
};

/// Rows of boundary_velocity: component d follows law `source(row, d)`, or none where negative.
template <int D>
struct BoundaryMotionIn {
  Kokkos::View<const BoundaryLaw<D>*, Memory> law;
  Kokkos::View<const double* [2], Rows, Memory> table;
  Kokkos::View<const Index* [D], Rows, Memory> source;
  double time;
};

template <int D>
void boundary_motion(const BoundaryMotionIn<D>& in, const Vectors<D>& velocity);

/// Loaded faces, gathered by element so that an element's corners have one writer.
template <int D>
struct SurfaceLoadIn {
  ConstVectors<D> x;
  ConstConnectivity<D> nodes;
  Kokkos::View<const BoundaryLaw<D>*, Memory> law;
  Kokkos::View<const double* [2], Rows, Memory> table;
  Kokkos::View<const Index*, Memory> element;  ///< loaded elements
  ConstRanges faces;                           ///< per loaded element: stretch of the lists below
  Kokkos::View<const Index*, Memory> face;     ///< local face
  Kokkos::View<const Index*, Memory> face_law;
  /// Per face: share of its law's value and delay of its course, s (distance from a source).
  ConstVectors<2> reach;
  ConstVectors<D> dead;                       ///< N on the face, of a fixed direction (tractions)
  Kokkos::View<const double*, Memory> share;  ///< of its load that an element carries; empty: all
  double thickness;
  double time;
};

/// Writes the corner forces of all loaded elements. Tractions are per reference area and keep
/// their direction; pressures act on the current area along its current normal.
template <int D>
void surface_load(const SurfaceLoadIn<D>& in, const CornerForces<D>& force);

extern template void boundary_motion<2>(const BoundaryMotionIn<2>&, const Vectors<2>&);
extern template void boundary_motion<3>(const BoundaryMotionIn<3>&, const Vectors<3>&);
extern template void surface_load<2>(const SurfaceLoadIn<2>&, const CornerForces<2>&);
extern template void surface_load<3>(const SurfaceLoadIn<3>&, const CornerForces<3>&);

/// Outward normal times area of a face from its node positions (m, or m2 in space).
KOKKOS_INLINE_FUNCTION
Vec<2> area_vector(const Vec<2> (&x)[2]) {
  const Vec<2> edge = x[1] - x[0];
  return {edge[1], -edge[0]};
}
KOKKOS_INLINE_FUNCTION
Vec<3> area_vector(const Vec<3> (&x)[3]) {
  return cross(x[1] - x[0], x[2] - x[0]) * 0.5;
}

}  // namespace breccia
