// The potential that each element has of its own, integrated along parts of faces.
#include "point/distributed_potential.hpp"

#include "core/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace breccia {
namespace {

template <int D>
struct Sample {
  Vec<D> face[D], x[D + 1];
};

/// A face and an element of about the same size that mostly overlap.
template <int D>
Sample<D> random_sample(std::uint64_t seed) {
  const Random random{seed, 77};
  Sample<D> s;
  std::uint32_t draw = 0;
  const auto number = [&] { return 2 * random.uniform(seed, draw++) - 1; };
  for (auto& p : s.face)
    for (int d = 0; d < D; ++d) p[d] = number();
  do {
    for (auto& p : s.x)
      for (int d = 0; d < D; ++d) p[d] = 1.5 * number();
  } while (determinant(edge_matrix<D>(s.x)) < 0.5);
  return s;
}

template <int D>
double potential(const Sample<D>& s, const Mat<D>& inverted, const Vec<D>& at) {
  double l[D + 1];
  barycentric(inverted, s.x[0], at, l);
  return std::max(0.0, *std::min_element(l, l + D + 1));
}

/// Midpoint rule over the whole face: integral of min L and of its places, as shares of the face.
template <int D>
DistributedOverlap<D> by_midpoints(const Sample<D>& s, int n) {
  const Mat<D> inverted = inverse(edge_matrix<D>(s.x));
  DistributedOverlap<D> r;
  for (double& w : r.own) w = 0;
  const auto add = [&](const double(&w)[D], double share) {
    Vec<D> at = Vec<D>::zero();
    for (int i = 0; i < D; ++i) at += s.face[i] * w[i];
    const double phi = share * potential(s, inverted, at);
    r.depth += phi;
    for (int i = 0; i < D; ++i) r.own[i] += phi * w[i];
  };
  for (int i = 0; i < n; ++i) {
    if constexpr (D == 2) {
      const double a = (i + 0.5) / n;
      add({1 - a, a}, 1.0 / n);
    } else {
      for (int j = 0; j < 2 * (n - i) - 1; ++j) {  // small triangles, upright and turned
        const double a = (i + (j % 2 == 0 ? 1.0 : 2.0) / 3) / n;
        const double b = (j / 2 + (j % 2 == 0 ? 1.0 : 2.0) / 3) / n;
        add({1 - a - b, a, b}, 1.0 / (n * n));
      }
    }
  }
  for (double& w : r.own) w /= r.depth > 0 ? r.depth : 1;
  return r;
}

/// Sum over the parts, as by_midpoints gives it.
template <int D>
DistributedOverlap<D> by_parts(const Sample<D>& s) {
  const Mat<D> inverted = inverse(edge_matrix<D>(s.x));
  double steepest = 0;
  Vec<D> first = Vec<D>::zero();
  for (int k = 0; k < D; ++k) {
    Vec<D> g;
    for (int d = 0; d < D; ++d) g[d] = inverted(k, d);
    first -= g;
    steepest = std::max(steepest, norm(g));
  }
  steepest = std::max(steepest, norm(first));
  DistributedOverlap<D> sum;
  for (double& w : sum.own) w = 0;
  for (int q = 0; q < D; ++q) {
    const DistributedOverlap<D> part = distributed_overlap(s.face, q, s.x);
    if (!(part.depth > 0)) continue;
    const double phi = part.depth * steepest / D;
    sum.depth += phi;
    for (int i = 0; i < D; ++i) sum.own[i] += phi * part.own[i];
    double total = 0;
    for (const double l : part.l) {
      EXPECT_GT(l, -1e-12);  // the centre lies in the element, for that is convex
      total += l;
    }
    EXPECT_NEAR(total, 1, 1e-12);
  }
  for (double& w : sum.own) w /= sum.depth > 0 ? sum.depth : 1;
  return sum;
}

template <int D>
int compare(int n, double tolerance) {
  int overlapping = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Sample<D> s = random_sample<D>(seed);
    const DistributedOverlap<D> exact = by_parts(s), rule = by_midpoints(s, n);
    EXPECT_NEAR(exact.depth, rule.depth, tolerance) << seed;
    if (rule.depth < 0.01) continue;
    ++overlapping;
    for (int i = 0; i < D; ++i) EXPECT_NEAR(exact.own[i], rule.own[i], 100 * tolerance) << seed;
  }
  return overlapping;
}

// The potential has kinks: the midpoint rule is of second order.
TEST(DistributedPotential, IsIntegratedExactlyInThePlane) {
  EXPECT_GT(compare<2>(2000, 1e-6), 50);
}
TEST(DistributedPotential, IsIntegratedExactlyInSpace) {
  EXPECT_GT(compare<3>(60, 1e-4), 30);
}

// A segment through the middle of a triangle of height 1, by hand: from L_0 = 0 to the centroid.
TEST(DistributedPotential, OfASegmentThroughATriangle) {
  const double side = 2 / std::sqrt(3.0);
  const Vec<2> x[3] = {{{0, 0}}, {{side, 0}}, {{0.5 * side, 1}}};
  // Part 0 of the segment is its first half: along the axis, from the base to the height 1/3.
  const Vec<2> face[2] = {{{0.5 * side, 0}}, {{0.5 * side, 2.0 / 3}}};
  const DistributedOverlap<2> part = distributed_overlap(face, 0, x);
  EXPECT_NEAR(part.depth, 1.0 / 6, 1e-15);   // mean of y over 0 ... 1/3
  EXPECT_NEAR(part.own[1], 1.0 / 3, 1e-15);  // at y = 2/9 of 2/3
  EXPECT_NEAR(part.l[2], 2.0 / 9, 1e-15);
  EXPECT_NEAR(part.share, 1, 1e-15);
  EXPECT_NEAR(distributed_overlap(face, 1, x).share, 1, 1e-15);
}

}  // namespace
}  // namespace breccia
