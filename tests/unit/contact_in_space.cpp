// Contact of tetrahedra: depth, force on flats and on spheres, candidates (V-033, V-034, V-054).
#include "contact_samples.hpp"
#include "point/simplex_geometry.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace breccia;

/// A box of cells; its side nodes are shifted along the sides, so that no two meshes match.
Mesh<3> box(Point<3> lower, Point<3> upper, std::array<Index, 3> cells, std::uint64_t seed,
            const std::string& name) {
  Grid<3> grid;
  grid.lower = lower;
  grid.upper = upper;
  grid.cells = cells;
  grid.pattern = seed % 2 ? Pattern::kuhn : Pattern::five;
  grid.jitter = 0.15;
  grid.seed = seed;
  grid.body = name;
  Mesh<3> mesh = structured_mesh(grid);
  const Random random{seed, 5};
  for (Index n = 0; n < mesh.points(); ++n) {
    int sides = 0;
    for (int d = 0; d < 3; ++d)
      sides += mesh.point[n][d] == lower[d] || mesh.point[n][d] == upper[d] ? 1 : 0;
    if (sides != 1) continue;
    for (int d = 0; d < 3; ++d)
      if (mesh.point[n][d] != lower[d] && mesh.point[n][d] != upper[d])
        mesh.point[n][d] += 0.2 * (upper[d] - lower[d]) / cells[d] * (2 * random.uniform(n, d) - 1);
  }
  return mesh;
}

/// Depths of all nodes as the targets have them; -1 where there is no target.
std::vector<double> depths(const ContactWorld<3>& world) {
  std::vector<double> depth(world.x.size(), -1);
  const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, world.surface.depth);
  const auto nodes = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, world.surface.nodes);
  for (Index t = 0; t < world.surface.targets; ++t)
    for (int a = 0; a < 4; ++a) depth[nodes(t, a)] = host(t, a);
  return depth;
}

TEST(ContactInSpace, DepthOfABox) {
  ContactWorld<3> world(box({0, 0, 0}, {1, 1, 1}, {6, 6, 6}, 3, "box"));
  world.update_surface();
  const std::vector<double> depth = depths(world);
  int seen = 0;
  for (std::size_t n = 0; n < depth.size(); ++n) {
    double d = 1;
    for (int k = 0; k < 3; ++k) d = std::min({d, world.x[n][k], 1 - world.x[n][k]});
    if (depth[n] < 0 || d > 0.34) continue;
    seen += d > 0 ? 1 : 0;
    EXPECT_NEAR(depth[n], d, 1e-14) << n;
  }
  EXPECT_GT(seen, 90);
}

/// phi at a point of the reference configuration.
double potential_at(const ContactWorld<3>& world, const Vec<3>& q) {
  const auto depth = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, world.surface.depth);
  const auto bubble =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, world.surface.bubble);
  const auto nodes = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, world.surface.nodes);
  for (Index t = 0; t < world.surface.targets; ++t) {
    Vec<3> x[4];
    Index node[4];
    ContactPotential<3> potential;
    for (int a = 0; a < 4; ++a) {
      node[a] = nodes(t, a);
      x[a] = world.x[node[a]];
      potential.depth[a] = depth(t, a);
    }
    if (!claims<3>(x, node, q)) continue;
    for (int c = 0; c < kChords<3>; ++c) potential.bubble[c] = bubble(t, c);
    double l[4];
    barycentric(inverse(edge_matrix<3>(x)), x[0], q, l);
    return potential.value(l).phi;
  }
  return -1;
}

