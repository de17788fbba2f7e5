#include "harness/fracture_world.hpp"
#include "mesh/geometry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

namespace breccia {
namespace {

std::string law(const std::string& alpha) {
  return "[fracture.rock]\ntensile_strength = 8e6\ncohesion = 24e6\nfriction_angle = \"50 deg\"\n"
         "energy_tension = 50\nenergy_shear = 500\nalpha = " +
         alpha + "\n";
}

const std::string kBetween =
    "[[interface]]\nbetween = [\"rock\", \"other\"]\ntensile_strength = 8e6\ncohesion = 24e6\n"
    "energy_tension = 50\nenergy_shear = 500\nalpha = 0\n";

/// Every corner belongs to one node of its family, corner lists are sorted, masses are the sums of
/// the corners' and add up to the body's, and no node is empty.
template <int D>
void check_books(FractureWorld<D>& world) {
  const auto nodes = world.template host<ElementNodes<D>>();
  const auto ranges = world.template host<NodeCorners>();
  const auto list = world.template host<CornerList>();
  const auto family = world.template host<NodeFamily>();
  const auto mass = world.template host<NodeMass>();
  const auto stretch = world.template host<FamilyCorners>();
  const Mesh<D>& mesh = world.model.mesh;
  std::vector<int> seen(mesh.element.size() * (D + 1), 0);
  double total = 0;
  for (Index n = 0; n < world.model.nodes(); ++n) {
    ASSERT_LT(ranges(n, 0), ranges(n, 1)) << "node " << n << " has no corner";
    ASSERT_GE(ranges(n, 0), stretch(family(n), 0));
    ASSERT_LE(ranges(n, 1), stretch(family(n), 1));
    double sum = 0;
    for (Index k = ranges(n, 0); k < ranges(n, 1); ++k) {
      const Index e = list(k) / (D + 1), a = list(k) % (D + 1);
      if (k > ranges(n, 0)) {
        ASSERT_LT(list(k - 1), list(k));
      }
      EXPECT_EQ(nodes(e, a), n);
      EXPECT_EQ(family(n), mesh.element[e][a]);
      ++seen[static_cast<std::size_t>(list(k))];
      double volume = 1;
      Mat<D> g;
      for (int j = 0; j < D; ++j)
        for (int i = 0; i < D; ++i)
          g(i, j) = mesh.point[mesh.element[e][j + 1]][i] - mesh.point[mesh.element[e][0]][i];
      volume = determinant(g) / (D == 2 ? 2 : 6);
      sum += 2650 * volume / (D + 1);
      total += 2650 * volume / (D + 1);
    }
    EXPECT_NEAR(mass(n), sum, 1e-14 * sum);
  }
  for (const int s : seen) EXPECT_EQ(s, 1);
  double of_nodes = 0;
  for (Index n = 0; n < world.model.nodes(); ++n) of_nodes += mass(n);
  EXPECT_NEAR(of_nodes, total, 1e-13 * total);
}

/// Moves elements whose centroid fulfils the condition to the second body. Both have the same
/// elasticity, so that the blocks of the element loop may stay as they are.
template <int D>
typename FractureWorld<D>::Edit give_to_other(bool (*condition)(const Point<D>&)) {
  return [condition](Model<D>& model) {
    for (Index e = 0; e < model.elements(); ++e)
      if (model.mesh.body[e] == 0 && condition(centroid<D>(corners(model.mesh, e))))
        model.mesh.body[e] = 1;
  };
}

TEST(SplitStars, FourTrianglesAboutACentreOpenAlongADiagonal) {
  // The upper and right triangles go to the other material; the cell is 1 mm wide.
  const auto upper_right = [](const Point<2>& c) { return c[0] + c[1] > 1e-3; };
  FractureWorld<2> world(block_scene(2, "cross", "[1, 1]", "[1e-3, 1e-3]", kBetween),
                         give_to_other<2>(upper_right));
  const Index before = world.model.nodes();
  world.start();
  // Centre and the two ends of the diagonal.
  EXPECT_EQ(world.model.nodes(), before + 3);
  check_books(world);
  const auto family = world.host<NodeFamily>();
  const auto x = world.host<NodePosition<2>>();
  const auto ranges = world.host<NodeCorners>();
  const auto list = world.host<CornerList>();
  for (Index n = before; n < world.model.nodes(); ++n) {
    for (int d = 0; d < 2; ++d) EXPECT_EQ(x(n, d), x(family(n), d));
    // The component with the smallest corner keeps the old node; new ones follow by family.
    EXPECT_LT(list(ranges(family(n), 0)), list(ranges(n, 0)));
    if (n > before) {
      EXPECT_LT(family(n - 1), family(n));
    }
  }
  const auto active = world.host<InterfaceActive<2>>();
  ASSERT_EQ(world.model.store.count(Entity::interface), 2);
  for (Index i = 0; i < 2; ++i)
    for (int c = 0; c < 2; ++c) EXPECT_EQ(active(i, c), 1);
}

TEST(SplitStars, OneInnerFaceStaysLocked) {
  // Of a 3 x 3 block only one triangle's neighbour at the centre is of the other material; its
  // three faces open, each at the corners that get free.
  const auto one = [](const Point<2>& c) {
    return std::abs(c[0] - 1.5e-3) < 1e-4 && c[1] > 1.5e-3 && c[1] < 2e-3;
  };
  FractureWorld<2> world(block_scene(2, "cross", "[3, 3]", "[3e-3, 3e-3]", kBetween),
                         give_to_other<2>(one));
  const Index before = world.model.nodes();
  world.start();
  EXPECT_EQ(world.model.store.count(Entity::interface), 3);
  EXPECT_EQ(world.model.nodes(), before + 3);
  check_books(world);
}

/// Every face but one is tied, and that one lies inside: it becomes an interface that cannot open.
template <int D>
void check_single_face(const std::string& pattern, const std::string& cells,
                       const std::string& size) {
  FractureWorld<D> world(block_scene(D, pattern, cells, size, law("1e-9")));
  world.start();
  const Index before = world.model.nodes();
  std::set<Index> surface;
  for (const ElementFace& face : world.model.topology.free)
    for (int i = 0; i < D; ++i)
      surface.insert(world.model.mesh.element[face.element][face_node<D>(face.face, i)]);
  const auto status = world.template host<FaceStatus>();
  Index inner = kNone;
  for (std::size_t f = 0; f < status.extent(0); ++f) {
    const SharedFace& face = world.model.topology.shared[f];
    bool inside = true;
    for (int i = 0; i < D; ++i)
      inside =
          inside &&
          surface.count(world.model.mesh.element[face.left][face_node<D>(face.left_face, i)]) == 0;
    status(f) = face_status::tied;
    if (inside) inner = static_cast<Index>(f);
  }
  ASSERT_NE(inner, kNone);
  status(inner) = face_status::bonded;
  Kokkos::deep_copy(world.model.store.template get<FaceStatus>(), status);
  world.set_velocity([](const Vec<D>& x) { return x * 1.0; });
  for (int i = 0; i < 20; ++i) world.step();
  EXPECT_EQ(world.model.store.count(Entity::interface), 1);
  EXPECT_EQ(world.model.nodes(), before);
  const auto active = world.template host<InterfaceActive<D>>();
  for (int c = 0; c < D; ++c) EXPECT_EQ(active(0, c), 0);
  const auto force = world.template host<InterfaceForce<D>>();
  for (Index e = 0; e < world.model.elements(); ++e)
    for (int a = 0; a <= D; ++a)
      for (int d = 0; d < D; ++d) EXPECT_EQ(force(e, a, d), 0);
}

TEST(SplitStars, SingleFaceInsideOpensNowhere) {
  check_single_face<2>("cross", "[4, 4]", "[4e-3, 4e-3]");
  check_single_face<3>("kuhn", "[4, 4, 4]", "[4e-3, 4e-3, 4e-3]");
}

TEST(SplitStars, EverythingFromTheStart) {
  FractureWorld<2> plane(block_scene(2, "union-jack", "[3, 4]", "[3e-3, 4e-3]", law("0")));
  plane.start();
  EXPECT_EQ(plane.model.nodes(), 3 * 24 + 4);  // the spare body stays whole
  check_books(plane);
  for (const std::string pattern : {"kuhn", "five"}) {
    FractureWorld<3> space(block_scene(3, pattern, "[2, 2, 2]", "[2e-3, 2e-3, 2e-3]", law("0")));
    space.start();
    const Index rock = static_cast<Index>(
        std::count(space.model.mesh.body.begin(), space.model.mesh.body.end(), 0));
    EXPECT_EQ(space.model.nodes(), 4 * rock + 8);
    check_books(space);
    const auto active = space.host<InterfaceActive<3>>();
    for (Index i = 0; i < space.model.store.count(Entity::interface); ++i)
      for (int c = 0; c < 3; ++c) EXPECT_EQ(active(i, c), 1);
  }
}

// Faces inside a composite are tied: after all others have opened, each has its nodes to itself.
TEST(SplitStars, CompositesStayWhole) {
  FractureWorld<2> plane(
      block_scene(2, "union-jack", "[3, 4], element = \"tri6c\"", "[3e-3, 4e-3]", law("0")));
  plane.start();
  EXPECT_EQ(plane.model.nodes(), 6 * 24 + 4);
  EXPECT_EQ(plane.model.store.count(Entity::interface), 2 * (3 * 3 + 4 * 2 + 12));
  check_books(plane);
  const std::string cells = "[2, 2, 2], element = ";
  for (const auto& [kind, nodes] : {std::pair{"\"tet10c\"", 10}, std::pair{"\"tet10c12\"", 11}}) {
    FractureWorld<3> space(block_scene(3, "five", cells + kind, "[2e-3, 2e-3, 2e-3]", law("0")));
    space.start();
    EXPECT_EQ(space.model.nodes(), nodes * 5 * 8 + 8);
    check_books(space);
  }
}

// Elements of one block are of one material and one kind, and its composites begin with it.
TEST(SplitStars, BlocksAreOfOneKind) {
  std::string scene =
      block_scene(2, "cross", "[3, 4], element = \"tri6c\"", "[3e-3, 4e-3]", law("1"));
  scene.replace(scene.find("\"other\""), 7, "\"rock\"");  // both bodies of one material
  const FractureWorld<2> world(scene);
  const auto& blocks = world.model.blocks;
  ASSERT_EQ(blocks.size(), 2U);
  EXPECT_EQ(blocks[0].group, 1);
  EXPECT_EQ(blocks[0].end - blocks[0].begin, 4);
  EXPECT_EQ(blocks[1].group, 4);
  EXPECT_EQ(blocks[1].end - blocks[1].begin, 4 * 48);
}

/// Two triangles that share nothing but a point.
void make_hinge(Model<2>& model) {
  model.mesh.point = {{0, 0}, {1e-3, 0}, {1e-3, 1e-3}, {2e-3, 1e-3}, {2e-3, 2e-3}};
  model.mesh.element = {{0, 1, 2}, {2, 3, 4}};
  model.mesh.body = {0, 0};
  model.topology = build_topology(model.mesh);
  model.blocks = {{0, 2, 0, 1, kNone, {}}};
  model.store.set_size(Entity::node, 5, 5);
  model.store.set_size(Entity::corner, 6, 6);
  model.store.set_size(Entity::element, 2, 18);
  model.store.set_size(Entity::family, 5, 5);
}

TEST(SplitStars, HingesAreTwoNodesFromTheStart) {
  FractureWorld<2> world(block_scene(2, "cross", "[1, 1]", "[1e-3, 1e-3]", law("1")), make_hinge);
  world.start();
  EXPECT_EQ(world.model.nodes(), 6);
  EXPECT_GE(world.model.store.capacity(Entity::node), 6);
  check_books(world);
}

/// Random forces on all corners, random hot elements whose faces all reach a tiny onset: any number
/// of components per node, some of them locked. No corner may feel another acceleration.
template <int D>
void check_random_insertion(const std::string& pattern, const std::string& cells,
                            const std::string& size, double share_hot, int seed) {
  FractureWorld<D> world(block_scene(D, pattern, cells, size, law("1e-9")));
  world.start();
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  std::normal_distribution<double> gauss;
  std::uniform_real_distribution<double> unit;
  for (int round = 0; round < 3; ++round) {
    // Stress everywhere, so that every face of a hot element reaches the onset.
    const auto x = world.template host<NodePosition<D>>();
    for (Index n = 0; n < world.model.nodes(); ++n)
      for (int d = 0; d < D; ++d) x(n, d) *= 1.001;
    Kokkos::deep_copy(world.model.store.template get<NodePosition<D>>(), x);
    const auto force = world.template host<ElementForce<D>>();
    for (Index e = 0; e < world.model.elements(); ++e)
      for (int a = 0; a <= D; ++a)
        for (int d = 0; d < D; ++d) force(e, a, d) = 1e4 * gauss(random);
    Kokkos::deep_copy(world.model.store.template get<ElementForce<D>>(), force);
    const auto hot = world.template host<ElementHot>();
    for (Index e = 0; e < world.model.elements(); ++e)
      if (unit(random) < share_hot) hot(e / kWordBits) |= BitWord{1} << (e % kWordBits);
    Kokkos::deep_copy(world.model.store.template get<ElementHot>(), hot);

    const std::vector<double> before = world.corner_acceleration();
    const Index nodes = world.model.nodes();
    world.split();
    EXPECT_TRUE(round > 0 || world.model.nodes() > nodes);
    const std::vector<double> after = world.corner_acceleration();
    const auto mass = world.template host<NodeMass>();
    const auto of = world.template host<ElementNodes<D>>();
    double worst = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
      // In units of a corner's force over its node's mass: what round-off of forces can do.
      const auto e = static_cast<Index>(i / D / (D + 1));
      const double scale = 1e4 / mass(of(e, static_cast<int>(i / D % (D + 1))));
      worst = std::max(worst, std::abs(after[i] - before[i]) / scale);
    }
    EXPECT_LT(worst, 2e-14 * (D == 2 ? 1 : 4));
    check_books(world);
  }
}

TEST(SplitStars, RandomInsertionKeepsEveryAcceleration) {
  for (int seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    check_random_insertion<2>("cross", "[5, 4]", "[5e-3, 4e-3]", 0.1 * seed, seed);
    check_random_insertion<3>("kuhn", "[3, 2, 2]", "[3e-3, 2e-3, 2e-3]", 0.05 * seed, seed);
    check_random_insertion<3>("five", "[2, 2, 2]", "[2e-3, 2e-3, 2e-3]", 0.1 * seed, seed);
  }
}

// S-15
TEST(SplitStars, AllFacesOfAllNodesAtOnce) {
  check_random_insertion<2>("cross", "[3, 3]", "[3e-3, 3e-3]", 0.999, 1);
  check_random_insertion<3>("kuhn", "[2, 2, 2]", "[2e-3, 2e-3, 2e-3]", 0.999, 1);
}

}  // namespace
}  // namespace breccia
