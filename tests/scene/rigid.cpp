// Rigid bodies as a scene makes them: their mass, their motion, what holds and moves them, what they
// push and carry.
#include "fields/rigid_fields.hpp"
#include "harness/scenes.hpp"

#include <gtest/gtest.h>

namespace breccia {
namespace {

template <int D>
BlockScene rigid_block() {
  BlockScene scene;
  scene.dimension = D;
  scene.size = D == 2 ? "[2, 1]" : "[2, 1, 0.5]";
  scene.cells = D == 2 ? "[8, 4]" : "[8, 4, 2]";
  scene.body = "rigid = true";
  return scene;
}

/// Momentum, and angular momentum about the origin, of all nodes.
template <int D>
std::pair<Vec<3>, Vec<3>> momenta(SceneWorld<D>& world) {
  const auto x = world.template host<NodePosition<D>>();
  const auto v = world.template host<NodeVelocity<D>>();
  const auto m = world.template host<NodeMass>();
  Vec<3> p = Vec<3>::zero(), l = Vec<3>::zero();
  for (Index n = 0; n < world.model().nodes(); ++n) {
    Vec<3> at = Vec<3>::zero(), mv = Vec<3>::zero();
    for (int d = 0; d < D; ++d) {
      at[d] = x(n, d);
      mv[d] = m(n) * v(n, d);
    }
    p += mv;
    l += cross(at, mv);
  }
  return {p, l};
}

/// Largest change of a distance between two nodes of body 0 since the start, m.
template <int D>
double deformation(SceneWorld<D>& world) {
  const auto x = world.template host<NodePosition<D>>();
  const auto flags = world.template host<NodeFlags>();
  std::vector<Index> nodes;
  for (const Index n : find_region(world.model().mesh, "b")->points)
    if ((flags(n) & node_flag::rigid) != 0) nodes.push_back(n);  // not what has split from it
  double most = 0;
  for (const Index a : nodes)
    for (const Index b : nodes) {
      double now = 0, then = 0;
      for (int d = 0; d < D; ++d) {
        now += std::pow(x(a, d) - x(b, d), 2);
        then += std::pow(world.model().mesh.point[a][d] - world.model().mesh.point[b][d], 2);
      }
      most = std::max(most, std::abs(std::sqrt(now) - std::sqrt(then)));
    }
  return most;
}

/// Counts the nodes that move with a rigid body.
Index rigid_nodes(SceneWorld<2>& world) {
  const auto flags = world.host<NodeFlags>();
  Index count = 0;
  for (Index n = 0; n < world.model().nodes(); ++n)
    if ((flags(n) & node_flag::rigid) != 0) ++count;
  return count;
}

/// A node on the upper side of the plate.
Index top_node(SceneWorld<2>& world) {
  Index found = 0;
  for (Index n = 0; n < world.model().mesh.points(); ++n)
    if (world.model().mesh.point[n][1] > world.model().mesh.point[found][1]) found = n;
  return found;
}

template <int D>
void check_free_flight(const std::string& spin) {
  BlockScene scene = rigid_block<D>();
  scene.run = "duration = 1\nstep = 1e-4";
  scene.body += "\nspin = " + spin + "\nvelocity = " + (D == 2 ? "[1, 2]" : "[1, 2, 3]");
  SceneWorld<D> world(scene.text());
  world.simulation.start();
  const auto [p, l] = momenta(world);
  double start = 0, most = 0;
  for (int n = 0; n < 500; ++n) {
    const Ledger ledger = world.step_and_book();
    EXPECT_LT(ledger.residual_1(), 1e-12);
    if (n == 0) start = ledger.kinetic;
    most = std::max(most, std::abs(ledger.kinetic / start - 1));
  }
  // The ledger's energy at t^n is m v_old . v_new / 2: short by half the square of a step's turn.
  EXPECT_LT(most, std::pow(20 * 1e-4, 2));
  EXPECT_LT(deformation(world), 1e-12);
  const auto [p_now, l_now] = momenta(world);
  EXPECT_LT(norm(p_now - p), 1e-12 * norm(p));
  // Nodes move along chords: theta^2 / 6 of the turn in a step.
  EXPECT_LT(norm(l_now - l), 1e-6 * norm(l));
  const auto centre = world.template host<RigidCentre<D>>();
  EXPECT_NEAR(centre(0, 0), 1 + world.time(), 1e-12);
  EXPECT_NEAR(centre(0, 1), 0.5 + 2 * world.time(), 1e-12);
}

TEST(Rigid, FliesAndTumblesWithoutDeforming) {
  check_free_flight<2>("20");
  check_free_flight<3>("[3, 10, 5]");
}

/// Angular momentum about its centre of a block that spins about `axis` with 1 rad/s, kg m2/s.
double inertia_about(int axis, int refinement) {
  BlockScene scene = rigid_block<3>();
  scene.cells = fmt::format("[{}, {}, {}]", 4 * refinement, 2 * refinement, refinement);
  scene.body +=
      fmt::format("\nspin = [{}, {}, {}]", axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0);
  SceneWorld<3> world(scene.text());
  world.simulation.start();
  return world.host<RigidMomentum>()(0, axis);
}

// The lumped masses of the mesh: momenta to round-off those of its nodes, inertia towards that of
// the box with the square of the cells.
TEST(Rigid, HasTheMassAndInertiaOfItsMesh) {
  BlockScene scene = rigid_block<3>();
  scene.body += "\nspin = [3, 10, 5]\nvelocity = [1, 2, 3]";
  SceneWorld<3> world(scene.text());
  world.simulation.start();
  const auto [p, l] = momenta(world);
  const double mass = 1000 * 2 * 1 * 0.5;
  for (int d = 0; d < 3; ++d) EXPECT_NEAR(p[d], (1 + d) * mass, 1e-12 * mass);
  const auto own = world.host<RigidMomentum>();
  const Vec<3> orbital = cross(Vec<3>{1, 0.5, 0.25}, p);
  for (int d = 0; d < 3; ++d) EXPECT_NEAR(own(0, d) + orbital[d], l[d], 1e-12 * norm(l));

  const double sides[3] = {2, 1, 0.5};
  for (int axis = 0; axis < 3; ++axis) {
    const double a = sides[(axis + 1) % 3], b = sides[(axis + 2) % 3];
    const double box = mass * (a * a + b * b) / 12;
    const double coarse = inertia_about(axis, 2) - box, fine = inertia_about(axis, 4) - box;
    EXPECT_NEAR(coarse / fine, 4, 0.1);
    EXPECT_LT(fine, 0.06 * box);
  }
}

TEST(Rigid, FallsAsAPoint) {
  BlockScene scene = rigid_block<2>();
  scene.run = "duration = 1\nstep = 1e-3";
  scene.more = "[gravity]\nacceleration = [0, -10]\n";
  SceneWorld<2> world(scene.text());
  world.simulation.start();
  while (world.time() < 0.5) world.step(0.5);
  // Leapfrog follows a parabola exactly.
  EXPECT_NEAR(world.host<RigidCentre<2>>()(0, 1), 0.5 - 5 * 0.25, 1e-12);
}

std::string moved(const std::string& how) {
  BlockScene scene = rigid_block<2>();
  scene.run = "duration = 1\nstep = 1e-3";
  scene.more = "[[boundary]]\nwhere = \"b\"\n" + how + "\n[gravity]\nacceleration = [0, -10]\n";
  return scene.text();
}

TEST(Rigid, BoundariesMoveHoldAndTurnItAsAWhole) {
  SceneWorld<2> pushed(moved("velocity = [0.5, \"free\"]"));
  SceneWorld<2> drum(moved("fixed = [0, 0]\nspin = 3\nramp = 0.1"));
  SceneWorld<2> wheel(moved("fixed = [0, 0]\npivot = true"));
  for (SceneWorld<2>* world : {&pushed, &drum, &wheel}) world->simulation.start();
  Ledger ledger;
  for (int n = 0; n < 200; ++n) {
    pushed.step();
    ledger = drum.step_and_book();
    wheel.step();
  }
  const double t = pushed.time();
  EXPECT_NEAR(pushed.host<RigidCentre<2>>()(0, 0), 1 + 0.5 * t, 1e-12);
  EXPECT_NEAR(pushed.host<RigidCentre<2>>()(0, 1), 0.5 - 5 * t * t, 1e-12);
  EXPECT_EQ(pushed.host<RigidTurn>()(0, 0), 1);

  // The ramp takes half of its time from the turn.
  const auto turn = drum.host<RigidTurn>();
  EXPECT_NEAR(2 * std::atan2(turn(0, 3), turn(0, 0)), 3 * (t - 0.05), 1e-4);
  EXPECT_NEAR(drum.host<RigidCentre<2>>()(0, 1), 0.5, 1e-14);
  EXPECT_LT(ledger.residual_1(), 1e-12);
  EXPECT_LT(deformation(drum), 1e-12);
  // Weight through the centre turns nothing.
  EXPECT_NEAR(wheel.host<RigidSpin>()(0, 2), 0, 1e-12);
  EXPECT_NEAR(wheel.host<RigidLoad>()(0, 1), -10 * 2000, 1e-8);
}

/// A deformable rod that grows out of a rigid block, in one piece with it.
template <int D>
std::string rod_on_block() {
  const auto body = [](const char* name, const std::string& corner, const std::string& size,
                       const std::string& more) {
    return fmt::format(
        "[[body]]\nname = \"{}\"\nmaterial = \"m\"\npart_of = \"tool\"\nmesh = {{ size = 0.3 }}\n"
        "shape = {{ {} = {{ corner = {}, size = {} }} }}\n{}\n",
        name, D == 2 ? "rectangle" : "box", corner, size, more);
  };
  const bool flat = D == 2;
  return fmt::format("[run]\ndimension = {}\nduration = 1\n", D) +
         body("b", flat ? "[0, 0]" : "[0, 0, 0]", flat ? "[2, 1]" : "[2, 1, 0.5]",
              flat ? "rigid = true\nvelocity = [1, 0]" : "rigid = true\nvelocity = [1, 0, 0]") +
         body("rod", flat ? "[2, 0.25]" : "[2, 0.25, 0]", flat ? "[1, 0.5]" : "[1, 0.5, 0.5]", "") +
         "[material.m]\ndensity = 1000\nelastic = { young = 1e9, poisson = 0.3 }\n";
}

// The rod is dragged along and swings; what both have together stays.
template <int D>
void check_rod() {
  SceneWorld<D> world(rod_on_block<D>());
  world.simulation.start();
  const auto& regions = world.model().mesh;
  ASSERT_LT(regions.points(),
            find_region(regions, "b")->points.size() + find_region(regions, "rod")->points.size());
  const auto [p, l] = momenta(world);
  double most = 0;
  for (int n = 0; n < 400; ++n) {
    const Ledger ledger = world.step_and_book();
    EXPECT_LT(ledger.residual_1(), 1e-12);
    most = std::max(most, ledger.residual_2());
  }
  EXPECT_LT(most, 1e-2);
  const auto [p_now, l_now] = momenta(world);
  EXPECT_LT(norm(p_now - p), 1e-11 * norm(p));
  EXPECT_LT(norm(l_now - l), 1e-8 * norm(p));
  EXPECT_LT(deformation(world), 1e-12);
  const auto v = world.template host<RigidVelocity<D>>();
  EXPECT_LT(v(0, 0), 1);  // it has given some of its momentum away
}

TEST(Rigid, HoldsDeformableBodiesThatGrowOutOfIt) {
  check_rod<2>();
  check_rod<3>();
}

// A rigid block thrown at a deformable one: momenta stay, both fly apart, energy is accounted for.
TEST(Rigid, CollidesWithADeformableBody) {
  BlockScene scene = rigid_block<2>();
  scene.body += "\nvelocity = [2, 0]";
  scene.more =
      "[contact]\n[[body]]\nname = \"target\"\nmaterial = \"m\"\n"
      "shape = { rectangle = { corner = [2.001, 0.3], size = [1, 1] } }\n"
      "mesh = { generator = \"structured\", cells = [6, 6] }\n";
  SceneWorld<2> world(scene.text());
  world.simulation.start();
  const auto [p, l] = momenta(world);
  double most = 0;
  Ledger ledger;
  while (world.time() < 0.02) {
    ledger = world.step_and_book(0.02);
    most = std::max(most, ledger.residual_2());
  }
  EXPECT_LT(most, 1e-2);
  const auto [p_now, l_now] = momenta(world);
  EXPECT_LT(norm(p_now - p), 1e-11 * norm(p));
  EXPECT_LT(std::abs(l_now[2] - l[2]), 1e-6 * norm(p));
  EXPECT_LT(world.host<RigidVelocity<2>>()(0, 0), 1.5);
  EXPECT_NE(world.host<RigidSpin>()(0, 2), 0);  // hit off its centre
  EXPECT_LT(deformation(world), 1e-12);
}

// A rod that is torn between two rigid grips in one piece with it: where it breaks along a grip, the
// copies of shared nodes that hold no rigid element go with the rod, and take their mass along.
TEST(Rigid, SharedNodesThatSplitGoWithTheRod) {
  const auto body = [](const char* name, double x, double width, const std::string& more) {
    return fmt::format(
        "[[body]]\nname = \"{}\"\nmaterial = \"m\"\npart_of = \"all\"\nmesh = {{ size = 0.02 }}\n"
        "shape = {{ rectangle = {{ corner = [{}, 0], size = [{}, 0.1] }} }}\n{}\n",
        name, x, width, more);
  };
  const std::string text =
      "[run]\ndimension = 2\nduration = 1\n" +
      body("b", 0, 0.1, "rigid = true\nvelocity = [-20, 0]") + body("rod", 0.1, 0.2, "") +
      body("right", 0.3, 0.1, "rigid = true\nvelocity = [20, 0]") +
      "[material.m]\ndensity = 2600\nelastic = { young = 60e9, poisson = 0.2 }\n"
      "[fracture.m]\ntensile_strength = 8e6\ncohesion = 20e6\nfriction_angle = 0.7\n"
      "energy_tension = 20\nenergy_shear = 200\n";
  SceneWorld<2> world(text);
  world.simulation.start();
  const Index before = rigid_nodes(world);
  const auto [p, l] = momenta(world);
  const double mass = std::abs(p[0]) + 20 * 2600 * 0.1 * 0.1;
  Ledger ledger;
  while (world.time() < 3e-4) ledger = world.step_and_book(3e-4);
  EXPECT_GT(world.simulation.counts().released, 10);
  EXPECT_LT(ledger.residual_1(), 1e-12);
  EXPECT_LT(ledger.residual_2(), 2e-2);
  // Faces of rigid elements hold: they keep exactly the nodes they had.
  EXPECT_EQ(rigid_nodes(world), before);
  Index all_copies = 0;
  const auto flags = world.host<NodeFlags>();
  const auto family = world.host<NodeFamily>();
  for (Index n = world.model().mesh.points(); n < world.model().nodes(); ++n)
    if ((flags(family(n)) & node_flag::rigid) != 0 && (flags(n) & node_flag::rigid) == 0) {
      EXPECT_EQ(flags(n) & node_flag::fixed_any, 0u);
      ++all_copies;
    }
  EXPECT_GT(all_copies, 0) << "nothing broke along a grip";
  const auto [p_now, l_now] = momenta(world);
  EXPECT_LT(norm(p_now - p), 1e-10 * mass);
  EXPECT_LT(norm(l_now - l), 1e-6 * mass);
  EXPECT_LT(deformation(world), 1e-12);
}

// A rigid plate in one piece with a block, brought to rest: the block carries its weight.
TEST(Rigid, APlateComesToRestOnABlock) {
  const std::string text =
      "[run]\ndimension = 2\nduration = 20\nrest = { tolerance = 1e-5 }\n"
      "[[body]]\nname = \"b\"\nmaterial = \"soft\"\npart_of = \"press\"\n"
      "shape = { rectangle = { corner = [0, 0], size = [1, 1] } }\nmesh = { size = 0.25 }\n"
      "[[body]]\nname = \"plate\"\nmaterial = \"heavy\"\nrigid = true\npart_of = \"press\"\n"
      "shape = { rectangle = { corner = [0, 1], size = [1, 0.25] } }\nmesh = { size = 0.25 }\n"
      "[material.soft]\ndensity = 1000\nelastic = { young = 1e7, poisson = 0 }\n"
      "[material.heavy]\ndensity = 40000\nelastic = { young = 1e9, poisson = 0.3 }\n"
      "[[boundary]]\nplane = { point = [0, 0], normal = [0, 1] }\nfixed = [\"free\", 0]\n"
      "[gravity]\nacceleration = [0, -1]\n";
  SceneWorld<2> world(text);
  world.simulation.start();
  while (world.time() < 20 && !world.model().rest.reached) world.step(20);
  ASSERT_TRUE(world.model().rest.reached);
  // Strain under the plate's weight and half of the block's own (E = 1e7, no lateral strain); the
  // nodes of the plate's foot carry half a row of the block's elements as well.
  const double sinking = (10000.0 + 500.0) / 1e7;
  EXPECT_NEAR(1.25 - world.host<NodePosition<2>>()(top_node(world), 1), sinking, 2e-3 * sinking);
}

}  // namespace
}  // namespace breccia
