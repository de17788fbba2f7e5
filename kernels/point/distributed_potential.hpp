#pragma once
#include "base/simplex.hpp"
#include "point/simplex_geometry.hpp"

namespace breccia {

/// What part of a face presses into one element by its own potential.
template <int D>
struct DistributedOverlap {
  double depth = 0;  ///< m, mean over the part of the face of H min L, zero outside
  double share = 0;  ///< of the part that lies inside
  double own[D];     ///< weights of the face's nodes at the centre of pressure
  double l[D + 1];   ///< weights of the element's nodes there
};

/// A convex piece of a face, cut smaller by half planes. Places are weights of the face's nodes.
template <int D>
class FacePiece {
 public:
  static constexpr int kMost = D == 2 ? 2 : 8;  ///< four corners, and one more for each cut

  /// The part of a face that contact point q stands for: nearer to node q than to the others.
  KOKKOS_FUNCTION
  static FacePiece part(int q) {
    FacePiece piece;
    if constexpr (D == 2) {
      piece.add(1, 0, q);
      piece.add(0.5, 0.5, q);
    } else {
      piece.add(1, 0, q);
      piece.add(0.5, 0.5, q);
      piece.add(1.0 / 3, 1.0 / 3, q);
      piece.add(0.5, 0, q);
    }
    return piece;
  }

  /// Share of the face that a part has.
  static constexpr double kShare = 1.0 / D;

  /// Keeps where sum_i c_i w_i >= 0.
  KOKKOS_FUNCTION
  void cut(const double (&c)[D]) {
    FacePiece kept;
    if constexpr (D == 2) {
      if (count_ < 2) return;
      const double a = value(c, 0), b = value(c, 1);
      if (a >= 0) kept.copy(*this, 0);
      if ((a < 0) != (b < 0)) kept.between(*this, 0, 1, a, b);
      if (b >= 0) kept.copy(*this, 1);
    } else {
      for (int i = 0; i < count_; ++i) {
        const int j = i + 1 < count_ ? i + 1 : 0;
        const double a = value(c, i), b = value(c, j);
        if (a >= 0) kept.copy(*this, i);
        if ((a < 0) != (b < 0)) kept.between(*this, i, j, a, b);
      }
    }
    *this = kept;
  }

  /// Integrals over a piece as shares of the whole face: of 1, phi and phi w_i.
  struct Sums {
    double area = 0, phi = 0, moment[D] = {};
  };

  /// Adds those of phi = sum_i c_i w_i.
  KOKKOS_FUNCTION
  void integrate(const double (&c)[D], Sums& sums) const {
    if constexpr (D == 2) {
      if (count_ < 2) return;
      const int corner[2] = {0, 1};
      simplex(c, corner, Kokkos::abs(w_[1][1] - w_[0][1]), sums);
    } else {
      for (int i = 1; i + 1 < count_; ++i) {
        const int corner[3] = {0, i, i + 1};
        const double area = (w_[i][1] - w_[0][1]) * (w_[i + 1][2] - w_[0][2]) -
                            (w_[i][2] - w_[0][2]) * (w_[i + 1][1] - w_[0][1]);
        simplex(c, corner, Kokkos::abs(area), sums);
      }
    }
  }

