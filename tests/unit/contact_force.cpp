#include "contact_samples.hpp"
#include "point/contact_potential.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace breccia;

/// A block with shifted nodes on its sides too, so that no two meshes match.
Mesh<2> random_block(Point<2> lower, Point<2> upper, Index nx, Index ny, std::uint64_t seed) {
  Mesh<2> mesh = block(lower, upper, nx, ny, seed % 2 ? Pattern::right : Pattern::cross, 0.2, seed);
  const Random random{seed, 5};
  const double h = (upper[0] - lower[0]) / nx;
  for (Index n = 0; n < mesh.points(); ++n) {
    auto& p = mesh.point[n];
    const bool side = p[1] == lower[1] || p[1] == upper[1];
    const bool end = p[0] == lower[0] || p[0] == upper[0];
    if (side && !end) p[0] += 0.25 * h * (2 * random.uniform(n) - 1);
  }
  return mesh;
}

/// V-033: a block of width 1 pressed `overlap` into a wide one; h = 0.1.
ContactWorld<2> flat_on_flat(std::uint64_t seed, double offset, double overlap, bool below,
                             bool corners = false) {
  ContactWorld<2> world(join<2>({random_block({offset, 0}, {1 + offset, 0.6}, 10, 6, seed),
                                 below ? random_block({-1, -0.6}, {2.2, 0}, 29, 5, seed + 1)
                                       : random_block({-1, 0.6}, {2.2, 1.2}, 29, 5, seed + 1)}));
  if (corners) world.surface.own_weight = PointWeight<2>::corners;
  move_body(world, 0, {{0, below ? -overlap : overlap}});
  world.update_surface();
  world.search();
  world.force();
  return world;
}

// V-033. Law: p = k delta / 2 from each of the two passes. The pass of the block's own points is
// k delta / 2 times its width, whatever the meshes, the offset and the side.
TEST(ContactForce, FlatOnFlatIsMeshIndependent) {
  const double overlap = 1e-4, width = 1.0;
  for (std::uint64_t seed = 1; seed < 9; ++seed)
    for (const bool below : {true, false}) {
      const ContactWorld<2> world = flat_on_flat(seed, 0.013 * seed, overlap, below);
      const Vec<2> block = world.point_force(0);
      const double expected = 0.5 * world.stiffness * overlap * width * (below ? 1 : -1);
      EXPECT_NEAR(block[1], expected, 1e-6 * std::abs(expected));
      EXPECT_NEAR(block[0], 0.0, 1e-6 * std::abs(expected));
      // The other pass counts the wide block's points under the width: to the spacing of points.
      EXPECT_NEAR(-world.point_force(1)[1], expected, 0.07 * std::abs(expected));
    }
}

// Points at corners integrate what is linear as exactly. The lowest corners of the two sides, edges
// of 0.1, enter as well: they add half an edge each.
TEST(ContactForce, FlatOnFlatWithPointsAtCorners) {
  const double overlap = 1e-4, expected = 0.5 * 1e9 * overlap * (1.0 + 2 * 0.05);
  for (std::uint64_t seed = 1; seed < 5; ++seed) {
    const ContactWorld<2> world = flat_on_flat(seed, 0.013 * seed, overlap, true, true);
    EXPECT_NEAR(world.point_force(0)[1], expected, 1e-6 * expected);
  }
}

/// A regular hexagon stands on its corner, so far below the floor's surface; its edges are 0.1 long.
double corner_force(bool corners, double depth) {
  ContactWorld<2> world(
      join<2>({ring_disc({{0, 0.1 - depth}}, 0.1, 6, 2, std::numbers::pi / 6, "grain"),
               block({-0.5, -0.2}, {0.5, 0}, 7, 2)}));
  if (corners) world.surface.own_weight = PointWeight<2>::corners;
  world.update_surface();
  world.search();
  world.force();
  return world.point_force(0)[1] - world.point_force(1)[1];
}

// Gauss points lie a fifth of an edge away from the corner, here 0.0106 higher: a corner that enters
// less deep is not seen. Points at corners see it from the first on: two edges' points of half an
// edge each press with half the stiffness.
TEST(ContactForce, PointsAtCornersSeeACornerAtOnce) {
  EXPECT_EQ(corner_force(false, 0.01), 0);
  EXPECT_GT(corner_force(false, 0.011), 0);
  for (const double depth : {1e-5, 1e-3, 0.01})
    EXPECT_NEAR(corner_force(true, depth), 0.5 * 1e9 * depth * 0.1, 1e-6 * 1e9 * depth * 0.1);
}