// All nodes of a slab of one cell lie on its surface: chords carry its depth, which is exact, also
// in tetrahedra with two nodes above and two below.
TEST(ContactInSpace, ThinSlabHasItsDepth) {
  for (const Pattern pattern : {Pattern::kuhn, Pattern::five}) {
    Grid<3> grid;
    grid.lower = {0, 0, 0};
    grid.upper = {4, 4, 1};
    grid.cells = {4, 4, 1};
    grid.pattern = pattern;
    ContactWorld<3> world(structured_mesh(grid));
    world.update_surface();
    const Random random{4, 9};
    for (int i = 0; i < 500; ++i) {
      const Vec<3> q{
          {1 + 2 * random.uniform(i, 0), 1 + 2 * random.uniform(i, 1), random.uniform(i, 2)}};
      EXPECT_NEAR(potential_at(world, q), std::min(q[2], 1 - q[2]), 1e-13);
    }
  }
}

// phi of neighbouring elements agrees on their common face, with bubbles and without.
TEST(ContactInSpace, PotentialIsContinuous) {
  ContactWorld<3> world(box({0, 0, 0}, {1, 1, 0.4}, {4, 4, 2}, 1, "box"));
  world.update_surface();
  const auto target = to_host(world.surface.target, world.surface.targets);
  const auto bubble =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, world.surface.bubble);
  const auto depth = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, world.surface.depth);
  const auto value = [&](Index e, const Vec<3>& q) {
    const auto t = std::lower_bound(target.begin(), target.end(), e) - target.begin();
    Vec<3> x[4];
    ContactPotential<3> potential;
    for (int a = 0; a < 4; ++a) {
      x[a] = world.x[world.mesh.element[e][a]];
      potential.depth[a] = depth(t, a);
    }
    for (int c = 0; c < kChords<3>; ++c) potential.bubble[c] = bubble(t, c);
    double l[4];
    barycentric(inverse(edge_matrix<3>(x)), x[0], q, l);
    return potential.value(l).phi;
  };
  const Random random{2, 2};
  int chords = 0;
  for (std::size_t s = 0; s < world.topology.shared.size(); ++s) {
    const SharedFace& f = world.topology.shared[s];
    for (int k = 0; k < 4; ++k) {
      double w[3] = {random.uniform(4 * s + k, 0), random.uniform(4 * s + k, 1),
                     random.uniform(4 * s + k, 2)};
      const double sum = w[0] + w[1] + w[2];
      Vec<3> q = Vec<3>::zero();
      for (int i = 0; i < 3; ++i)
        q += world.x[world.mesh.element[f.left][face_node<3>(f.left_face, i)]] * (w[i] / sum);
      EXPECT_NEAR(value(f.left, q), value(f.right, q), 1e-12);
    }
    const auto t = std::lower_bound(target.begin(), target.end(), f.left) - target.begin();
    for (int c = 0; c < kChords<3>; ++c) chords += bubble(t, c) > 0 ? 1 : 0;
  }
  EXPECT_GT(chords, 20);
}

// Each point of a cube belongs to one element, on faces, edges and nodes too.
TEST(ContactInSpace, OnePointOneElement) {
  Grid<3> grid;
  grid.lower = {0, 0, 0};
  grid.upper = {2, 2, 2};
  grid.cells = {2, 2, 2};
  for (const Pattern pattern : {Pattern::kuhn, Pattern::five}) {
    grid.pattern = pattern;
    const Mesh<3> mesh = structured_mesh(grid);
    for (int i = 1; i < 16; ++i)
      for (int j = 1; j < 16; ++j)
        for (int k = 1; k < 16; ++k) {
          const Vec<3> q{{0.125 * i, 0.125 * j, 0.125 * k}};
          int claimed = 0;
          for (Index e = 0; e < mesh.elements(); ++e) {
            Vec<3> x[4];
            Index node[4];
            for (int a = 0; a < 4; ++a) {
              node[a] = mesh.element[e][a];
              for (int d = 0; d < 3; ++d) x[a][d] = mesh.point[node[a]][d];
            }
            claimed += claims<3>(x, node, q) ? 1 : 0;
          }
          EXPECT_EQ(claimed, 1) << i << " " << j << " " << k;
        }
  }
}

