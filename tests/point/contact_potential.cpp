#include "point/contact_potential.hpp"

#include "core/random.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace breccia;

Vec<2> mix(const Vec<2> (&x)[3], const double (&l)[3]) {
  return x[0] * l[0] + x[1] * l[1] + x[2] * l[2];
}

// Exactly one triangle of a fan claims a point: also on edges, on the hub, and for rotated fans.
TEST(ContactPotential, OneElementClaimsAPoint) {
  for (int turn = 0; turn < 50; ++turn) {
    Vec<2> rim[7];
    const Vec<2> hub{{0.25, -0.5}};
    for (int i = 0; i < 7; ++i) {
      const double angle = 0.3 * turn + 6.283185307179586 * i / 7;
      rim[i] = hub + Vec<2>{{std::cos(angle), std::sin(angle)}};
    }
    const auto claimants = [&](const Vec<2>& q) {
      int n = 0;
      for (int i = 0; i < 7; ++i) {
        const int j = (i + 1) % 7;
        const Vec<2> x[3] = {rim[i], rim[j], hub};
        // Node numbers in no particular order.
        const Index node[3] = {(i * 5 + turn) % 7, (j * 5 + turn) % 7, turn % 2 == 0 ? 9 : -1};
        n += claims<2>(x, node, q) ? 1 : 0;
      }
      return n;
    };
    EXPECT_EQ(claimants(hub), 1);
    for (int i = 0; i < 7; ++i)
      for (const double s : {0.1, 0.25, 0.5, 1.0 / 3})
        EXPECT_EQ(claimants(hub + (rim[i] - hub) * s), 1);
    EXPECT_EQ(claimants(hub + Vec<2>{{2, 2}}), 0);
  }
}

TEST(ContactPotential, SingleTriangleIsExactDepth) {
  const Vec<2> x[3] = {{{0, 0}}, {{3, 0}}, {{1, 2}}};
  ContactPotential<2> p{};
  const double area2 = determinant(edge_matrix<2>(x));
  for (int f = 0; f < 3; ++f)
    p.bubble[f] = -area2 / norm(x[face_node<2>(f, 1)] - x[face_node<2>(f, 0)]);
  const Random random{1, 2};
  for (int i = 0; i < 200; ++i) {
    double l[3] = {random.uniform(i, 0), random.uniform(i, 1), random.uniform(i, 2)};
    const double sum = l[0] + l[1] + l[2];
    for (double& a : l) a /= sum;
    const Vec<2> q = mix(x, l);
    double depth = 1e9;
    for (int f = 0; f < 3; ++f) {
      const Vec<2> face[2] = {x[face_node<2>(f, 0)], x[face_node<2>(f, 1)]};
      depth = std::min(depth, std::sqrt(square_distance_to_face<2>(face, q)));
    }
    const auto v = p.value(l);
    EXPECT_NEAR(v.phi, depth, 1e-14);
    const Vec<2> g = gradient_in_space<2>(inverse(edge_matrix<2>(x)), v.edge);
    EXPECT_NEAR(norm(g), 1.0, 1e-13);
  }
}

// The corner of a square cut by a diagonal: depth is min(x, y) in both triangles.
TEST(ContactPotential, ChordOfACornerIsExactDepth) {
  const double h = 0.5;
  const Vec<2> corner[3] = {{{0, 0}}, {{h, 0}}, {{0, h}}};
  const Vec<2> inner[3] = {{{h, h}}, {{0, h}}, {{h, 0}}};
  ContactPotential<2> a{}, b{};
  a.bubble[0] = b.bubble[0] = 2 * (h / 2);
  b.depth[0] = h;
  for (int i = 1; i < 20; ++i)
    for (int j = 1; j < 20 - i; ++j) {
      const double l[3] = {1 - (i + j) / 20.0, i / 20.0, j / 20.0};
      for (const auto& [p, x] : {std::pair{&a, &corner}, std::pair{&b, &inner}}) {
        const Vec<2> q = mix(*x, l);
        EXPECT_NEAR(p->value(l).phi, std::min(q[0], q[1]), 1e-15);
      }
    }
}

/// Barycentric coordinates at random.
template <int D>
void draw(const Random& random, int i, double (&l)[D + 1]) {
  double sum = 0;
  for (int k = 0; k <= D; ++k) sum += l[k] = random.uniform(i, k);
  for (double& a : l) a /= sum;
}