TEST(ContactForce, FlatOnFlatDoesNotFeelTheOffset) {
  const double overlap = 1e-4, expected = 0.5 * 1e9 * overlap;
  ContactWorld<2> world = flat_on_flat(3, 0, overlap, true);
  for (int i = 0; i < 200; ++i) {
    move_body(world, 0, {{0.1 / 200, 0}});
    world.search();
    world.force();
    ASSERT_NEAR(world.point_force(0)[1], expected, 1e-6 * expected) << i;
  }
}

/// Distributed potential contact as a control (ALGORITHMS ): phi = 3 min L_k of the element
/// that holds the point, of its own scale and zero on every edge; gradient of the element.
Vec<2> classical_force(const ContactWorld<2>& world, const Vec<2>& at, Index body) {
  for (Index e = 0; e < world.mesh.elements(); ++e) {
    if (world.mesh.body[e] != body) continue;
    Vec<2> x[3];
    Index node[3];
    for (int k = 0; k < 3; ++k) {
      node[k] = world.mesh.element[e][k];
      x[k] = world.x[node[k]];
    }
    if (!claims<2>(x, node, at)) continue;
    const Mat<2> inverted = inverse(edge_matrix<2>(x));
    double l[3];
    barycentric(inverted, x[0], at, l);
    const int least = l[0] < l[1] ? (l[0] < l[2] ? 0 : 2) : (l[1] < l[2] ? 1 : 2);
    const Vec<2> edge = x[(least + 2) % 3] - x[(least + 1) % 3];
    return Vec<2>{{edge[1], -edge[0]}} * (3 * l[least] / norm(edge));
  }
  return Vec<2>::zero();
}

/// V-034: how force amplitude and direction change while a small triangle's tip is dragged along
/// the top of a body at constant depth.
struct Drag {
  double jump = 0, turn = 0;     ///< largest change between samples: relative; degrees
  double ripple = 0, slant = 0;  ///< largest departure from the mean; from the exact normal
};

/// Path: position of the probe's point and the exact outward normal there, at arc length s.
template <class Path>
Drag drag(ContactWorld<2>& world, const Path& path, int samples, bool classical = false) {
  std::vector<Vec<2>> forces, normals;
  for (int i = 0; i < samples; ++i) {
    Vec<2> at, normal;
    path(i, at, normal);
    move_body(world, 1, at - world.x[world.mesh.points() - 1]);
    if (classical) {
      forces.push_back(classical_force(world, at, 0));
    } else {
      if (i == 0 || 2 * world.way().way > world.skin) world.search();
      world.force();
      forces.push_back(world.point_force(1));
    }
    normals.push_back(normal);
  }
  Drag drag;
  double mean = 0;
  for (const auto& f : forces) mean += norm(f) / samples;
  const auto angle = [](const Vec<2>& a, const Vec<2>& b) {
    return std::atan2(std::abs(cross(a, b)), dot(a, b)) * 180 / std::numbers::pi;
  };
  for (int i = 0; i < samples; ++i) {
    drag.ripple = std::max(drag.ripple, std::abs(norm(forces[i]) / mean - 1));
    drag.slant = std::max(drag.slant, angle(forces[i], normals[i]));
    if (i == 0) continue;
    drag.jump = std::max(drag.jump, norm(forces[i] - forces[i - 1]) / mean);
    drag.turn = std::max(drag.turn, angle(forces[i], forces[i - 1]));
  }
  return drag;
}

/// A needle whose base is so short that its two points are one; it comes from direction `out`. The
/// last node is the base's end.
Mesh<2> needle(const Vec<2>& at, const Vec<2>& out) {
  Mesh<2> mesh;
  mesh.body_names = {"needle"};
  const Vec<2> end = at + out, left = at + Vec<2>{{-out[1], out[0]}} * (1e-9 / norm(out));
  mesh.point = {{end[0], end[1]}, {left[0], left[1]}, {at[0], at[1]}};
  mesh.element = {{0, 1, 2}};
  mesh.body = {0};
  return mesh;
}

TEST(ContactForce, DraggedAlongAFlatSurface) {
  const double h = 0.1, depth = 0.05 * h;
  ContactWorld<2> world(
      join<2>({random_block({0, 0}, {6, 0.5}, 60, 5, 4), needle({{0.5, 0.6}}, {{0, 0.05}})}));
  world.skin = 0.01;
  world.update_surface();
  const Drag d = drag(
      world,
      [&](int i, Vec<2>& at, Vec<2>& normal) {
        at = {{0.5 + 1e-2 * h * i, 0.5 - depth}};
        normal = {{0, 1}};
      },
      5000);
  EXPECT_LT(d.jump, 1e-6);
  EXPECT_LT(d.turn, 1e-5);
  EXPECT_LT(d.slant, 1e-4);
}

