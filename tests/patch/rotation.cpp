// V-004: driven rigidly through ten turns, a body has no stress, with and without damping.
#include "harness/scenes.hpp"
#include "harness/tensors.hpp"

#include <gtest/gtest.h>

namespace breccia {
namespace {

constexpr int kStepsPerTurn = 90;

template <int D>
Mat<D> turned(int step) {
  const double angle = 2 * 3.14159265358979323846 * step / kStepsPerTurn;
  if constexpr (D == 2) {
    return rotation_matrix(angle);
  } else {
    return rotation_matrix(Vec<3>{{1, -2, 0.5}}, angle);
  }
}

/// Nodes on their circles and, half a step behind, the velocities that brought them there.
template <int D>
void turn_to(SceneWorld<D>& world, int step, double dt) {
  const Mat<D> now = turned<D>(step), before = turned<D>(step - 1);
  put_field<NodePosition<D>, D>(world, [&](const Vec<D>& x) { return now * x; });
  put_field<NodeVelocity<D>, D>(world,
                                [&](const Vec<D>& x) { return (now * x - before * x) * (1 / dt); });
}

template <int D>
void check_ten_turns(BlockScene scene) {
  scene.jitter = 0.3;
  SceneWorld<D> world(scene.text());
  world.simulation.start();
  const double dt = world.simulation.clock().dt;
  const double face = 1.0 / 16;  // m2, area of a cell's side
  for (int step = 1; step <= 10 * kStepsPerTurn; ++step) {
    turn_to<D>(world, step, dt);
    evaluate_forces(world, Clock{step, step * dt, dt, dt});
    for (const Sym<D>& sigma : element_stresses(world))
      ASSERT_LT(largest(sigma), 1e-10 * scene.young) << step;
    const auto force = world.template host<ElementForce<D>>();
    for (Index e = 0; e < world.model().elements(); ++e)
      for (int a = 0; a <= D; ++a)
        for (int d = 0; d < D; ++d)
          ASSERT_LT(std::abs(force(e, a, d)), 1e-10 * scene.young * face) << step;
  }
}

TEST(PatchRotation, TenTurnsInThePlane) {
  BlockScene scene;
  check_ten_turns<2>(scene);
  scene.plane = "stress";
  check_ten_turns<2>(scene);
}

TEST(PatchRotation, TenTurnsInSpace) {
  check_ten_turns<3>({3, "[1, 1, 1]", "[3, 3, 3]"});
}

// Damping works on rates of deformation; a rotation has none, however large the step.
TEST(PatchRotation, DampingDoesNotSeeRotation) {
  BlockScene plane;
  plane.damping = 0.5;
  check_ten_turns<2>(plane);
  BlockScene space{3, "[1, 1, 1]", "[3, 3, 3]"};
  space.damping = 0.5;
  check_ten_turns<3>(space);
}

// The same test must be able to fail: stretching at the same rate is damped.
TEST(PatchRotation, DampingSeesStretching) {
  BlockScene scene;
  scene.damping = 0.5;
  SceneWorld<2> world(scene.text());
  world.simulation.start();
  const double dt = world.simulation.clock().dt;
  put_field<NodeVelocity<2>, 2>(world, [&](const Vec<2>& x) { return x * (0.01 / dt); });
  evaluate_forces(world, Clock{1, dt, dt, dt});
  double most = 0;
  for (const Vec<2>& f : nodal_forces<ElementForce<2>>(world)) most = std::max(most, norm(f));
  EXPECT_GT(most, 1e-4 * scene.young / 4);
}

}  // namespace
}  // namespace breccia
