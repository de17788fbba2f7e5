// Ground under stress, in balance from the start: nothing moves.
#include "harness/scenes.hpp"

#include <gtest/gtest.h>

namespace breccia {
namespace {

/// Fastest node over the speed of P waves during so many steps.
template <int D>
double unrest(const BlockScene& scene, int steps) {
  SceneWorld<D> world(scene.text());
  world.simulation.start();
  const double c = std::sqrt(world.model().p_wave_modulus(0) / scene.density);
  double fastest = 0;
  for (int i = 0; i < steps; ++i) {
    world.step();
    const auto v = world.template host<NodeVelocity<D>>();
    for (Index n = 0; n < world.model().nodes(); ++n)
      fastest = std::max(fastest, norm(row<D>(v, n)) / c);
  }
  return fastest;
}

BlockScene ground(int dimension, const std::string& element) {
  BlockScene scene{dimension, dimension == 2 ? "[1, 1]" : "[1, 1, 1]",
                   dimension == 2 ? "[6, 6]" : "[3, 3, 3]"};
  scene.jitter = 0.3;
  scene.element = element;
  return scene;
}

// A strain of 5e-4: what is not in balance would move at that share of c.
template <int D>
void check_uniform(const std::string& element) {
  const std::string stress =
      D == 2 ? "[-3e5, -5e5, -2e5, 1e5]" : "[-3e5, -5e5, -2e5, 1e5, 5e4, -7e4]";
  const std::string fixed = D == 2 ? "fixed = [0, 0]" : "fixed = [0, 0, 0]";
  const std::string right = "[[boundary]]\nwhere = \"b.right\"\n";
  for (const std::string& sides :
       {std::string("[[boundary]]\nwhere = \"b\"\nheld = true\n"),
        std::string("[[boundary]]\nwhere = \"b\"\nnon_reflecting = true\n"),
        "[[boundary]]\nwhere = \"b\"\n" + fixed + "\n",
        "[[boundary]]\nwhere = \"b\"\nheld = true\n" + right + fixed + "\n"}) {
    BlockScene scene = ground(D, element);
    scene.more = "[[initial_stress]]\nstress = " + stress + "\n" + sides;
    EXPECT_LT(unrest<D>(scene, 100), 1e-9) << element << "\n" << sides;
  }
}

TEST(InSitu, UniformStressMovesNothing) {
  check_uniform<2>("tri3");
  check_uniform<2>("tri6c");
}
TEST(InSitu, UniformStressMovesNothingInSpace) {
  check_uniform<3>("tet4");
  check_uniform<3>("tet10c");
}

TEST(InSitu, UniformStressOfLayersMovesNothing) {
  BlockScene scene = ground(2, "tri6c");
  scene.elastic = false;
  scene.material =
      "transversely_isotropic = { young = 1e9, young_axis = 5e8, poisson = 0.25, poisson_axis = "
      "0.2, shear_axis = 3e8 }";
  scene.more =
      "[[axes]]\nangle = \"30 deg\"\n[[initial_stress]]\nstress = [-3e5, -5e5, -2e5, 1e5]\n"
      "[[boundary]]\nwhere = \"b\"\nheld = true\n";
  EXPECT_LT(unrest<2>(scene, 300), 1e-9);
}

/// A block on rollers under its weight, its top free: the stress grows with depth.
template <int D>
BlockScene heavy(const std::string& element, int cells) {
  BlockScene scene = ground(D, element);
  const char up = D == 2 ? 'y' : 'z';
  scene.cells = D == 2 ? fmt::format("[{0}, {0}]", cells) : fmt::format("[{0}, {0}, {0}]", cells);
  const std::string zero = D == 2 ? "[0, 0, 0, 0]" : "[0, 0, 0, 0, 0, 0]";
  const std::string growth = D == 2 ? "[4e3, 1e4, 4e3, 0]" : "[4e3, 4e3, 1e4, 0, 0, 0]";
  scene.more = fmt::format(
      "[[initial_stress]]\nstress = {}\ngradient = {}\naxis = \"{}\"\ndatum = 1\n"
      "[gravity]\nacceleration = {}\n",
      zero, growth, up, D == 2 ? "[0, -10]" : "[0, 0, -10]");
  for (int d = 0; d < D; ++d)
    for (int side = 0; side < (d == D - 1 ? 1 : 2); ++side) {
      std::string point, normal, fixed;
      for (int i = 0; i < D; ++i) {
        point += fmt::format("{}{}", i ? ", " : "", i == d ? side : 0);
        normal += fmt::format("{}{}", i ? ", " : "", i == d ? 1 : 0);
        fixed += fmt::format("{}{}", i ? ", " : "", i == d ? "0" : "\"free\"");
      }
      scene.more +=
          fmt::format("[[boundary]]\nplane = {{ point = [{}], normal = [{}] }}\nfixed = [{}]\n",
                      point, normal, fixed);
    }
  return scene;
}

// The stress at the centroid is the mean of a linear one, and a third of an element's weight is the
// integral of its shape function: simple elements are in balance to round-off.
TEST(InSitu, WeightAndDepthAreInBalance) {
  EXPECT_LT(unrest<2>(heavy<2>("tri3", 6), 300), 1e-9);
  EXPECT_LT(unrest<3>(heavy<3>("tet4", 3), 300), 1e-9);
}

// A composite shares one mean stress, a step in depth instead of a slope: its nodes feel the
// difference, in proportion to its size (measured 5e-7, 3e-7, in space 1.4e-6; the strain of the
// weight is 1e-5).
TEST(InSitu, CompositesUnderWeightMoveLittle) {
  const double coarse = unrest<2>(heavy<2>("tri6c", 6), 200);
  const double fine = unrest<2>(heavy<2>("tri6c", 12), 200);
  const double space = unrest<3>(heavy<3>("tet10c", 2), 60);
  RecordProperty("coarse", fmt::format("{:.3g}", coarse));
  RecordProperty("fine", fmt::format("{:.3g}", fine));
  RecordProperty("space", fmt::format("{:.3g}", space));
  EXPECT_LT(coarse, 1e-6);
  EXPECT_LT(fine, 0.6 * coarse);
  EXPECT_LT(space, 2e-6);
}

}  // namespace
}  // namespace breccia
