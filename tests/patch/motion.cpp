// A body whose boundary is driven along an affine motion at constant velocity: its free inner nodes
// follow without force, through the whole step (V-003, moving).
#include "harness/scenes.hpp"
#include "harness/tensors.hpp"

#include <gtest/gtest.h>

namespace breccia {
namespace {

template <int D>
Mat<D> gradient() {
  Mat<D> a = Mat<D>::zero();
  const double rows[3][3] = {{4, 9, -3}, {-5, 6, 2}, {1, 7, -4}};  // 1/s
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) a(i, j) = rows[i][j];
  return a;
}

/// One [[boundary]] for each node on the surface, with the velocity A X of its place.
template <int D>
std::string driven_surface(const BlockScene& scene) {
  SceneWorld<D> world(scene.text());
  const std::vector<bool> inner = inner_nodes(world.model());
  std::string text;
  for (std::size_t n = 0; n < inner.size(); ++n) {
    if (inner[n]) continue;
    const Vec<D> x = vector_of<D>(world.model().mesh.point[n]), v = gradient<D>() * x;
    std::string lower, upper, velocity;
    for (int d = 0; d < D; ++d) {
      const char* comma = d ? ", " : "";
      lower += fmt::format("{}{:.17g}", comma, x[d] - 1e-6);
      upper += fmt::format("{}{:.17g}", comma, x[d] + 1e-6);
      velocity += fmt::format("{}{:.17g}", comma, v[d]);
    }
    text += fmt::format("[[boundary]]\nbox = {{ lower = [{}], upper = [{}] }}\nvelocity = [{}]\n",
                        lower, upper, velocity);
  }
  return text;
}

template <int D>
void check_driven(BlockScene scene) {
  scene.jitter = 0.3;
  scene.more = driven_surface<D>(scene);
  SceneWorld<D> world(scene.text());
  world.simulation.start();
  put_field<NodeVelocity<D>, D>(world, [](const Vec<D>& x) { return gradient<D>() * x; });
  // Until strains of about 0.3; hundreds of steps.
  while (world.time() < 0.03) world.step();
  Mat<D> f = gradient<D>();
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) f(i, j) = world.time() * f(i, j) + (i == j ? 1 : 0);
  const auto position = world.template host<NodePosition<D>>();
  for (Index n = 0; n < world.model().mesh.points(); ++n) {
    const Vec<D> x = vector_of<D>(world.model().mesh.point[static_cast<std::size_t>(n)]);
    EXPECT_LT(norm(row<D>(position, n) - f * x), 2e-13) << n;
  }
  const Sym<D> expected = stress_of(law_of(world), f);
  for (const Sym<D>& sigma : element_stresses(world))
    EXPECT_LT(distance(sigma, expected), 2e-12 * scene.young);
}

TEST(PatchMotion, InnerNodesOfThePlaneFollow) {
  BlockScene scene;
  scene.cells = "[3, 3]";
  check_driven<2>(scene);
  scene.plane = "stress";
  scene.pattern = "right";
  check_driven<2>(scene);
}

TEST(PatchMotion, InnerNodesOfSpaceFollow) {
  BlockScene scene{3, "[1, 1, 1]", "[3, 3, 3]"};
  check_driven<3>(scene);
}

}  // namespace
}  // namespace breccia
