// A part of a mesh knows as much of its elements as the whole does.
#include "core/random.hpp"
#include "mesh/part.hpp"
#include "mesh_samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace breccia {
namespace {

/// Every third element of the lower half, which leaves gaps.
template <int D>
std::vector<Index> some_elements(const Mesh<D>& mesh) {
  std::vector<Index> list;
  for (Index e = 0; e < mesh.elements() / 2; ++e)
    if (e % 3 != 1) list.push_back(e);
  return list;
}

template <int D>
void check_part() {
  const Mesh<D> mesh = grid_mesh<D>(4, D == 2 ? Pattern::cross : Pattern::kuhn, 0.2);
  const Topology<D> topology = build_topology(mesh);
  const MeshPart<D> part = take_part(mesh, topology, some_elements(mesh));
  const std::set<Index> inside(part.element.begin(), part.element.end());

  ASSERT_EQ(part.mesh.element.size(), part.element.size());
  for (std::size_t e = 0; e < part.element.size(); ++e)
    for (int a = 0; a <= D; ++a) {
      const Index family = part.mesh.element[e][a];
      EXPECT_EQ(part.family[family], mesh.element[part.element[e]][a]);
      EXPECT_EQ(part.mesh.point[family], mesh.point[part.family[family]]);
    }
  // Faces: those with both elements inside, in their order, and the free ones.
  std::vector<Index> expected;
  std::size_t free = 0;
  for (std::size_t f = 0; f < topology.shared.size(); ++f)
    if (inside.count(topology.shared[f].left) && inside.count(topology.shared[f].right))
      expected.push_back(static_cast<Index>(f));
  for (const ElementFace& face : topology.free) free += inside.count(face.element);
  EXPECT_EQ(part.face, expected);
  EXPECT_EQ(part.topology.free.size(), free);
  for (std::size_t f = 0; f < part.face.size(); ++f) {
    const SharedFace &here = part.topology.shared[f], &there = topology.shared[part.face[f]];
    EXPECT_EQ(part.element[here.left], there.left);
    EXPECT_EQ(part.element[here.right], there.right);
    EXPECT_EQ(here.rotation, there.rotation);
  }
}

TEST(MeshPart, HasTheElementsFacesAndPlacesOfTheWhole) {
  check_part<2>();
  check_part<3>();
}

// A whole star keeps all its corners in their order; at the rim each corner is by itself.
TEST(MeshPart, PointsAtTheRimBelongToOneCorner) {
  const Mesh<2> mesh = grid_mesh<2>(6, Pattern::right);
  const Topology<2> topology = build_topology(mesh);
  const MeshPart<2> part = take_part(mesh, topology, some_elements(mesh));
  const std::set<Index> inside(part.element.begin(), part.element.end());
  int whole = 0, rim = 0;
  for (std::size_t f = 0; f < part.family.size(); ++f) {
    const Index point = part.family[f];
    bool complete = true;
    for (Index k = topology.family_start[point]; k < topology.family_start[point + 1]; ++k)
      complete = complete && inside.count(topology.family_corner[k] / 3) != 0;
    const Index corners = part.topology.family_start[f + 1] - part.topology.family_start[f];
    EXPECT_EQ(corners,
              complete ? topology.family_start[point + 1] - topology.family_start[point] : 1);
    (complete ? whole : rim) += 1;
  }
  EXPECT_GT(whole, 0);
  EXPECT_GT(rim, 0);
  EXPECT_EQ(part.topology.family_corner.size(), 3 * part.element.size());
}

TEST(MeshPart, TheWholeIsAPartOfItself) {
  const Mesh<3> mesh = grid_mesh<3>(3, Pattern::kuhn);
  const Topology<3> topology = build_topology(mesh);
  std::vector<Index> all(mesh.element.size());
  for (std::size_t e = 0; e < all.size(); ++e) all[e] = static_cast<Index>(e);
  const MeshPart<3> part = take_part(mesh, topology, all);
  EXPECT_EQ(part.mesh.element, mesh.element);
  EXPECT_EQ(part.topology.family_corner, topology.family_corner);
  EXPECT_EQ(part.mesh.regions.size(), mesh.regions.size());
  EXPECT_EQ(part.mesh.regions.front().points, mesh.regions.front().points);
}

TEST(MeshPart, NeighboursShareAPoint) {
  const Mesh<2> mesh = grid_mesh<2>(7, Pattern::cross);
  const Topology<2> topology = build_topology(mesh);
  std::vector<Index> chosen{5, 60};
  for (int ring = 1; ring <= 2; ++ring) {
    std::set<Index> points;
    for (const Index e : chosen) points.insert(mesh.element[e].begin(), mesh.element[e].end());
    std::vector<Index> expected;
    for (Index e = 0; e < mesh.elements(); ++e)
      if (std::any_of(mesh.element[e].begin(), mesh.element[e].end(),
                      [&](Index n) { return points.count(n) != 0; }))
        expected.push_back(e);
    chosen = expected;
    EXPECT_EQ(with_neighbours(mesh, topology, {5, 60}, ring), expected);
  }
}

template <int D>
void check_near() {
  const Random random{1, 7};
  std::vector<AxisBox<D>> boxes(400);
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t d = 0; d < D; ++d) {
      boxes[i].low[d] = random.uniform(i, static_cast<std::uint32_t>(d));
      // Sizes of 1 to 50.
      boxes[i].high[d] = boxes[i].low[d] + 0.002 * std::pow(50.0, random.uniform(i, 7));
    }
  const std::vector<Index> chosen{3, 77, 210};
  for (const double reach : {0.0, 0.03, 0.2}) {
    std::vector<Index> expected;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      bool near = false;
      for (const Index j : chosen) {
        bool touch = true;
        for (std::size_t d = 0; d < D; ++d)
          touch = touch && boxes[i].low[d] <= boxes[j].high[d] + reach &&
                  boxes[j].low[d] - reach <= boxes[i].high[d];
        near = near || touch;
      }
      if (near) expected.push_back(static_cast<Index>(i));
    }
    EXPECT_EQ(boxes_near<D>(boxes, chosen, reach), expected) << reach;
  }
}

TEST(MeshPart, BoxesNearAreThoseOfBruteForce) {
  check_near<2>();
  check_near<3>();
}

}  // namespace
}  // namespace breccia