/// Along the sides of a regular polygon, at constant depth below them.
struct PolygonPath {
  int sides;
  double depth, step;
  void operator()(int i, Vec<2>& at, Vec<2>& normal) const {
    const double pitch = 2 * std::numbers::pi / sides, angle = 0.1 + step * i;
    const double within = std::remainder(angle - 0.5 * pitch, pitch);
    const double radius = (std::cos(0.5 * pitch) - depth) / std::cos(within);
    normal = {{std::cos(angle), std::sin(angle)}};
    at = normal * radius;
  }
};

/// Needle from outside and a disc; the needle must not turn, so one octant at a time.
ContactWorld<2> disc_and_needle(int sides) {
  ContactWorld<2> world(join<2>(
      {ring_disc({{0, 0}}, 1, sides, sides / 6, 0, "disc"), needle({{1.5, 0}}, {{0.3, 0.12}})}));
  world.skin = 0.02;
  world.update_surface();
  return world;
}

// V-034 on polygons, samples every 1e-3 h.
TEST(ContactForce, DraggedAlongAPolygon) {
  double ripple[3];
  for (int i = 0; i < 3; ++i) {
    const int sides = 16 << i;
    const double h = 2 * std::numbers::pi / sides, depth = 0.05 * h;
    ContactWorld<2> world = disc_and_needle(sides);
    const PolygonPath path{sides, depth, 1e-3 * h};
    const Drag d = drag(world, path, 2000);
    const Drag old = drag(world, path, 2000, true);
    EXPECT_LT(d.jump, 0.01);
    EXPECT_LT(d.turn, 1.0);
    EXPECT_LT(d.slant, 180.0 / sides);
    EXPECT_TRUE(old.jump > 0.3 || old.turn > 10) << old.jump << " " << old.turn;
    ripple[i] = d.ripple;
    std::printf("%d sides: jump %.4f turn %.4f ripple %.4f slant %.3f | classical %.3f %.1f\n",
                sides, d.jump, d.turn, d.ripple, d.slant, old.jump, old.turn);
  }
  EXPECT_LT(ripple[2], 0.05);
}

/// Largest slip so far of the points.
double most_rubbed(const ContactWorld<2>& world) {
  const auto rubbed =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, world.history.rubbed);
  double most = 0;
  for (Index a = 0; a < world.pairs.points; ++a)
    for (int s = 0; s < kContactSlots; ++s) most = std::max(most, rubbed(a, s, 0));
  return most;
}

// A block that slides on, is lifted and comes down again weakens from where it was, whatever its
// force is made of; Coulomb's friction has no memory to carry.
TEST(ContactForce, LawOfFrictionRemembersOverAHop) {
  for (const bool distributed : {false, true}) {
    ContactWorld<2> world(
        join<2>({block({0, 0}, {1, 0.6}, 5, 3), block({-1, -0.6}, {2.2, 0}, 16, 3)}));
    world.distributed = distributed;
    world.friction = 0.6;
    world.law = {FrictionKind::slip_weakening, 0.6, 0.4, 0.1, 0, 0, 0, 0};
    move_body(world, 0, {{0, -1e-4}});
    world.update_surface();
    world.search();
    const double dt = 1e-3;
    const auto slide = [&](const Vec<2>& way) {
      move_body(world, 0, way);
      for (std::size_t e = 0; e < world.mesh.element.size(); ++e)
        if (world.mesh.body[e] == 0)
          for (const Index n : world.mesh.element[e]) world.v[n] = way * (1 / dt);
      world.dt_before = dt;
      world.force();
    };
    for (int i = 0; i < 10; ++i) slide({{1e-3, 0}});
    const double slid = most_rubbed(world);
    EXPECT_NEAR(slid, 0.01, 5e-4);
    for (int i = 0; i < 4; ++i) slide({{0, 1e-4}});
    EXPECT_EQ(world.touching(), 0);
    EXPECT_NEAR(most_rubbed(world), slid, 3e-4);  // the springs of friction let go
    EXPECT_EQ(world.stored(), 0);
    for (int i = 0; i < 4; ++i) slide({{0, -1e-4}});
    EXPECT_GT(world.touching(), 0);
    for (int i = 0; i < 10; ++i) slide({{1e-3, 0}});
    EXPECT_NEAR(most_rubbed(world), 0.02, 1e-3);
  }
}

}  // namespace
