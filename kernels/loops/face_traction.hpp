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

}  // namespace breccia
