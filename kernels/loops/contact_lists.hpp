#pragma once
#include "base/views.hpp"
#include "point/contact_potential.hpp"

namespace breccia {

/// Contact points on one face, one for each of its nodes.
template <int D>
inline constexpr int kFacePoints = D;

/// Pieces of material that a contact point remembers at the same time.
inline constexpr int kContactSlots = 2;

/// Weight of a contact point's own node. `gauss`: the Gauss points of a segment, or the three of a
/// triangle that integrate second order. `corners`: the nodes themselves. Any such points integrate
/// what is linear exactly.
template <int D>
struct PointWeight {
  static constexpr double gauss = D == 2 ? 0.78867513459481288225 : 2.0 / 3;  // (1 + 3^-1/2) / 2
  static constexpr double corners = 1;
};

/// Weight of face node i at contact point q of the face.
template <int D>
KOKKOS_INLINE_FUNCTION
constexpr double face_weight(int q, int i, double own) {
  return q == i ? own : (1 - own) / (D - 1);
}

/// Numbers per corner of the elements, in rows: (element, corner).
template <int D>
using CornerNumbers = Kokkos::View<double * [D + 1], Rows, Memory>;
template <int D>
using CornerIndices = Kokkos::View<Index * [D + 1], Rows, Memory>;
/// (element, corner, component).
template <int D>
using CornerVectors = Kokkos::View<double * [D + 1][D], Rows, Memory>;
template <int D>
using ChordNumbers = Kokkos::View<double * [kChords<D>], Rows, Memory>;
template <int D>
using FaceNumbers = Kokkos::View<double* [D], Rows, Memory>;
template <int D>
using FaceIndices = Kokkos::View<Index* [D], Rows, Memory>;

/// Free and released faces, and the elements behind them. A facet is element * (D + 1) + local
/// face.
template <int D>
struct ContactSurface {
  Index facets = 0, targets = 0;
  double own_weight = PointWeight<D>::gauss;  ///< of the contact points
  Array<Index> facet;                         ///< ascending
  Array<Index> facet_target;                  ///< place of its element among the targets
  Array<double> area;       ///< m2 of the reference face (length times thickness in the plane)
  Array<double> height;     ///< m, mean of volume / area of the elements at the face
  Array<Index> target;      ///< elements near the surface, ascending
  Array<std::uint8_t> rim;  ///< 1 where deeper elements exist that are no targets
  Array<Index> piece;       ///< of a target that cannot touch its own piece; else kNone
  CornerIndices<D> nodes;   ///< of the targets; anew after nodes split
  CornerVectors<D> place;   ///< where the targets' nodes were at the last search, m
  CornerNumbers<D> depth;   ///< phi at the nodes, m
  ChordNumbers<D> bubble;   ///< see point/contact_potential.hpp
  Kokkos::View<double * [D + 1][D], Rows, Memory> slope;
};

/// The nodes of all targets, each once, as they were at the last search.
template <int D>
struct ContactNodes {
  Index count = 0;
  Array<Index> node;
  Array<std::uint8_t> mark;  ///< per node, scratch
  Vectors<D> place;          ///< per node, m
};

/// Contact points that are near a target, their candidate pairs, and what adds up on an element.
template <int D>
struct ContactPairs {
  Index points = 0, pairs = 0, elements = 0;
  Array<Index> point;       ///< facet * kFacePoints + q, ascending
  Array<Index> facet;       ///< place of its face among the facets
  Array<Index> pair_begin;  ///< points + 1
  Array<Index> target;      ///< per pair, ascending for each point
  Array<Index> own_begin;   ///< per target + 1: points on its faces
  Array<Index> come_begin;  ///< per target + 1: pairs that may push it
  Array<Index> come;        ///< pairs, ascending for each target
  Array<Index> element;     ///< targets with either, ascending
  FaceIndices<D> nodes;     ///< of the points' faces; anew after nodes split

  Array<double> pair_distance;  ///< square of it, m2: scratch of the stable step

  // What the force loop leaves for the gather; scratch of the stable step in between.
  Array<std::uint8_t> hit;                             ///< per pair
  Kokkos::View<double* [D], Rows, Memory> pair_force;  ///< N on the contactor
  CornerNumbers<D> pair_weight;                        ///< barycentric coordinates in the target
  FaceNumbers<D> pair_own;  ///< and in the face, for the distributed potential only
  Kokkos::View<double* [D], Rows, Memory> point_force;  ///< N, all pairs of the point
};

}  // namespace breccia
