// S-10: nearly incompressible bodies strained as far as it goes: no element inverts, stress stays
// finite, and the energy that is stored is the work of the forces.
#include "harness/scenes.hpp"

#include <gtest/gtest.h>

namespace breccia {
namespace {

template <int D>
using Course = std::function<Vec<D>(const Vec<D>&, double)>;

/// The body goes along x(X, s), s from 0 to 1, in `steps` steps.
template <int D>
void check_course(const BlockScene& scene, const Course<D>& course, int steps) {
  SceneWorld<D> world(scene.text());
  world.simulation.start();
  const Index nodes = world.model().mesh.points();
  std::vector<Vec<D>> before_x, before_f;
  double work = 0, most = 0, least_jacobian = 1;
  for (int k = 0; k <= steps; ++k) {
    put_field<NodePosition<D>, D>(
        world, [&](const Vec<D>& x) { return course(x, static_cast<double>(k) / steps); });
    evaluate_forces(world, Clock{});
    ASSERT_FALSE(world.model().stop.raised) << scene.element << ": " << world.model().stop.cause;
    const auto force = nodal_forces<ElementForce<D>>(world);
    const auto x = world.template host<NodePosition<D>>();
    std::vector<Vec<D>> now;
    for (Index n = 0; n < nodes; ++n) now.push_back(row<D>(x, n));
    if (k > 0)
      for (std::size_t n = 0; n < now.size(); ++n)
        work -= dot((force[n] + before_f[n]) * 0.5, now[n] - before_x[n]);
    before_x = now;
    before_f = force;
    most = std::max(most, world.model().stored_energy());
  }
  const auto view = stress_of(world.model());
  for (Index e = 0; e < world.model().elements(); ++e) {
    double jacobian = 0;
    view.strain(e, jacobian);
    least_jacobian = std::min(least_jacobian, jacobian);
  }
  EXPECT_GT(least_jacobian, 0) << scene.element;
  for (const Sym<D>& s : element_stresses(world))
    for (const double value : s.s) EXPECT_TRUE(std::isfinite(value)) << scene.element;
  const double stored = world.model().stored_energy();
  EXPECT_GT(stored, 0);
  EXPECT_NEAR(stored, work, 0.01 * most) << scene.element;
}

BlockScene rubber(int dimension, const std::string& element) {
  BlockScene scene{dimension, dimension == 2 ? "[1, 1]" : "[1, 1, 1]",
                   dimension == 2 ? "[4, 4]" : "[2, 2, 2]"};
  scene.young = 1e7;
  scene.poisson = 0.4999;
  scene.jitter = 0.2;
  scene.element = element;
  return scene;
}

/// Stretch `most` along the last axis, at constant volume.
template <int D>
Course<D> stretch(double most) {
  return [most](const Vec<D>& x, double s) {
    const double along = std::pow(most, s), across = std::pow(along, -1.0 / (D - 1));
    Vec<D> y = x * across;
    y[D - 1] = x[D - 1] * along;
    return y;
  };
}

// A step of 1 % of the whole logarithmic strain: trapezes of work are right to 1e-4.
TEST(LargeStrain, CompressionTo5PercentOfTheHeight) {
  for (const char* element : {"tri3", "tri6c"})
    check_course<2>(rubber(2, element), stretch<2>(0.05), 200);
  for (const char* element : {"tet4", "tet10c"})
    check_course<3>(rubber(3, element), stretch<3>(0.05), 200);
}

TEST(LargeStrain, TensionToTenTimesTheLength) {
  for (const char* element : {"tri3", "tri6c"})
    check_course<2>(rubber(2, element), stretch<2>(10), 200);
  for (const char* element : {"tet4", "tet10c"})
    check_course<3>(rubber(3, element), stretch<3>(10), 200);
}

// Two turns over six edges of a column. The path of a corner is cut into chords of a degree: steps
// four times as long are 5 % off.
TEST(LargeStrainSlow, TwoTurnsOfAColumn) {
  for (const char* element : {"tet4", "tet10c"}) {
    BlockScene scene = rubber(3, element);
    scene.size = "[1, 1, 6]";
    scene.cells = "[2, 2, 24]";
    scene.jitter = 0;
    check_course<3>(
        scene,
        [](const Vec<3>& x, double s) {
          const double angle = 4 * M_PI * s * x[2] / 6, c = std::cos(angle), d = std::sin(angle);
          const double u = x[0] - 0.5, v = x[1] - 0.5;
          return Vec<3>{{0.5 + c * u - d * v, 0.5 + d * u + c * v, x[2]}};
        },
        800);
  }
}

/// A body that is really pressed and pulled, between plates that let it slide.
template <int D>
void check_pressed(const std::string& element, double way, double end) {
  BlockScene scene = rubber(D, element);
  scene.run = "duration = 10";
  scene.damping = 0.2;
  scene.poisson = 0.49;
  const std::string last = D == 2 ? "[0, 1]" : "[0, 0, 1]";
  scene.more = fmt::format(
      "[[boundary]]\nplane = {{ point = {}, normal = {} }}\nsymmetry = true\n"
      "[[boundary]]\nplane = {{ point = {}, normal = {} }}\nvelocity = {}\nramp = {}\n",
      D == 2 ? "[0, 0]" : "[0, 0, 0]", last, last, last,
      D == 2 ? fmt::format("[\"free\", {}]", way / end)
             : fmt::format("[\"free\", \"free\", {}]", way / end),
      0.2 * end);
  SceneWorld<D> world(scene.text());
  world.simulation.start();
  Ledger ledger;
  while (world.time() < 1.1 * end && !world.model().stop.raised) ledger = world.step_and_book();
  EXPECT_FALSE(world.model().stop.raised) << element << ": " << world.model().stop.cause;
  double top_now = 0;
  const auto x = world.template host<NodePosition<D>>();
  for (Index n = 0; n < world.model().nodes(); ++n) top_now = std::max(top_now, x(n, D - 1));
  EXPECT_NEAR(top_now, 1 + way, 0.02 * (1 + std::abs(way)));
  EXPECT_LT(ledger.residual_1(), 1e-9) << element;
  EXPECT_LT(ledger.residual_2(), 0.01) << element;
}

// Simple elements only: docs/verification.md says how far composites come.
TEST(LargeStrainSlow, BodiesPressedFlat) {
  check_pressed<2>("tri3", -0.95, 0.2);
  check_pressed<3>("tet4", -0.95, 0.2);
}
TEST(LargeStrainSlow, BodiesPulledLong) {
  check_pressed<2>("tri3", 9, 0.5);
  check_pressed<3>("tet4", 9, 0.5);
}

}  // namespace
}  // namespace breccia
