#pragma once
#include "loops/element_stress.hpp"
#include "loops/interface_views.hpp"
#include "point/interface_frame.hpp"

namespace breccia {

template <int D>
struct FaceTraction {
  Vec<D> traction;  ///< (sigma_L + sigma_R) n / 2, Pa
  Vec<D> normal;    ///< from left to right, in the current configuration
};

/// Mean traction on a face that is still whole (ALGORITHMS ).
template <int D>
KOKKOS_FUNCTION
FaceTraction<D> face_traction(const FaceMap<D>& faces, const ElementStress<D>& stress, Index face) {
  Vec<D> x[D];
  for (int c = 0; c < D; ++c) {
    const auto at = faces.left(face, c);
    x[c] = row<D>(stress.x, stress.nodes(at.element, at.node));
  }
  const Vec<D> n = frame_of(x).normal();
  const Sym<D> sum =
      stress.cauchy(faces.elements(face, 0)) + stress.cauchy(faces.elements(face, 1));
  return {(sum * 0.5) * n, n};
}

/// Rate of deformation on a face, |d n| with the mean d of both elements, 1/s: the rate of
/// stretching of what opens, half the rate of shear of what slides.
template <int D>
KOKKOS_FUNCTION
double face_rate(const FaceMap<D>& faces, const ElementStress<D>& stress,
                 const ConstVectors<D>& velocity, Index face) {
  Vec<D> corner[D];
  for (int c = 0; c < D; ++c) {
    const auto at = faces.left(face, c);
    corner[c] = row<D>(stress.x, stress.nodes(at.element, at.node));
  }
  const Vec<D> n = frame_of(corner).normal();
  Vec<D> sum = Vec<D>::zero();
  for (int side = 0; side < 2; ++side) {
    const Index e = faces.elements(face, side);
    Vec<D> x[D + 1], v[D + 1];
    gather(stress.nodes, stress.x, e, e, x);
    gather(stress.nodes, velocity, e, e, v);
    const Mat<D> gradient = edges<D, double>(v) * inverse(edges<D, double>(x));
    sum += symmetric_part(gradient) * n;
  }
  return 0.5 * norm(sum);
}

/// What the rate makes of the strengths of a face, as a share of those at rest.
template <int D>
KOKKOS_FUNCTION
double dynamic_share(const FaceMap<D>& faces, const ElementStress<D>& stress,
                     const ConstVectors<D>& velocity, Index face, const CohesiveOnset& onset) {
  return onset.rate_reference > 0 ? onset.dynamic_share(face_rate(faces, stress, velocity, face))
                                  : 1.0;
}

}  // namespace breccia
