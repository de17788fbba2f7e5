#include "base/composite.hpp"
#include "mesh/composite.hpp"
#include "mesh/face_table.hpp"
#include "mesh/order.hpp"
#include "mesh/region_builder.hpp"
#include "mesh/topology.hpp"
#include "mesh/validate.hpp"
#include "unit/mesh_samples.hpp"

#include <gmock/gmock.h>

#include <set>

namespace breccia {
namespace {

template <int D, int Group>
struct Kind {
  static constexpr int dimension = D;
  static constexpr int group = Group;
};

/// Unit square or cube of jittered elements.
template <int D>
Mesh<D> jittered() {
  return grid_mesh<D>(3, D == 2 ? Pattern::cross : Pattern::kuhn, 0.2);
}

template <int D>
Mesh<D> refined(const Mesh<D>& mesh, int group) {
  const std::vector<int> groups(mesh.body_names.size(), group);
  return refined_to_composites(mesh, groups);
}

template <class K>
class Composite : public testing::Test {
 protected:
  const Mesh<K::dimension> parent = jittered<K::dimension>();
  const Mesh<K::dimension> mesh = refined(parent, K::group);
};

using Kinds = testing::Types<Kind<2, 4>, Kind<3, 8>, Kind<3, 12>>;
TYPED_TEST_SUITE(Composite, Kinds);

TYPED_TEST(Composite, EachNodeHasItsPlace) {
  constexpr int D = TypeParam::dimension, G = TypeParam::group;
  for (int node = 0; node < composite_nodes<D, G>; ++node) {
    const CompositePlace place = composite_place<D, G>(node);
    EXPECT_EQ((composite_node<D, G>(place.sub, place.corner)), node);
  }
}

// Sub-elements of one composite have its tables' nodes in common, in every composite.
TYPED_TEST(Composite, SubElementsFollowTheTables) {
  constexpr int D = TypeParam::dimension, G = TypeParam::group;
  ASSERT_EQ(this->mesh.elements(), G * this->parent.elements());
  for (Index first = 0; first < this->mesh.elements(); first += G) {
    std::array<Index, composite_nodes<D, G>> node;
    for (int n = 0; n < composite_nodes<D, G>; ++n) {
      const CompositePlace place = composite_place<D, G>(n);
      node[n] = this->mesh.element[first + place.sub][place.corner];
    }
    EXPECT_EQ(std::set<Index>(node.begin(), node.end()).size(), node.size());
    for (int sub = 0; sub < G; ++sub) {
      for (int a = 0; a <= D; ++a) {
        EXPECT_EQ(this->mesh.element[first + sub][a], (node[composite_node<D, G>(sub, a)]));
      }
    }
    for (int m = D + 1; m < (D == 2 ? 6 : 10); ++m) {
      const auto& a = this->mesh.point[node[composite_edge<D>(m, 0)]];
      const auto& b = this->mesh.point[node[composite_edge<D>(m, 1)]];
      const auto off = minus(this->mesh.point[node[m]], along(a, 0.5, minus(b, a)));
      EXPECT_LT(length(off), 1e-15);
    }
  }
}

// A straight composite is cut into equal shares: quarters; eighths; eighths and sixteenths.
TYPED_TEST(Composite, SubElementsArePositiveShares) {
  constexpr int D = TypeParam::dimension, G = TypeParam::group;
  for (Index e = 0; e < this->mesh.elements(); ++e) {
    const Index whole_element = e / G;
    const double whole = signed_volume<D>(corners(this->parent, whole_element));
    const double share = D == 2 ? 0.25 : (G == 12 && e % G > D ? 0.0625 : 0.125);
    EXPECT_NEAR(signed_volume<D>(corners(this->mesh, e)), share * whole, 1e-13 * whole);
  }
}

// Conforming: the outside is that of the parents, in pieces, and every point is used once.
TYPED_TEST(Composite, MeshConforms) {
  constexpr int D = TypeParam::dimension, G = TypeParam::group;
  EXPECT_NO_THROW(validate(this->mesh, "composites"));
  const auto coarse = build_topology(this->parent), fine = build_topology(this->mesh);
  EXPECT_EQ(fine.free.size(), (D == 2 ? 2 : 4) * coarse.free.size());
  std::set<Edge> edges;
  for (const auto& nodes : this->parent.element) {
    for (int a = 0; a <= D; ++a) {
      for (int b = 0; b < a; ++b) edges.insert(edge_of(nodes[a], nodes[b]));
    }
  }
  const auto inside = static_cast<std::size_t>(G == 12 ? this->parent.elements() : 0);
  EXPECT_EQ(this->mesh.point.size(), this->parent.point.size() + edges.size() + inside);
}

// Regions cover the same ground: elements in pieces, faces of the same area, all points on it.
TYPED_TEST(Composite, RegionsFollow) {
  constexpr int D = TypeParam::dimension, G = TypeParam::group;
  const Region& body = *find_region(this->mesh, "body");
  EXPECT_EQ(static_cast<Index>(body.elements.size()), this->mesh.elements());
  EXPECT_EQ(static_cast<Index>(body.points.size()), this->mesh.points());
  EXPECT_EQ(body.faces, free_faces(this->mesh));
  const Region& left = *find_region(this->mesh, "body.left");
  const Region& coarse = *find_region(this->parent, "body.left");
  EXPECT_EQ(left.faces.size(), (D == 2 ? 2 : 4) * coarse.faces.size());
  EXPECT_NEAR(face_area(this->mesh, "body.left"), 1, 1e-13);
  std::vector<Index> on_plane;
  for (Index p = 0; p < this->mesh.points(); ++p) {
    if (this->mesh.point[p][0] == 0) on_plane.push_back(p);
  }
  EXPECT_EQ(left.points, on_plane);
  EXPECT_EQ(this->mesh.group_size, (std::vector<int>{G}));
}

TYPED_TEST(Composite, PointsAreNumberedByFirstUse) {
  Index next = 0;
  for (const auto& nodes : this->mesh.element) {
    for (Index p : nodes) {
      ASSERT_LE(p, next);
      if (p == next) ++next;
    }
  }
}

// The shortest of the three diagonals is node 4 to node 9, whichever way the vertices were given.
TEST(CompositeSpace, OctahedronIsCutAlongItsShortestDiagonal) {
  Mesh<3> parent = jittered<3>();
  parent.regions.clear();
  for (Index e = 0; e < parent.elements(); ++e) {
    auto& v = parent.element[e];
    if (e % 3 == 1) v = {v[1], v[2], v[0], v[3]};
    if (e % 3 == 2) v = {v[2], v[3], v[0], v[1]};
  }
  const auto mesh = refined(parent, 8);
  const auto at = [&](Index first, int node) {
    const CompositePlace place = composite_place<3, 8>(node);
    return mesh.point[mesh.element[first + place.sub][place.corner]];
  };
  for (Index first = 0; first < mesh.elements(); first += 8) {
    const double cut = length(minus(at(first, 4), at(first, 9)));
    EXPECT_LE(cut, length(minus(at(first, 5), at(first, 7))) * (1 + 1e-9));
    EXPECT_LE(cut, length(minus(at(first, 6), at(first, 8))) * (1 + 1e-9));
  }
}

// A regular tetrahedron has three equal diagonals: the choice is by numbers, not by rounding.
TEST(CompositeSpace, EqualDiagonalsAreChosenByPointNumber) {
  for (const std::array<Index, 4>& order :
       {std::array<Index, 4>{0, 1, 2, 3}, {0, 2, 3, 1}, {3, 1, 0, 2}}) {
    Mesh<3> parent = one_tetrahedron();
    parent.point = {{1, 1, 1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, 1}};
    parent.element = {order};
    if (signed_volume<3>(corners(parent, 0)) < 0)
      std::swap(parent.element[0][0], parent.element[0][1]);
    const auto mesh = refined(parent, 8);
    // m01 and m23 of points 0 to 3 lie on the y axis.
    for (int node : {4, 9}) {
      const CompositePlace place = composite_place<3, 8>(node);
      const auto& x = mesh.point[mesh.element[place.sub][place.corner]];
      EXPECT_EQ(std::abs(x[1]), 1) << "node " << node;
    }
  }
}

// Two bodies of one kind of material and two kinds of elements; a point region and a curve.
TEST(CompositeBodies, SimpleOnesStayAsTheyAre) {
  auto mesh = grid_mesh<2>(2, Pattern::right);
  Grid<2> other;
  other.lower = {1, 0};
  other.upper = {2, 1};
  other.cells = {2, 2};
  other.body = "other";
  append(mesh, structured_mesh(other));
  const std::vector<int> groups = {1, 4};
  const auto both = refined_to_composites(mesh, groups);
  EXPECT_EQ(both.elements(), 8 + 4 * 16);
  EXPECT_EQ(find_region(both, "body")->elements.size(), 8U);
  EXPECT_EQ(find_region(both, "other")->elements.size(), 64U);
  EXPECT_NEAR(face_area(both, "body.top"), 1, 1e-14);
  EXPECT_NEAR(face_area(both, "other.top"), 1, 1e-14);
  const auto composite = composite_of_elements(both);
  EXPECT_EQ(composite[7], 7);
  EXPECT_EQ(composite[8], 8);
  EXPECT_EQ(composite[11], 8);
  EXPECT_EQ(composite[12], 9);
  EXPECT_EQ(composite.back(), 8 + 16 - 1);
}

TEST(CompositeBodies, WithoutCompositesNothingChanges) {
  const auto mesh = grid_mesh<3>(2, Pattern::five);
  expect_same_mesh(refined(mesh, 1), mesh);
}

TEST(CompositeRegions, PointsAndCurves) {
  auto plane = two_triangles();
  plane.regions.push_back({"supports", {}, {}, {0, 1}});
  EXPECT_EQ(find_region(refined(plane, 4), "supports")->points.size(), 2U);
  auto space = one_tetrahedron();
  space.regions.push_back({"edge", {}, {}, {0, 1}});
  const auto mesh = refined(space, 8);
  const auto& points = find_region(mesh, "edge")->points;
  ASSERT_EQ(points.size(), 3U);
  double sum = 0;
  for (Index p : points) {
    EXPECT_EQ(mesh.point[p][1], 0);
    EXPECT_EQ(mesh.point[p][2], 0);
    sum += mesh.point[p][0];
  }
  EXPECT_EQ(sum, 1.5);
}

// A curved edge that would turn a sub-element over is made straight, and its neighbour follows.
TEST(CompositeCurved, TooMuchIsMadeStraight) {
  auto parent = two_triangles();
  const auto area = [&](const Point<2>& middle) {
    parent.curved = {{edge_of(0, 2), middle}};
    const auto mesh = refined(parent, 4);
    EXPECT_NO_THROW(validate(mesh, "curved"));
    double lower = 0;
    for (Index e = 0; e < 4; ++e) lower += signed_volume<2>(corners(mesh, e));
    return lower;
  };
  EXPECT_NEAR(area({0.45, 0.55}), 0.55, 1e-15);  // 0.5 + 0.5 * |diagonal| * shift
  EXPECT_NEAR(area({0.05, 0.95}), 0.5, 1e-15);
}

TEST(CompositeCurved, RenumberedWithTheMesh) {
  auto mesh = two_triangles();
  mesh.curved = {{edge_of(0, 2), {0.45, 0.55}}};
  auto both = mesh;
  mesh.body_names = {"other"};
  append(both, mesh);
  ASSERT_EQ(both.curved.size(), 2U);
  EXPECT_TRUE(both.curved.count({4, 6}));
  Ordering turned{{3, 2, 1, 0}, {7, 6, 5, 4, 3, 2, 1, 0}};
  const auto reversed = reordered(both, turned);
  EXPECT_TRUE(reversed.curved.count({1, 3}));
  EXPECT_TRUE(reversed.curved.count({5, 7}));
}

}  // namespace
}  // namespace breccia