/// Nodes of `above` (bits) lie on one side of a plate of thickness h, the others on the other one.
template <int D>
void expect_plate(int above, double h) {
  ContactPotential<D> p{};
  for (int c = kFirstEdge<D>; c < kChords<D>; ++c) {
    const bool first = (above >> chord_node<D>(c, 0)) & 1,
               second = (above >> chord_node<D>(c, 1)) & 1;
    if (first != second) p.bubble[c] = 2 * (h / 2);
  }
  const Random random{5, 6};
  for (int i = 0; i < 100; ++i) {
    double l[D + 1], up = 0;
    draw<D>(random, i, l);
    for (int k = 0; k <= D; ++k) up += (above >> k) & 1 ? l[k] : 0;
    EXPECT_NEAR(p.value(l).phi, h * std::min(up, 1 - up), 1e-15) << above;
  }
}

TEST(ContactPotential, StripsAndPlatesOfOneElementAreExact) {
  for (int above = 1; above < 7; ++above) expect_plate<2>(above, 0.4);
  for (int above = 1; above < 15; ++above) expect_plate<3>(above, 0.4);
}

// A triangle or tetrahedron between arms: no chord makes it deeper than itself.
TEST(ContactPotential, ChordsAllAroundStayAsDeepAsTheyAre) {
  ContactPotential<3> p{};
  for (int c = kFirstEdge<3>; c < kChords<3>; ++c) p.bubble[c] = 2;
  const double corner[4] = {0.25, 0.25, 0.25, 0.25}, side[4] = {0, 1.0 / 3, 1.0 / 3, 1.0 / 3},
               edge[4] = {0, 0, 0.5, 0.5};
  EXPECT_NEAR(p.value(corner).phi, 1, 1e-15);
  EXPECT_NEAR(p.value(side).phi, 1, 1e-15);
  EXPECT_NEAR(p.value(edge).phi, 1, 1e-15);
}

// The gradient that `value` gives is the derivative of its phi, away from the kinks.
template <int D>
void expect_derivative(const Vec<D> (&x)[D + 1]) {
  const Mat<D> inverted = inverse(edge_matrix<D>(x));
  const Random random{3, 4};
  for (int i = 0; i < 300; ++i) {
    ContactPotential<D> p{};
    for (int k = 0; k <= D; ++k) p.depth[k] = i % 3 == 0 ? 0.0 : random.uniform(i, k);
    for (int c = 0; c < kChords<D>; ++c)
      p.bubble[c] = i % 3 == 1 || (i + c) % 4 == 3 ? 0.0 : 0.1 + random.uniform(i, 10 + c);
    if (i % 2 == 0)
      for (int f = 0; f <= D; ++f) p.bubble[f] = -0.1 - random.uniform(i, 30 + f);
    if (p.single())
      for (double& d : p.depth) d = 0;
    double l[D + 1];
    draw<D>(random, 1000 + i, l);
    Vec<D> q = Vec<D>::zero();
    for (int k = 0; k <= D; ++k) q += x[k] * l[k];
    const Vec<D> g = gradient_in_space<D>(inverted, p.value(l).edge);
    const double step = 1e-7;
    for (int d = 0; d < D; ++d) {
      Vec<D> ahead = q, behind = q;
      ahead[d] += step;
      behind[d] -= step;
      double la[D + 1], lb[D + 1];
      barycentric(inverted, x[0], ahead, la);
      barycentric(inverted, x[0], behind, lb);
      EXPECT_NEAR((p.value(la).phi - p.value(lb).phi) / (2 * step), g[d], 1e-6) << i;
    }
  }
}

TEST(ContactPotential, GradientIsTheDerivative) {
  expect_derivative<2>({{{0.1, 0}}, {{1.3, 0.2}}, {{0.4, 0.9}}});
  expect_derivative<3>({{{0.1, 0, 0}}, {{1.3, 0.2, 0.1}}, {{0.4, 0.9, 0}}, {{0.3, 0.3, 1.1}}});
}

TEST(ContactPotential, DistanceToSimplexGivesItsNearestPoint) {
  const Vec<2> x[3] = {{{0, 0}}, {{2, 0}}, {{0, 1}}};
  double l[3];
  EXPECT_EQ(square_distance_to_simplex<2>(x, {{0.5, 0.25}}, l), 0.0);
  EXPECT_DOUBLE_EQ(square_distance_to_simplex<2>(x, {{1, -2}}, l), 4.0);
  EXPECT_DOUBLE_EQ(l[0], 0.5);
  EXPECT_DOUBLE_EQ(l[1], 0.5);
  EXPECT_DOUBLE_EQ(l[2], 0.0);
  EXPECT_DOUBLE_EQ(square_distance_to_simplex<2>(x, {{3, 0}}, l), 1.0);
  EXPECT_DOUBLE_EQ(l[1], 1.0);
}

}  // namespace
