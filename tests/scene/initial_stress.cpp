// Stress of the ground: what each element is given.
#include "harness/scenes.hpp"

#include <gtest/gtest.h>

namespace breccia {
namespace {

TEST(InitialStress, GrowsWithDepthFromItsDatum) {
  BlockScene scene;
  scene.jitter = 0.3;
  scene.more =
      "[[initial_stress]]\nstress = [-1, -2, -3, 4]\ngradient = [10, 20, 30, 0]\naxis = \"y\"\n"
      "datum = 1\n";
  SceneWorld<2> world(scene.text());
  const Model<2>& model = world.model();
  ASSERT_EQ(model.initial_stress.size(), model.mesh.element.size());
  for (std::size_t e = 0; e < model.mesh.element.size(); ++e) {
    double y = 0;
    for (const Index n : model.mesh.element[e]) y += model.mesh.point[n][1] / 3;
    const Sym<3>& s = model.initial_stress[e];
    EXPECT_NEAR(s(0, 0), -1 + 10 * (y - 1), 1e-13);
    EXPECT_NEAR(s(1, 1), -2 + 20 * (y - 1), 1e-13);
    EXPECT_NEAR(s(2, 2), -3 + 30 * (y - 1), 1e-13);
    EXPECT_EQ(s(0, 1), 4);
    EXPECT_EQ(s(1, 2), 0);
    EXPECT_EQ(s(0, 2), 0);
  }
}

TEST(InitialStress, FillsABoxOnlyAndAllSixComponents) {
  BlockScene scene{3, "[2, 1, 1]", "[4, 2, 2]"};
  scene.more =
      "[[initial_stress]]\nstress = [1, 2, 3, 4, 5, 6]\n"
      "box = { lower = [0, 0, 0], upper = [1, 1, 1] }\n";
  SceneWorld<3> world(scene.text());
  const Model<3>& model = world.model();
  int inside = 0;
  for (std::size_t e = 0; e < model.mesh.element.size(); ++e) {
    double x = 0;
    for (const Index n : model.mesh.element[e]) x += model.mesh.point[n][0] / 4;
    const Sym<3>& s = model.initial_stress[e];
    const double share = x < 1 ? 1 : 0;
    inside += x < 1;
    EXPECT_EQ(s(0, 0), 1 * share);
    EXPECT_EQ(s(1, 1), 2 * share);
    EXPECT_EQ(s(2, 2), 3 * share);
    EXPECT_EQ(s(0, 1), 4 * share);
    EXPECT_EQ(s(1, 2), 5 * share);
    EXPECT_EQ(s(0, 2), 6 * share);
  }
  EXPECT_EQ(2 * inside, static_cast<int>(model.mesh.element.size()));
  SceneWorld<2> none(BlockScene{}.text());
  EXPECT_TRUE(none.model().initial_stress.empty());
}

}  // namespace
}  // namespace breccia
