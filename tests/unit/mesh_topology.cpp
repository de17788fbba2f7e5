#include "base/simplex.hpp"
#include "mesh/geometry.hpp"
#include "mesh/topology.hpp"
#include "unit/mesh_samples.hpp"

#include <gmock/gmock.h>

#include <algorithm>

namespace breccia {
namespace {

using testing::HasSubstr;

TEST(MeshSimplex, FaceNodesGiveOutwardNormals) {
  const Simplex<2> triangle = {{{0.1, 0.2}, {1.3, 0.1}, {0.4, 0.9}}};
  const Simplex<3> tet = {{{0.1, 0, 0.2}, {1, 0.1, 0}, {0.2, 1.1, 0}, {0.1, 0.3, 0.9}}};
  ASSERT_GT(signed_volume<2>(triangle), 0);
  ASSERT_GT(signed_volume<3>(tet), 0);
  for (int f = 0; f < 3; ++f) {
    const auto n = face_normal_area<2>(triangle, f);
    const auto inwards = minus(triangle[f], triangle[face_node<2>(f, 0)]);
    // The height over a face is minus the inward component: area * height = D * volume.
    EXPECT_NEAR(-dot(n, inwards), 2 * signed_volume<2>(triangle), 1e-15);
  }
  for (int f = 0; f < 4; ++f) {
    const auto n = face_normal_area<3>(tet, f);
    const auto inwards = minus(tet[f], tet[face_node<3>(f, 0)]);
    EXPECT_NEAR(-dot(n, inwards), 3 * signed_volume<3>(tet), 1e-15);
  }
}

TEST(MeshSimplex, OppositeFaceNodeIsItsOwnInverse) {
  for (int rotation = 0; rotation < 3; ++rotation) {
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(opposite_face_node<3>(rotation, opposite_face_node<3>(rotation, i)), i);
    }
  }
  EXPECT_EQ(opposite_face_node<2>(1, 0), 1);
  EXPECT_EQ(opposite_face_node<2>(1, 1), 0);
}

template <int D>
void check_pairing(const Mesh<D>& mesh) {
  const auto topology = build_topology(mesh);
  EXPECT_EQ(2 * topology.shared.size() + topology.free.size(), mesh.element.size() * (D + 1));
  for (const SharedFace& face : topology.shared) {
    ASSERT_LT(face.left, face.right);
    for (int i = 0; i < D; ++i) {
      const int j = opposite_face_node<D>(face.rotation, i);
      ASSERT_EQ(mesh.element[face.left][face_node<D>(face.left_face, i)],
                mesh.element[face.right][face_node<D>(face.right_face, j)]);
    }
  }
  EXPECT_TRUE(std::is_sorted(
      topology.shared.begin(), topology.shared.end(), [](const auto& a, const auto& b) {
        return std::pair{a.left, a.left_face} < std::pair{b.left, b.left_face};
      }));
  EXPECT_TRUE(std::is_sorted(topology.free.begin(), topology.free.end()));
}

template <int D>
void check_families(const Mesh<D>& mesh) {
  const auto topology = build_topology(mesh);
  ASSERT_EQ(topology.family_start.size(), mesh.point.size() + 1);
  ASSERT_EQ(topology.family_corner.size(), mesh.element.size() * (D + 1));
  for (Index p = 0; p < mesh.points(); ++p) {
    const auto begin = topology.family_corner.begin() + topology.family_start[p];
    const auto end = topology.family_corner.begin() + topology.family_start[p + 1];
    EXPECT_TRUE(std::is_sorted(begin, end));
    for (auto c = begin; c != end; ++c) EXPECT_EQ(mesh.element[*c / (D + 1)][*c % (D + 1)], p);
  }
}

TEST(MeshTopology, EveryFaceOfAGridIsPairedOrFree) {
  for (Pattern pattern : {Pattern::right, Pattern::cross, Pattern::union_jack}) {
    check_pairing(grid_mesh<2>(5, pattern));
  }
  check_pairing(grid_mesh<3>(4, Pattern::kuhn));
  check_pairing(grid_mesh<3>(4, Pattern::five));
}

TEST(MeshTopology, FamiliesListTheirCornersInOrder) {
  check_families(grid_mesh<2>(4, Pattern::cross));
  check_families(grid_mesh<3>(3, Pattern::kuhn));
}

TEST(MeshTopology, FaceNumbersLeadBackToTheFaces) {
  const auto mesh = grid_mesh<3>(2, Pattern::kuhn);
  const auto topology = build_topology(mesh);
  const auto number = face_numbers(topology);
  ASSERT_EQ(number.size(), mesh.element.size() * 4);
  for (std::size_t n = 0; n < number.size(); ++n) {
    const ElementFace side{static_cast<Index>(n / 4), static_cast<int>(n % 4)};
    if (number[n] < 0) {
      EXPECT_EQ(topology.free[-1 - number[n]], side);
    } else {
      const SharedFace& f = topology.shared[number[n]];
      EXPECT_TRUE((side == ElementFace{f.left, f.left_face}) ||
                  (side == ElementFace{f.right, f.right_face}));
    }
  }
}

TEST(MeshTopology, RefusesThreeElementsOnOneFace) {
  auto mesh = two_triangles();
  mesh.point.push_back({2, 0.5});
  mesh.element.push_back({0, 4, 2});
  mesh.body.push_back(0);
  EXPECT_THAT(error_text([&] { build_topology(mesh); }),
              HasSubstr("the elements 0, 1 and 2 share one face"));
}

TEST(MeshTopology, RefusesTwoElementsOnTheSameSide) {
  auto mesh = two_triangles();
  mesh.element[1] = {0, 1, 3};
  EXPECT_THAT(error_text([&] { build_topology(mesh); }),
              HasSubstr("the elements 0 and 1 lie on the same side"));
}

}  // namespace
}  // namespace breccia
