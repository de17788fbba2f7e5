#include "comm/partition.hpp"
#include "core/error.hpp"
#include "mesh/structured.hpp"

#include <gtest/gtest.h>

namespace breccia {
namespace {

Mesh<2> square(Index cells) {
  Grid<2> grid;
  grid.upper = {1, 1};
  grid.cells = {cells, cells};
  grid.pattern = Pattern::right;
  return structured_mesh(grid);
}

TEST(Partition, OnePartOwnsAllAndHasNoGhosts) {
  const Mesh<2> mesh = square(8);
  const Partition p = partition(mesh, build_topology(mesh), 1);
  EXPECT_EQ(p.imbalance, 1);
  EXPECT_EQ(p.cut_faces, 0);
  EXPECT_EQ(p.ghost_share, 0);
}

TEST(Partition, PartsAreEvenAndCutsAreShort) {
  if (!can_partition()) {
    EXPECT_THROW(partition(square(2), build_topology(square(2)), 2), Error);
    return;
  }
  const Mesh<2> mesh = square(40);
  const Topology<2> topology = build_topology(mesh);
  const Partition p = partition(mesh, topology, 4);
  EXPECT_LT(p.imbalance, 1.05);
  // Two straight cuts through a square of 40 cells cross 80 faces; METIS may wander a little.
  EXPECT_GE(p.cut_faces, 80 / 2);
  EXPECT_LT(p.cut_faces, 2 * 80);
  // One layer of stars on both sides of 80 cell edges: about 4 x 80 of 3200 elements.
  EXPECT_LT(p.ghost_share, 0.2);
  EXPECT_EQ(p.part, partition(mesh, topology, 4).part);
}

TEST(Partition, MorePartsThanElementsAreRefused) {
  const Mesh<2> mesh = square(1);
  EXPECT_THROW(partition(mesh, build_topology(mesh), 3), Error);
}

}  // namespace
}  // namespace breccia