// V-033. Law: p = k delta / 2 from each of the two passes; the block's own pass is exact whatever
// the meshes, the offset and the side.
TEST(ContactInSpace, FlatOnFlatIsMeshIndependent) {
  const double overlap = 1e-4;
  for (std::uint64_t seed = 1; seed < 6; ++seed)
    for (const bool below : {true, false}) {
      const double off = 0.013 * static_cast<double>(seed);
      ContactWorld<3> world(
          join<3>({box({off, -off, 0}, {1 + off, 1 - off, 1.2}, {5, 5, 6}, seed, "block"),
                   box({-1, -1, below ? -1.2 : 1.2}, {2.2, 2.2, below ? 0.0 : 2.4}, {15, 15, 6},
                       seed + 1, "floor")}));
      move_body(world, 0, {{0, 0, below ? -overlap : overlap}});
      world.update_surface();
      world.search();
      world.force();
      const Vec<3> force = world.point_force(0);
      const double expected = 0.5 * world.stiffness * overlap * (below ? 1 : -1);
      EXPECT_NEAR(force[2], expected, 1e-6 * std::abs(expected));
      EXPECT_NEAR(force[0], 0, 1e-6 * std::abs(expected));
      EXPECT_NEAR(force[1], 0, 1e-6 * std::abs(expected));
      // The other pass counts the floor's points under the block: to their spacing along its rim.
      EXPECT_NEAR(-world.point_force(1)[2], expected, 0.2 * std::abs(expected));
      // Both momenta: forces on all nodes add up to nothing, and so do their moments.
      Vec<3> sum = Vec<3>::zero(), moment = Vec<3>::zero();
      const auto f = world.node_force();
      for (std::size_t n = 0; n < f.size(); ++n) {
        sum += f[n];
        moment += cross(world.x[n], f[n]);
      }
      EXPECT_LT(norm(sum), 1e-12 * std::abs(expected));
      EXPECT_LT(norm(moment), 1e-12 * std::abs(expected));
    }
}

