#include "harness/contact_world.hpp"
#include "mesh/structured.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace breccia;

Mesh<2> block(Point<2> lower, Point<2> upper, Index nx, Index ny, Pattern pattern, double jitter,
              const std::string& name = "block") {
  Grid<2> grid;
  grid.lower = lower;
  grid.upper = upper;
  grid.cells = {nx, ny};
  grid.pattern = pattern;
  grid.jitter = jitter;
  grid.body = name;
  return structured_mesh(grid);
}

/// Depth at the nodes of the targets, checked against a function of the place.
template <class Exact>
void expect_depth(const ContactWorld<2>& world, const Exact& exact, double tolerance) {
  const auto target = to_host(world.surface.target, world.surface.targets);
  const auto depth = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, world.surface.depth);
  for (Index t = 0; t < world.surface.targets; ++t)
    for (int a = 0; a < 3; ++a) {
      const Vec<2> at = world.x[world.mesh.element[target[t]][a]];
      EXPECT_NEAR(depth(t, a), exact(at), tolerance) << at[0] << " " << at[1];
    }
}

// Distance to the sides of a rectangle, exact on any triangulation.
TEST(ContactDepth, RectangleIsExact) {
  for (const Pattern pattern : {Pattern::right, Pattern::cross, Pattern::union_jack})
    for (const double jitter : {0.0, 0.25}) {
      ContactWorld<2> world(block({0, 0}, {2, 1}, 20, 10, pattern, jitter));
      world.layers = 3;
      world.update_surface();
      expect_depth(
          world,
          [](const Vec<2>& p) {
            return std::min({p[0], 2 - p[0], p[1], 1 - p[1]});
          },
          1e-14);
    }
}

// All nodes of a strip of one cell lie on its surface, and the depth is exact all the same.
TEST(ContactDepth, StripOfOneCellIsExact) {
  ContactWorld<2> world(block({0, 0}, {4, 1}, 4, 1, Pattern::right, 0));
  world.update_surface();
  const auto depth = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, world.surface.depth);
  const auto bubble =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, world.surface.bubble);
  const auto target = to_host(world.surface.target, world.surface.targets);
  int seen = 0;
  for (Index t = 0; t < world.surface.targets; ++t) {
    ContactPotential<2> potential;
    for (int c = 0; c < 3; ++c) potential.bubble[c] = bubble(t, c);
    for (int a = 0; a < 3; ++a) potential.depth[a] = depth(t, a);
    for (const double u : {0.1, 0.3, 0.6}) {
      const double l[3] = {u, 0.7 * (1 - u), 0.3 * (1 - u)};
      Vec<2> q = Vec<2>::zero();
      for (int a = 0; a < 3; ++a) q += world.x[world.mesh.element[target[t]][a]] * l[a];
      if (q[0] < 1 || q[0] > 3) continue;
      ++seen;
      EXPECT_NEAR(potential.value(l).phi, std::min(q[1], 1 - q[1]), 1e-14);
    }
  }
  EXPECT_GT(seen, 8);
}

TEST(ContactDepth, TargetsAreTheLayersBehindTheSurface) {
  ContactWorld<2> world(block({0, 0}, {2, 1}, 20, 10, Pattern::right, 0));
  const auto targets = [&](Index layers) {
    world.layers = layers;
    world.update_surface();
    return world.surface.targets;
  };
  EXPECT_EQ(world.topology.free.size(), 60u);
  // Cells in the outer ring, plus the triangles of the next ring that touch a boundary node; the
  // rings shrink by two cells a side.
  const Index one = targets(0), two = targets(1), all = targets(20);
  EXPECT_GT(one, 2 * (20 * 10 - 18 * 8) - 1);
  EXPECT_GT(two, one);
  EXPECT_EQ(all, 400);
  EXPECT_EQ(world.surface.facets, 60);
}

// A disc of rings: depth of the polygon is the distance to its nearest chord.
TEST(ContactDepth, PolygonAndNormals) {
  constexpr int kSides = 48;
  Mesh<2> mesh;
  mesh.body_names = {"disc"};
  const double radius = 1;
  for (int ring = 0; ring < 4; ++ring)
    for (int i = 0; i < kSides; ++i) {
      const double angle = 2 * std::numbers::pi * (i + 0.5 * ring) / kSides;
      const double r = radius * (1 - 0.13 * ring);
      mesh.point.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
  for (int ring = 0; ring < 3; ++ring)
    for (int i = 0; i < kSides; ++i) {
      const Index a = ring * kSides + i, b = ring * kSides + (i + 1) % kSides;
      const Index c = a + kSides, d = b + kSides;
      mesh.element.push_back({a, b, c});
      mesh.element.push_back({b, d, c});
      mesh.body.insert(mesh.body.end(), {0, 0});
    }
  // Only the outer side is a surface here: the inner ring is not part of the check.
  ContactWorld<2> world(mesh);
  world.layers = 0;
  world.update_surface();
  const auto target = to_host(world.surface.target, world.surface.targets);
  const auto depth = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, world.surface.depth);
  const double apothem = std::cos(std::numbers::pi / kSides);
  for (Index t = 0; t < world.surface.targets; ++t)
    for (int a = 0; a < 3; ++a) {
      const Index n = mesh.element[target[t]][a];
      if (n / kSides != 1) continue;
      // A node of the second ring stands in front of the middle of a chord.
      EXPECT_NEAR(depth(t, a), apothem - 0.87, 1e-13);
    }
}

// Two faces that have been released become surface on both sides; a crack of one face does not.
TEST(ContactDepth, ReleasedFacesAreSurface) {
  ContactWorld<2> world(block({0, 0}, {1, 1}, 4, 4, Pattern::cross, 0));
  world.update_surface();
  const Index before = world.surface.facets;
  world.released[10] = 1;
  world.update_surface();
  EXPECT_EQ(world.surface.facets, before + 2);
  const auto facet = to_host(world.surface.facet, world.surface.facets);
  const SharedFace& f = world.topology.shared[10];
  EXPECT_TRUE(std::binary_search(facet.begin(), facet.end(), f.left * 3 + f.left_face));
  EXPECT_TRUE(std::binary_search(facet.begin(), facet.end(), f.right * 3 + f.right_face));
}

}  // namespace
