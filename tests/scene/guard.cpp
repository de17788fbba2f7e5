// [run.guard]: stops what no result may be made of, and changes nothing.
#include "scene/guard.hpp"

#include "harness/scenes.hpp"
#include "scene/state_file.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace breccia {
namespace {

/// A block that rings.
BlockScene ringing_block(const std::string& guard) {
  BlockScene scene;
  scene.run = "duration = 1\n[run.guard]\n" + guard;
  scene.body = "expansion = 5";
  return scene;
}

/// Two blocks on their way to each other.
BlockScene colliding_blocks(const std::string& guard, const std::string& stiffness) {
  BlockScene scene;
  scene.run = "duration = 1\n[run.guard]\n" + guard;
  scene.body = "velocity = [10, 0]";
  scene.more =
      "[[body]]\nname = \"c\"\nmaterial = \"m\"\nvelocity = [-10, 0]\n"
      "shape = { rectangle = { corner = [1.001, 0.1], size = [1, 0.7] } }\n"
      "mesh = { generator = \"structured\", cells = [4, 3] }\n"
      "[contact]\nfriction = 0\nstiffness = " +
      stiffness + "\n";
  return scene;
}

/// A simulation and the guard that looks at it as `breccia run` lets it.
struct Watched {
  explicit Watched(const BlockScene& scene)
      : world(scene.text()), guard(world.simulation, world.simulation.scene().at("run")) {
    world.simulation.start();
  }

  void steps(int most) {
    for (int i = 0; i < most && !stop().raised; ++i)
      world.simulation.step(1, {[this] {
                                  if (guard.due()) guard.before();
                                },
                                [this] {
                                  if (guard.due()) guard.after();
                                }});
  }

  void scale_velocities(double factor) {
    const auto v = world.host<NodeVelocity<2>>();
    for (std::size_t i = 0; i < v.size(); ++i) v.data()[i] *= factor;
    world.put<NodeVelocity<2>>(v);
  }

  const Stop& stop() { return world.model().stop; }

  SceneWorld<2> world;
  Guard<2> guard;
};

TEST(Guard, EnergyFromNowhereStopsTheRun) {
  Watched run(ringing_block("every = 10"));
  run.steps(500);
  ASSERT_FALSE(run.stop().raised) << run.stop().cause;
  EXPECT_GT(run.guard.seen().looks, 45);
  EXPECT_LT(run.guard.seen().made, 0.02);
  run.scale_velocities(1.3);  // of the kinetic energy, some half of all, 69 % more
  run.steps(21);
  ASSERT_TRUE(run.stop().raised);
  EXPECT_NE(run.stop().cause.find("came from nowhere"), std::string::npos) << run.stop().cause;
  EXPECT_NE(run.stop().cause.find("run.step_factor"), std::string::npos) << run.stop().cause;
  EXPECT_GT(run.guard.seen().made, 0.1);
}

TEST(Guard, ALossStopsNothing) {
  Watched run(ringing_block("every = 10"));
  run.steps(100);
  run.scale_velocities(0.5);
  run.steps(100);
  EXPECT_FALSE(run.stop().raised) << run.stop().cause;
}

TEST(Guard, WhatGrowsFastStopsAtTheFirstLook) {
  Watched run(ringing_block("every = 10"));
  run.steps(100);
  run.scale_velocities(10);
  run.steps(11);
  EXPECT_TRUE(run.stop().raised);
}

TEST(Guard, EnergiesThatAreNotFiniteStopTheRun) {
  Watched run(ringing_block("every = 10"));
  run.steps(20);
  const auto v = run.world.host<NodeVelocity<2>>();
  v(3, 0) = std::numeric_limits<double>::quiet_NaN();
  run.world.put<NodeVelocity<2>>(v);
  run.guard.before();
  run.guard.after();
  ASSERT_TRUE(run.stop().raised);
  EXPECT_NE(run.stop().cause.find("not finite"), std::string::npos) << run.stop().cause;
}

TEST(Guard, RestIsNotEnergyFromNowhere) {
  BlockScene scene;
  scene.run = "duration = 1\n[run.guard]\nevery = 1";
  scene.more = "[gravity]\nacceleration = [0, 0]\n";
  Watched run(scene);
  run.scale_velocities(0);
  run.steps(50);
  EXPECT_FALSE(run.stop().raised) << run.stop().cause;
  EXPECT_EQ(run.guard.seen().looks, 49);
}

// v^2 rho = k d^2 / L: 10 m/s and blocks of 1 m in a contact a hundred times softer than they are.
TEST(Guard, BodiesDeepInEachOtherStopTheRun) {
  Watched run(colliding_blocks("every = 10\noverlap = 0.1", "1e7"));
  run.steps(2000);
  ASSERT_TRUE(run.stop().raised);
  EXPECT_NE(run.stop().cause.find("overlap"), std::string::npos) << run.stop().cause;
  EXPECT_NE(run.stop().cause.find("run.guard.overlap"), std::string::npos) << run.stop().cause;
  EXPECT_GT(run.guard.seen().overlap, 0.1);

  Watched stiff(colliding_blocks("every = 10\noverlap = 0.1", "1e10"));
  stiff.steps(2000);
  EXPECT_FALSE(stiff.stop().raised) << stiff.stop().cause;
  EXPECT_GT(stiff.guard.seen().overlap, 0.0);
}

// Cells of 1/4 m in four triangles, of height 1/8 m; the sides of the blocks stay nearly flat.
TEST(Guard, OverlapIsTheDepthOverTheHeightOfElements) {
  Watched run(colliding_blocks("every = 1\noverlap = 100", "1e7"));
  run.steps(60);
  const auto x = run.world.host<NodePosition<2>>();
  double left = -1, right = 10;
  for (Index n = 0; n < run.world.model().mesh.points(); ++n) {
    const double start = run.world.model().mesh.point[static_cast<std::size_t>(n)][0];
    if (start <= 1) left = std::max(left, x(n, 0));
    if (start > 1) right = std::min(right, x(n, 0));
  }
  ASSERT_GT(left, right);
  run.guard.before();
  run.guard.after();
  EXPECT_NEAR(run.guard.seen().overlap * 0.125, left - right, 0.1 * (left - right));
}

TEST(Guard, LooksChangeNoBit) {
  const auto hash = [](const std::string& guard) {
    Watched run(colliding_blocks(guard, "1e9"));
    run.steps(400);
    EXPECT_FALSE(run.stop().raised) << run.stop().cause;
    return state_hash(run.world.simulation);
  };
  EXPECT_EQ(hash("every = 0"), hash("every = 1"));
}

TEST(Guard, NobodyLooksWhereTheSceneSaysSo) {
  Watched run(ringing_block("every = 0"));
  run.scale_velocities(3);
  run.steps(100);
  EXPECT_EQ(run.guard.seen().looks, 0);
}

}  // namespace
}  // namespace breccia
