#include "core/random.hpp"
#include "mesh/geometry.hpp"
#include "mesh/hilbert.hpp"
#include "mesh/order.hpp"
#include "mesh/topology.hpp"
#include "unit/mesh_samples.hpp"

#include <algorithm>
#include <numeric>

namespace breccia {
namespace {

template <int D>
void check_curve(std::uint32_t side, int bits) {
  std::vector<std::array<std::uint32_t, D>> at(D == 2 ? side * side : side * side * side);
  std::vector<char> seen(at.size(), 0);
  std::array<std::uint32_t, D> x{};
  for (std::size_t n = 0; n < at.size(); ++n) {
    std::size_t rest = n;
    for (int k = 0; k < D; ++k) {
      x[k] = static_cast<std::uint32_t>(rest % side);
      rest /= side;
    }
    const auto position = hilbert_position<D>(x, bits);
    ASSERT_LT(position, at.size());
    ASSERT_FALSE(seen[position]);
    seen[position] = 1;
    at[position] = x;
  }
  for (std::size_t n = 1; n < at.size(); ++n) {
    int distance = 0;
    for (int k = 0; k < D; ++k) {
      distance += std::abs(static_cast<int>(at[n][k]) - static_cast<int>(at[n - 1][k]));
    }
    ASSERT_EQ(distance, 1) << "at " << n;
  }
}

TEST(MeshHilbert, VisitsEveryCellThroughNeighbours) {
  check_curve<2>(16, 4);
  check_curve<3>(8, 3);
}

/// The mesh with elements and points in a random order.
template <int D>
Mesh<D> shuffled(const Mesh<D>& mesh) {
  Ordering ordering;
  ordering.element.resize(mesh.element.size());
  ordering.point.resize(mesh.point.size());
  const Random random{3, 0};
  for (auto* list : {&ordering.element, &ordering.point}) {
    std::iota(list->begin(), list->end(), 0);
    std::sort(list->begin(), list->end(), [&](Index a, Index b) {
      return std::pair{random.uniform(a), a} < std::pair{random.uniform(b), b};
    });
  }
  return reordered(mesh, ordering);
}

template <int D>
void check_locality(const Mesh<D>& mesh, double bound) {
  const auto mixed = shuffled(mesh);
  EXPECT_NEAR(mean_index_distance(mixed), 1.0 / 3, 0.02);  // random numbers: 1/3
  const auto ordered = reordered(mixed, locality_order(mixed));
  EXPECT_LT(mean_index_distance(ordered), bound);
}

// A square cut into n points has index distances near n^-1/2; three times that leaves room for the
// jumps of the curve. In space n^-1/3.
TEST(MeshOrder, NeighboursAreNearInMemory) {
  check_locality(grid_mesh<2>(64, Pattern::cross), 3 / std::sqrt(8321.0));
  check_locality(grid_mesh<3>(16, Pattern::kuhn), 1 / std::cbrt(4913.0));
}

TEST(MeshOrder, KeepsGeometryAndRegions) {
  const auto mesh = grid_mesh<3>(4, Pattern::kuhn, 0.2);
  const auto mixed = shuffled(mesh);
  EXPECT_NEAR(total_volume(mixed), 1, 1e-13);
  ASSERT_EQ(mixed.regions.size(), mesh.regions.size());
  for (std::size_t r = 0; r < mesh.regions.size(); ++r) {
    const Region& a = mesh.regions[r];
    const Region& b = mixed.regions[r];
    EXPECT_EQ(a.faces.size(), b.faces.size());
    EXPECT_TRUE(std::is_sorted(b.faces.begin(), b.faces.end()));
    Point<3> sum_a{}, sum_b{};
    for (const auto& f : a.faces) {
      sum_a = along(sum_a, 1, face_normal_area<3>(corners(mesh, f.element), f.face));
    }
    for (const auto& f : b.faces) {
      sum_b = along(sum_b, 1, face_normal_area<3>(corners(mixed, f.element), f.face));
    }
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(sum_a[k], sum_b[k], 1e-13) << a.name;
    std::vector<Point<3>> at_a, at_b;
    for (Index p : a.points) at_a.push_back(mesh.point[p]);
    for (Index p : b.points) at_b.push_back(mixed.point[p]);
    std::sort(at_a.begin(), at_a.end());
    std::sort(at_b.begin(), at_b.end());
    EXPECT_EQ(at_a, at_b) << a.name;
  }
}

TEST(MeshOrder, BlocksAreContiguousAndInOrder) {
  const auto mesh = shuffled(grid_mesh<2>(8, Pattern::cross));
  std::vector<Index> block;
  for (Index e = 0; e < mesh.elements(); ++e) block.push_back(e % 3);
  const auto ordering = locality_order<2>(mesh, block);
  for (std::size_t n = 1; n < ordering.element.size(); ++n) {
    EXPECT_LE(block[ordering.element[n - 1]], block[ordering.element[n]]);
  }
}

TEST(MeshOrder, DoesNotDependOnTheInputOrder) {
  const auto mesh = grid_mesh<2>(16, Pattern::right, 0.25);
  const auto a = reordered(mesh, locality_order(mesh));
  const auto mixed = shuffled(mesh);
  const auto b = reordered(mixed, locality_order(mixed));
  // Local node order travels with the element, so equal geometry means equal numbers.
  EXPECT_EQ(a.point, b.point);
  EXPECT_EQ(a.element, b.element);
  expect_same_regions(a, b);
}

}  // namespace
}  // namespace breccia