/// Icosahedron whose triangles are cut `fine` times, its corners on the unit sphere, in layers.
Mesh<3> ball(int layers, int fine) {
  const double g = std::numbers::phi;
  std::vector<Vec<3>> corner = {{{-1, g, 0}}, {{1, g, 0}}, {{-1, -g, 0}}, {{1, -g, 0}},
                                {{0, -1, g}}, {{0, 1, g}}, {{0, -1, -g}}, {{0, 1, -g}},
                                {{g, 0, -1}}, {{g, 0, 1}}, {{-g, 0, -1}}, {{-g, 0, 1}}};
  std::vector<std::array<Index, 3>> face = {
      {0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
      {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
      {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (auto& c : corner) c *= 1 / norm(c);
  for (int round = 0; round < fine; ++round) {
    std::vector<std::array<Index, 3>> finer;
    const auto middle = [&](Index a, Index b) {
      Vec<3> m = corner[a] + corner[b];
      m *= 1 / norm(m);
      for (std::size_t i = 0; i < corner.size(); ++i)
        if (norm(corner[i] - m) < 1e-9) return static_cast<Index>(i);
      corner.push_back(m);
      return static_cast<Index>(corner.size() - 1);
    };
    for (const auto& f : face) {
      const Index a = middle(f[0], f[1]), b = middle(f[1], f[2]), c = middle(f[2], f[0]);
      finer.push_back({f[0], a, c});
      finer.push_back({a, f[1], b});
      finer.push_back({c, b, f[2]});
      finer.push_back({a, b, c});
    }
    face = finer;
  }
  Mesh<3> mesh;
  mesh.body_names = {"ball"};
  const auto n = static_cast<Index>(corner.size());
  for (int layer = 0; layer < layers; ++layer)
    for (const auto& c : corner) {
      const double r = 1 - static_cast<double>(layer) / layers;
      mesh.point.push_back({r * c[0], r * c[1], r * c[2]});
    }
  mesh.point.push_back({0, 0, 0});
  const auto add = [&](Index a, Index b, Index c, Index d) {
    mesh.element.push_back({a, b, c, d});
    const auto at = [&](Index k) {
      return Vec<3>{{mesh.point[k][0], mesh.point[k][1], mesh.point[k][2]}};
    };
    if (dot(cross(at(b) - at(a), at(c) - at(a)), at(d) - at(a)) < 0)
      std::swap(mesh.element.back()[2], mesh.element.back()[3]);
  };
  for (int layer = 0; layer < layers; ++layer)
    for (auto f : face) {
      std::sort(f.begin(), f.end());
      Index low[3], high[3];
      for (int i = 0; i < 3; ++i) {
        low[i] = f[i] + layer * n;
        high[i] = layer + 1 == layers ? layers * n : low[i] + n;
      }
      add(low[0], low[1], low[2], high[0]);
      if (layer + 1 == layers) continue;
      add(low[1], low[2], high[0], high[1]);
      add(low[2], high[0], high[1], high[2]);
    }
  mesh.body.assign(mesh.element.size(), 0);
  return mesh;
}

/// A needle whose base is so short that its three points are one; it comes from direction `out`.
Mesh<3> needle(const Vec<3>& at, const Vec<3>& out) {
  const Vec<3> side = cross(out, Vec<3>{{0.3, 0.5, 0.8}}), other = cross(out, side);
  Mesh<3> mesh;
  mesh.body_names = {"needle"};
  const Vec<3> p[4] = {at + out, at, at + side * (1e-9 / norm(side)),
                       at + other * (1e-9 / norm(other))};
  for (const auto& q : p) mesh.point.push_back({q[0], q[1], q[2]});
  mesh.element = {{0, 1, 2, 3}};
  if (dot(cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]) < 0) mesh.element = {{0, 1, 3, 2}};
  mesh.body = {0};
  return mesh;
}

struct Drag {
  double jump = 0, turn = 0, slant = 0, ripple = 0;  ///< relative, degrees, degrees, relative
};

/// Drags the needle's tip through the points path(i), of outward normal `normal`.
template <class Path>
Drag drag(ContactWorld<3>& world, const Path& path, int samples) {
  const auto angle = [](const Vec<3>& a, const Vec<3>& b) {
    return std::atan2(norm(cross(a, b)), dot(a, b)) * 180 / std::numbers::pi;
  };
  Drag d;
  std::vector<Vec<3>> forces, normals;
  double mean = 0;
  for (int i = 0; i < samples; ++i) {
    Vec<3> at, normal;
    path(i, at, normal);
    move_body(world, 1, at - world.x[world.mesh.points() - 3]);
    if (i == 0 || 2 * world.way().way > world.skin) world.search();
    world.force();
    forces.push_back(world.point_force(1));
    normals.push_back(normal);
    mean += norm(forces.back()) / samples;
  }
  for (int i = 0; i < samples; ++i) {
    d.slant = std::max(d.slant, angle(forces[i], normals[i]));
    d.ripple = std::max(d.ripple, std::abs(norm(forces[i]) / mean - 1));
    if (i == 0) continue;
    d.jump = std::max(d.jump, norm(forces[i] - forces[i - 1]) / mean);
    d.turn = std::max(d.turn, angle(forces[i], forces[i - 1]));
  }
  return d;
}

// V-034 on a flat side: the force does not know the mesh.
TEST(ContactInSpace, DraggedAlongAFlatSurface) {
  const double h = 0.1;
  ContactWorld<3> world(join<3>({box({0, 0, 0}, {1.6, 1, 0.6}, {16, 10, 6}, 4, "floor"),
                                 needle({{0.5, 0.4, 0.7}}, {{0, 0, 0.05}})}));
  world.skin = 0.01;
  world.update_surface();
  const Drag d = drag(
      world,
      [&](int i, Vec<3>& at, Vec<3>& normal) {
        at = {{0.4 + 4e-3 * h * i, 0.42 + 1e-3 * h * i, 0.6 - 0.05 * h}};
        normal = {{0, 0, 1}};
      },
      1500);
  EXPECT_LT(d.jump, 1e-6);
  EXPECT_LT(d.slant, 1e-4);
}

/// Radius in a direction at which a point is `depth` below the triangles of the ball, body 0.
double surface_below(const ContactWorld<3>& world, const Vec<3>& direction, double depth) {
  double radius = 2;
  for (const ElementFace& face : world.topology.free) {
    if (world.mesh.body[face.element] != 0) continue;
    Vec<3> x[3];
    for (int i = 0; i < 3; ++i)
      x[i] = world.x[world.mesh.element[face.element][face_node<3>(face.face, i)]];
    Vec<3> n = face_normal(x);
    n *= 1 / norm(n);
    const double slope = dot(n, direction);
    if (slope > 0.1) radius = std::min(radius, (dot(n, x[0]) - depth) / slope);
  }
  return radius;
}

// V-034 on a ball of triangles, at constant depth, samples every 1e-3 h: small jumps, and a slant
// that falls with the triangles.
TEST(ContactInSpace, DraggedAlongABall) {
  double slant[2];
  for (const int fine : {1, 2}) {
    const double h = 1.05 / (1 << fine);
    ContactWorld<3> world(
        join<3>({ball(3 + fine, fine), needle({{1.5, 0.1, 0}}, {{0.3, 0.1, 0.12}})}));
    world.skin = 0.02;
    world.update_surface();
    const Drag d = drag(
        world,
        [&](int i, Vec<3>& at, Vec<3>& normal) {
          const double a = 0.15 + 1e-3 * h * i;
          normal = {{std::cos(a), std::sin(a) * 0.8, std::sin(a) * 0.6}};
          at = normal * surface_below(world, normal, 0.05 * h);
        },
        1000);
    EXPECT_LT(d.jump, 0.01);
    EXPECT_LT(d.turn, 1.0);
    EXPECT_LT(d.slant, fine == 1 ? 20 : 10);
    EXPECT_LT(d.ripple, 0.1);
    slant[fine - 1] = d.slant;
    std::printf("%d: jump %.4f turn %.3f slant %.2f ripple %.3f\n", fine, d.jump, d.turn, d.slant,
                d.ripple);
  }
  EXPECT_LT(slant[1], 0.7 * slant[0]);
}

/// Random tetrahedra with sizes from 1 to `ratio`.
Mesh<3> tetrahedra(int count, double ratio, bool clustered, std::uint64_t seed) {
  const Random random{seed, 77};
  Mesh<3> all;
  const double side =
      clustered ? 2.5 : (ratio > 1 ? 3.0 : 1.2) * std::cbrt(static_cast<double>(count));
  for (int i = 0; i < count; ++i) {
    const double size = 0.6 * std::pow(ratio, random.uniform(i, 0) - (ratio > 1 ? 0.4 : 0));
    Vec<3> centre{
        {side * random.uniform(i, 1), side * random.uniform(i, 2), side * random.uniform(i, 3)}};
    if (clustered) centre += Vec<3>{{20.0 * (i % 5), 7.0 * (i % 3), 0}};
    const Index first = all.points();
    all.body_names.push_back(std::to_string(i));
    constexpr double kCorner[4][3] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    Vec<3> x[4];
    for (int k = 0; k < 4; ++k) {
      for (int d = 0; d < 3; ++d)
        x[k][d] = centre[d] + size * (kCorner[k][d] + 0.5 * random.uniform(i, 10 + 3 * k + d));
      all.point.push_back({x[k][0], x[k][1], x[k][2]});
    }
    const bool right = determinant(edge_matrix<3>(x)) > 0;
    all.element.push_back({first, first + 1, first + (right ? 2 : 3), first + (right ? 3 : 2)});
    all.body.push_back(i);
  }
  return all;
}

std::vector<std::pair<Index, Index>> brute_force(const ContactWorld<3>& world, double reach,
                                                 std::size_t every = 1) {
  std::vector<std::pair<Index, Index>> list;
  for (std::size_t i = 0; i < world.topology.free.size(); i += every) {
    const ElementFace& face = world.topology.free[i];
    const auto& own = world.mesh.element[face.element];
    for (int q = 0; q < 3; ++q) {
      Vec<3> at = Vec<3>::zero();
      for (int k = 0; k < 3; ++k)
        at += world.x[own[face_node<3>(face.face, k)]] *
              face_weight<3>(q, k, world.surface.own_weight);
      for (Index e = 0; e < world.mesh.elements(); ++e) {
        if (world.mesh.body[e] == world.mesh.body[face.element]) continue;
        Vec<3> x[4];
        for (int k = 0; k < 4; ++k) x[k] = world.x[world.mesh.element[e][k]];
        double l[4];
        if (square_distance_to_simplex<3>(x, at, l) <= reach * reach)
          list.emplace_back((face.element * 4 + face.face) * 3 + q, e);
      }
    }
  }
  return list;
}

// V-054: the candidates are those of brute force, none missing and none too many.
TEST(ContactInSpace, CandidatesEqualBruteForce) {
  for (const bool clustered : {false, true})
    for (const double ratio : {1.0, 50.0}) {
      ContactWorld<3> world(tetrahedra(250, ratio, clustered, 5));
      world.skin = 0.1;
      world.update_surface();
      world.search();
      const auto expected = brute_force(world, world.skin);
      EXPECT_GT(expected.size(), 100u);
      EXPECT_EQ(world.candidates(), expected) << "clustered " << clustered << " ratio " << ratio;
    }
}

TEST(ContactInSpace, CandidatesOfTenThousand) {
  ContactWorld<3> world(tetrahedra(10000, 50.0, false, 6));
  world.skin = 0.1;
  world.update_surface();
  world.search();
  const auto found = world.candidates();
  const auto expected = brute_force(world, world.skin, 1000);
  EXPECT_GT(expected.size(), 50u);
  for (const auto& pair : expected)
    EXPECT_TRUE(std::binary_search(found.begin(), found.end(), pair)) << pair.first;
}

// Nearest points of a triangle and a tetrahedron against a search over their weights.
TEST(ContactInSpace, NearestPoints) {
  const Random random{8, 1};
  for (int i = 0; i < 300; ++i) {
    Vec<3> x[4], q;
    for (int k = 0; k < 4; ++k)
      for (int d = 0; d < 3; ++d) x[k][d] = random.uniform(i, 3 * k + d);
    for (int d = 0; d < 3; ++d) q[d] = 3 * random.uniform(i, 30 + d) - 1;
    double best = 1e9;
    constexpr int kCuts = 24;
    for (int a = 0; a <= kCuts; ++a)
      for (int b = 0; a + b <= kCuts; ++b)
        for (int c = 0; a + b + c <= kCuts; ++c) {
          const Vec<3> p = x[0] + (x[1] - x[0]) * (double(a) / kCuts) +
                           (x[2] - x[0]) * (double(b) / kCuts) +
                           (x[3] - x[0]) * (double(c) / kCuts);
          best = std::min(best, norm(p - q));
        }
    double l[4];
    const double d = std::sqrt(square_distance_to_simplex<3>(x, q, l));
    EXPECT_LE(d, best + 1e-12);
    EXPECT_GT(d, best - 0.08);
    Vec<3> at = Vec<3>::zero();
    double sum = 0;
    for (int k = 0; k < 4; ++k) {
      at += x[k] * l[k];
      sum += l[k];
      EXPECT_GE(l[k], -1e-12);
    }
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_NEAR(norm(at - q), d, 1e-9);
  }
}

}  // namespace
