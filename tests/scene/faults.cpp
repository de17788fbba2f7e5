// Fractures that are there before the start: in balance, sliding, open, healed.
#include "harness/scenes.hpp"
#include "harness/temp_folder.hpp"
#include "mesh/geometry.hpp"
#include "modules/fracture/fracture_fields.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace breccia {
namespace {

constexpr const char* kMiddle = "lines = [[[0, 0.5], [1, 0.5]]]\n";
constexpr const char* kMiddleInSpace =
    "lines = [[[0, 0, 0.5], [1, 0, 0.5], [1, 1, 0.5], [0, 1, 0.5]]]\n";

std::string fracture(const std::string& kind, const std::string& place, const std::string& law) {
  return "[[fractures]]\nname = \"f\"\nbody = \"b\"\nkind = \"" + kind + "\"\n" + place + law;
}

/// Largest slip and opening between the corners of a fault that lies across y or z.
template <int D>
Vec<D> largest_jump(SceneWorld<D>& world) {
  const auto fault = world.template host<InterfaceFaults<D>>();
  Vec<D> most = Vec<D>::zero();
  for (Index i = 0; i < world.store().count(Entity::interface); ++i)
    for (int c = 0; c < D; ++c)
      for (int d = 0; d < D; ++d)
        most[d == 0 ? D - 1 : d - 1] =
            std::max(most[d == 0 ? D - 1 : d - 1], std::abs(fault(i, c).jump[d]));
  return most;
}

template <int D>
double fastest(SceneWorld<D>& world) {
  const auto v = world.template host<NodeVelocity<D>>();
  double most = 0;
  for (Index n = 0; n < world.model().nodes(); ++n) most = std::max(most, norm(row<D>(v, n)));
  return most;
}

// A fault through ground under stress, below its friction: it begins with the traction that stood
// on it, and nothing moves (c is 1000 m/s). Part of the stress may stand on the fault alone.
template <int D>
void check_balance(const std::string& friction) {
  BlockScene scene{D, D == 2 ? "[1, 1]" : "[1, 1, 1]", D == 2 ? "[6, 6]" : "[2, 2, 2]"};
  const std::string stress =
      D == 2 ? "[-3e5, -5e5, -2e5, 1e5]" : "[-3e5, -5e5, -5e5, 1e5, 5e4, -7e4]";
  scene.more =
      "[[initial_stress]]\nstress = " + stress + "\n[[boundary]]\nwhere = \"b\"\nheld = true\n" +
      fracture("closed", D == 2 ? kMiddle : kMiddleInSpace, "[fractures.friction]\n" + friction);
  SceneWorld<D> world(scene.text());
  world.simulation.start();
  world.steps(60);
  EXPECT_GT(world.store().count(Entity::interface), 0);
  EXPECT_LT(fastest(world), 1e-6) << friction;
}

TEST(Faults, StandStillUnderTheStressOfTheGround) {
  check_balance<2>("coefficient = 0.3");
  check_balance<3>("coefficient = 0.3");
  check_balance<2>("coefficient = 0.5\nstress = [0, -1e5, 0, 5e4]");
  check_balance<2>(
      "law = \"slip_weakening\"\ncoefficient = 0.3\ndynamic = 0.1\nweakening_slip = 1e-3");
}

/// Slip along the middle of a block of 1 m whose foot is held between two times, under gravity that
/// is turned by 30 degrees and rises in 20 ms.
double slid(const std::string& friction, double from, double to) {
  BlockScene scene{2, "[1, 1]", "[4, 4]"};
  scene.damping = 0.1;
  scene.more =
      "[gravity]\nacceleration = [4.905, -8.4957]\nramp = 0.02\n"
      "[[boundary]]\nwhere = \"b.bottom\"\nfixed = [0, 0]\n" +
      fracture("closed", kMiddle, "[fractures.friction]\n" + friction);
  SceneWorld<2> world(scene.text());
  world.simulation.start();
  while (world.time() < from) world.step(from);
  const double before = largest_jump(world)[0];
  while (world.time() < to) world.step(to);
  return largest_jump(world)[0] - before;
}

// V-042 on a fault: a = g (sin 30 - 0.3 cos 30), after the ramp v = a (t - 10 ms). Above the
// friction angle it sticks.
TEST(Faults, SlideDownASlope) {
  const double way = 0.5 * 2.356287 * (0.09 * 0.09 - 0.05 * 0.05);
  EXPECT_NEAR(slid("coefficient = 0.3", 0.06, 0.1), way, 0.005 * way);
  EXPECT_LT(slid("coefficient = 0.6", 0.03, 0.1), 1e-6);
}

// Pulled apart: no traction through an open or a closed fracture, the half that is held stays.
TEST(Faults, OpenAndClosedBearNoTension) {
  for (const char* kind : {"open", "closed", "whole"}) {
    BlockScene scene{2, "[1, 1]", "[4, 4]"};
    scene.more =
        "[[boundary]]\nwhere = \"b.bottom\"\nfixed = [\"free\", 0]\n"
        "[[boundary]]\nwhere = \"b.top\"\nvelocity = [\"free\", 0.1]\n";
    if (kind != std::string("whole"))
      scene.more += fracture(
          kind, kMiddle,
          kind == std::string("closed") ? "[fractures.friction]\ncoefficient = 0.3\n" : "");
    SceneWorld<2> world(scene.text());
    world.simulation.start();
    while (world.time() < 3e-3) world.step();
    double most = 0;
    const auto stress = element_stresses(world);
    for (std::size_t e = 0; e < stress.size(); ++e)
      if (centroid<2>(corners(world.model().mesh, static_cast<Index>(e)))[1] < 0.5)
        most = std::max(most, std::abs(stress[e](1, 1)));
    if (kind == std::string("whole"))
      EXPECT_GT(most, 1e4);
    else
      EXPECT_EQ(most, 0) << kind;
  }
}

// A healed plane breaks at its own strength, the rock beside it not at all.
TEST(Faults, HealedPlanesBreakAtTheirStrength) {
  BlockScene scene{2, "[1, 1]", "[8, 8]"};
  scene.damping = 0.1;
  const std::string rest = "cohesion = 1e6\nenergy_tension = 50\nenergy_shear = 500\n";
  scene.more =
      "[[boundary]]\nwhere = \"b.bottom\"\nfixed = [\"free\", 0]\n"
      "[[boundary]]\nwhere = \"b.top\"\nvelocity = [\"free\", 0.005]\nramp = 0.005\n"
      "[[sensor]]\nname = \"load\"\nreaction = \"b.bottom\"\n"
      "[fracture.m]\ntensile_strength = 4e5\n" +
      rest + fracture("healed", kMiddle, "[fractures.law]\ntensile_strength = 1e5\n" + rest);
  SceneWorld<2> world(scene.text());
  world.simulation.start();
  double most = 0;
  while (world.time() < 0.022) {
    world.step();
    double mean = 0;
    const auto stress = element_stresses(world);
    for (const auto& s : stress) mean += s(1, 1) / static_cast<double>(stress.size());
    most = std::max(most, mean);
  }
  EXPECT_EQ(world.store().count(Entity::interface), 8);
  EXPECT_NEAR(most, 1e5, 3e3);
}

// Two grains of one material in a mesh file: only the faces between them have the weak law.
TEST(Faults, GrainsOfAMeshFileHaveALawOfTheirOwn) {
  const TempFolder folder;
  std::ofstream file(folder.path() + "/grains.msh");
  file << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 2 0 0\n"
          "4 0 1 0\n5 1 1 0\n6 2 1 0\n$EndNodes\n$Elements\n4\n1 2 2 1 1 1 2 5\n"
          "2 2 2 1 1 1 5 4\n3 2 2 1 1 2 3 6\n4 2 2 1 1 2 6 5\n$EndElements\n"
          "$ElementData\n1\n\"grain\"\n1\n0\n3\n0\n1\n4\n1 7\n2 7\n3 8\n4 8\n"
          "$EndElementData\n";
  file.close();
  BlockScene scene;
  scene.file = folder.path() + "/grains.msh";
  const std::string rest = "cohesion = 1e6\nenergy_tension = 500\nenergy_shear = 5000\n";
  scene.more = "[fracture.m]\ntensile_strength = 4e5\n" + rest +
               "[fracture.m.grains]\nfield = \"grain\"\ntensile_strength = 1e5\nalpha = 0\n" + rest;
  SceneWorld<2> world(scene.text());
  world.simulation.start();
  EXPECT_EQ(world.store().count(Entity::interface), 1);
  EXPECT_EQ(world.model().nodes(), 8);
}

}  // namespace
}  // namespace breccia