 private:
  /// A corner given by the weights of nodes q, q + 1 and the rest.
  KOKKOS_FUNCTION
  void add(double own, double next, int q) {
    for (int i = 0; i < D; ++i) w_[count_][i] = 0;
    w_[count_][q] = own;
    w_[count_][(q + 1) % D] = next;
    if constexpr (D == 3) w_[count_][(q + 2) % D] = 1 - own - next;
    ++count_;
  }
  KOKKOS_FUNCTION
  void copy(const FacePiece& from, int i) {
    for (int k = 0; k < D; ++k) w_[count_][k] = from.w_[i][k];
    ++count_;
  }
  KOKKOS_FUNCTION
  void between(const FacePiece& from, int i, int j, double a, double b) {
    const double s = a / (a - b);
    for (int k = 0; k < D; ++k) w_[count_][k] = from.w_[i][k] + s * (from.w_[j][k] - from.w_[i][k]);
    ++count_;
  }
  KOKKOS_FUNCTION
  double value(const double (&c)[D], int i) const {
    double v = 0;
    for (int k = 0; k < D; ++k) v += c[k] * w_[i][k];
    return v;
  }
  /// Exact for the product of two linear functions.
  KOKKOS_FUNCTION
  void simplex(const double (&c)[D], const int (&corner)[D], double share, Sums& sums) const {
    double phi = 0, own[D] = {}, both[D] = {};
    for (const int i : corner) {
      const double v = value(c, i);
      phi += v;
      for (int k = 0; k < D; ++k) {
        own[k] += w_[i][k];
        both[k] += v * w_[i][k];
      }
    }
    sums.area += share;
    sums.phi += share * phi / D;
    for (int k = 0; k < D; ++k) sums.moment[k] += share * (phi * own[k] + both[k]) / (D * (D + 1));
  }

  double w_[kMost][D];
  int count_ = 0;
};

/// Munjiza's potential (ALGORITHMS; The Combined Finite-Discrete Element Method, 2004, ch. 2)
/// along part q of a face: each element has a potential of its own, zero on all of its boundary,
/// and presses against the face's normal.
///
// symbols  L_k [1] barycentric coordinates in the element  H [m] its least height  w [1] place on
// the face
// eq:distributed-1   phi = H min_k L_k      inside, else 0
// eq:distributed-2   depth = (1/|part|) int phi dA,  centre = int phi w dA / int phi dA
//
// phi is linear on the pieces where one L_k is the least, so both integrals are exact.
template <int D>
KOKKOS_FUNCTION
DistributedOverlap<D> distributed_overlap(const Vec<D> (&face)[D], int q,
                                          const Vec<D> (&x)[D + 1]) {
  DistributedOverlap<D> r;
  const Mat<D> inverted = inverse(edge_matrix<D>(x));
  double corner[D][D + 1];
  for (int i = 0; i < D; ++i) barycentric(inverted, x[0], face[i], corner[i]);
  for (int k = 0; k <= D; ++k) {
    bool out = true;
    for (int i = 0; i < D; ++i) out = out && corner[i][k] <= 0;
    if (out) return r;
  }
  typename FacePiece<D>::Sums sums;
  for (int k = 0; k <= D; ++k) {
    double c[D];
    for (int i = 0; i < D; ++i) c[i] = corner[i][k];
    FacePiece<D> piece = FacePiece<D>::part(q);
    piece.cut(c);
    for (int j = 0; j <= D; ++j) {
      if (j == k) continue;
      double less[D];
      for (int i = 0; i < D; ++i) less[i] = corner[i][j] - corner[i][k];
      piece.cut(less);
    }
    piece.integrate(c, sums);
  }
  if (!(sums.phi > 0)) return r;
  for (int k = 0; k <= D; ++k) r.l[k] = 0;
  for (int i = 0; i < D; ++i) {
    r.own[i] = sums.moment[i] / sums.phi;
    for (int k = 0; k <= D; ++k) r.l[k] += r.own[i] * corner[i][k];
  }
  double steepest = 0;
  Vec<D> first = Vec<D>::zero();
  for (int k = 1; k <= D; ++k) {
    Vec<D> g;
    for (int d = 0; d < D; ++d) g[d] = inverted(k - 1, d);
    first -= g;
    steepest = Kokkos::max(steepest, norm2(g));
  }
  steepest = Kokkos::max(steepest, norm2(first));
  r.depth = sums.phi / FacePiece<D>::kShare / Kokkos::sqrt(steepest);
  r.share = sums.area / FacePiece<D>::kShare;
  return r;
}

}  // namespace breccia
