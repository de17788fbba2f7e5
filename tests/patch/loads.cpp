// Surface loads, gravity and uniform motion against states that they hold exactly.
#include "harness/scenes.hpp"
#include "harness/tensors.hpp"

#include <gtest/gtest.h>

namespace breccia {
namespace {

/// Largest net force on a node, over the largest of the elements' own.
template <int D>
double unbalance(SceneWorld<D>& world) {
  evaluate_forces(world, Clock{});
  const auto inside = nodal_forces<ElementForce<D>>(world);
  const auto load = nodal_forces<LoadForce<D>>(world);
  double net = 0, most = 0;
  for (std::size_t n = 0; n < inside.size(); ++n) {
    net = std::max(net, norm(inside[n] + load[n]));
    most = std::max(most, norm(inside[n]));
  }
  return net / most;
}

/// Strains (e, -lambda e / (lambda (D - 1) + 2 mu), ...) have stress along x only; the traction that
/// holds them, per reference area, is tau_11 / exp(e).
template <int D>
void check_tension(BlockScene scene) {
  const double e = 0.2;
  SceneWorld<D> probe(scene.text());
  probe.simulation.start();
  const HenckyElastic law = law_of(probe);
  const double lateral = -law.lambda * e / (law.lambda * (D - 1) + 2 * law.mu);
  const double tau = law.lambda * (e + (D - 1) * lateral) + 2 * law.mu * e;
  const char* rest = D == 2 ? "0" : "0, 0";
  scene.more = fmt::format(
      "[[boundary]]\nwhere = \"b.right\"\ntraction = [{0:.17g}, {1}]\n"
      "[[boundary]]\nwhere = \"b.left\"\ntraction = [-{0:.17g}, {1}]\n",
      tau / std::exp(e), rest);
  SceneWorld<D> world(scene.text());
  world.simulation.start();
  put_field<NodePosition<D>, D>(world, [&](Vec<D> x) {
    for (int d = 0; d < D; ++d) x[d] *= std::exp(d == 0 ? e : lateral);
    return x;
  });
  EXPECT_LT(unbalance(world), 1e-12);
}

TEST(PatchLoads, TractionHoldsUniaxialTension) {
  BlockScene plane;
  plane.jitter = 0.3;
  check_tension<2>(plane);
  plane.plane = "stress";
  plane.run = "duration = 1\nthickness = 0.02";
  check_tension<2>(plane);
  BlockScene space{3, "[1, 1, 1]", "[3, 3, 3]"};
  space.jitter = 0.3;
  check_tension<3>(space);
}

/// Pressure p on the whole surface, following it, holds the stretch s with -J p = (D lambda + 2 mu)
/// ln s.
template <int D>
void check_pressure(BlockScene scene) {
  const double stretch = 0.8;
  SceneWorld<D> probe(scene.text());
  probe.simulation.start();
  const HenckyElastic law = law_of(probe);
  const double pressure = -(D * law.lambda + 2 * law.mu) * std::log(stretch) / std::pow(stretch, D);
  scene.more = fmt::format("[[boundary]]\nwhere = \"b\"\npressure = {:.17g}\n", pressure);
  SceneWorld<D> world(scene.text());
  world.simulation.start();
  // Turned as well: the pressure turns with the surface.
  const Mat<D> q = random_rotation<D>(Random{4, 4}, 1);
  put_field<NodePosition<D>, D>(world, [&](const Vec<D>& x) { return (q * x) * stretch; });
  EXPECT_LT(unbalance(world), 1e-12);
}

TEST(PatchLoads, PressureHoldsUniformCompression) {
  BlockScene plane;
  plane.jitter = 0.3;
  check_pressure<2>(plane);
  plane.run = "duration = 1\nthickness = 0.02";
  check_pressure<2>(plane);
  BlockScene space{3, "[1, 1, 1]", "[3, 3, 3]"};
  space.jitter = 0.3;
  check_pressure<3>(space);
}

/// The leapfrog, begun with half a kick, is exact for constant acceleration: x = X + v t + g t^2/2.
template <int D>
void check_fall(const BlockScene& block) {
  BlockScene scene = block;
  scene.jitter = 0.3;
  scene.more = D == 2 ? "[gravity]\nacceleration = [3, -9.81]\n"
                      : "[gravity]\nacceleration = [3, -9.81, 1]\n";
  SceneWorld<D> world(scene.text());
  world.simulation.start();
  Vec<D> v = Vec<D>::zero(), g = Vec<D>::zero();
  v[0] = 5, v[1] = 7, g[0] = 3, g[1] = -9.81;
  if (D == 3) g[D - 1] = 1;
  put_field<NodeVelocity<D>, D>(world, [&](const Vec<D>&) { return v; });
  world.steps(200);
  const double t = world.time();
  const auto x = world.template host<NodePosition<D>>();
  for (Index n = 0; n < world.model().mesh.points(); ++n) {
    const Vec<D> start = vector_of<D>(world.model().mesh.point[static_cast<std::size_t>(n)]);
    EXPECT_LT(norm(row<D>(x, n) - start - v * t - g * (0.5 * t * t)), 1e-13) << n;
  }
}

TEST(PatchLoads, FallIsExactAndWithoutStress) {
  check_fall<2>({});
  check_fall<3>({3, "[1, 1, 1]", "[3, 3, 3]"});
}

}  // namespace
}  // namespace breccia
