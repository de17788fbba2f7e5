#include "contact_samples.hpp"
#include "loops/list_tools.hpp"
#include "point/simplex_geometry.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace breccia;

/// Random polygons, fans about a hub, with sizes from 1 to `ratio`.
Mesh<2> polygons(int count, double ratio, bool clustered, std::uint64_t seed) {
  const Random random{seed, 77};
  std::vector<Mesh<2>> bodies;
  Mesh<2> all;
  const double box = clustered ? 3.0 : 1.6 * std::sqrt(static_cast<double>(count));
  for (int i = 0; i < count; ++i) {
    const double radius = 0.4 * std::pow(ratio, random.uniform(i, 0));
    Vec<2> centre{{box * random.uniform(i, 1), box * random.uniform(i, 2)}};
    if (clustered) centre += Vec<2>{{20.0 * (i % 5), 7.0 * (i % 3)}};
    const int sides = 3 + static_cast<int>(6 * random.uniform(i, 3));
    const Index first = all.points();
    all.body_names.push_back(std::to_string(i));
    for (int k = 0; k < sides; ++k) {
      const double angle = 2 * std::numbers::pi * (k + 0.8 * random.uniform(i, 10 + k)) / sides;
      all.point.push_back(
          {centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle)});
    }
    all.point.push_back({centre[0], centre[1]});
    for (int k = 0; k < sides; ++k) {
      all.element.push_back({first + k, first + (k + 1) % sides, first + sides});
      all.body.push_back(i);
    }
  }
  return all;
}

/// Distance test of every contact point against every element of another body.
std::vector<std::pair<Index, Index>> brute_force(const ContactWorld<2>& world, double reach) {
  std::vector<std::pair<Index, Index>> list;
  for (const ElementFace& face : world.topology.free) {
    const auto& own = world.mesh.element[face.element];
    const Vec<2> a = world.x[own[(face.face + 1) % 3]], b = world.x[own[(face.face + 2) % 3]];
    for (int q = 0; q < 2; ++q) {
      const Vec<2> at = a * face_weight<2>(q, 0, world.surface.own_weight) +
                        b * face_weight<2>(q, 1, world.surface.own_weight);
      for (Index e = 0; e < world.mesh.elements(); ++e) {
        if (world.mesh.body[e] == world.mesh.body[face.element]) continue;
        Vec<2> x[3];
        for (int k = 0; k < 3; ++k) x[k] = world.x[world.mesh.element[e][k]];
        double l[3];
        if (square_distance_to_simplex<2>(x, at, l) <= reach * reach)
          list.emplace_back((face.element * 3 + face.face) * 2 + q, e);
      }
    }
  }
  return list;
}

// V-054: the candidates are those of brute force, none missing and none too many.
TEST(ContactSearch, EqualsBruteForce) {
  for (const bool clustered : {false, true})
    for (const double ratio : {1.0, 50.0}) {
      ContactWorld<2> world(polygons(300, ratio, clustered, 5));
      world.skin = 0.1;
      world.update_surface();
      world.search();
      const auto found = world.candidates();
      const auto expected = brute_force(world, world.skin);
      EXPECT_GT(expected.size(), 100u);
      EXPECT_EQ(found, expected) << "clustered " << clustered << " ratio " << ratio;
    }
}

// What is whole, convex and compact is not looked for in itself, and nothing else is left out.
TEST(ContactSearch, WholePiecesDoNotMeetThemselves) {
  ContactWorld<2> world(polygons(300, 10.0, false, 5));
  world.skin = 0.8;  // twice the smallest polygons
  world.update_surface();
  world.search();
  const auto all = world.candidates();
  world.tell_pieces();
  world.search();
  const auto found = world.candidates();
  EXPECT_LT(found.size() + 1000, all.size());
  EXPECT_EQ(found, brute_force(world, world.skin));
}

// V-054 at 1e4 polygons; brute force over a sample of the points.
TEST(ContactSearch, TenThousandPolygons) {
  ContactWorld<2> world(polygons(10000, 50.0, false, 6));
  world.skin = 0.1;
  world.update_surface();
  world.search();
  const auto found = world.candidates();
  ContactWorld<2> sample = world;
  sample.topology.free.clear();
  for (std::size_t i = 0; i < world.topology.free.size(); i += 300)
    sample.topology.free.push_back(world.topology.free[i]);
  for (const auto& pair : brute_force(sample, world.skin))
    EXPECT_TRUE(std::binary_search(found.begin(), found.end(), pair)) << pair.first;
}

// Any motion of up to skin / 2 between two searches finds all its contacts in the old list.
TEST(ContactSearch, SkinCoversMotion) {
  ContactWorld<2> world(polygons(400, 10.0, false, 7));
  world.skin = 0.08;
  world.update_surface();
  world.search();
  const auto found = world.candidates();
  const Random random{11, 3};
  for (std::size_t n = 0; n < world.x.size(); ++n) {
    const double angle = 2 * std::numbers::pi * random.uniform(n);
    world.x[n] += Vec<2>{{std::cos(angle), std::sin(angle)}} * (0.4999 * world.skin);
  }
  const auto now = brute_force(world, 0.0);
  EXPECT_GT(now.size(), 50u);
  for (const auto& pair : now) EXPECT_TRUE(std::binary_search(found.begin(), found.end(), pair));
  EXPECT_NEAR(world.way().way, 0.4999 * world.skin, 1e-12);
}

// The order of the bodies changes names, not forces.
TEST(ContactSearch, OrderOfBodiesDoesNotMatter) {
  const Mesh<2> mesh = polygons(200, 20.0, false, 8);
  Mesh<2> reversed = mesh;
  std::reverse(reversed.element.begin(), reversed.element.end());
  std::reverse(reversed.body.begin(), reversed.body.end());
  ContactWorld<2> a(mesh), b(reversed);
  for (ContactWorld<2>* w : {&a, &b}) {
    w->skin = 0.05;
    w->update_surface();
    w->search();
    w->force();
  }
  EXPECT_EQ(a.pairs.pairs, b.pairs.pairs);
  EXPECT_GT(a.touching(), 20);
  const auto fa = a.node_force(), fb = b.node_force();
  double most = 0;
  for (const auto& f : fa) most = std::max(most, norm(f));
  for (std::size_t n = 0; n < fa.size(); ++n) EXPECT_NEAR(norm(fa[n] - fb[n]), 0.0, 1e-13 * most);
}

TEST(ContactSearch, LongListsAreSorted) {
  Array<Index> list("list", 1000);
  const auto host = Kokkos::create_mirror_view(list);
  for (Index n : {0, 1, 2, 24, 25, 26, 1000}) {
    for (Index i = 0; i < n; ++i) host(i) = static_cast<Index>((i * 7919LL) % 1009);
    sort_list(host.data(), n);
    EXPECT_TRUE(std::is_sorted(host.data(), host.data() + n));
  }
}

}  // namespace
