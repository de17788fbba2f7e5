// V-001, V-002, V-003: a body whose nodes follow an affine map has the same stress everywhere, that
// of the law at a point, and no net force on its inner nodes.
#include "harness/patch_meshes.hpp"
#include "harness/scenes.hpp"
#include "harness/temp_folder.hpp"
#include "harness/tensors.hpp"

#include <gtest/gtest.h>

namespace breccia {
namespace {

/// Positions are rounded to 1e-16 of the body, over elements a tenth of it: a few 1e-15 of the
/// modulus in stress. The strains below are of size one, so that this is 1e-12 and better.
constexpr double kExact = 1e-12;

template <int D>
void check_map(SceneWorld<D>& world, const Mat<D>& f) {
  put_field<NodePosition<D>, D>(world, [&f](const Vec<D>& x) { return f * x; });
  evaluate_forces(world, Clock{});
  const Sym<D> expected = stress_of(law_of(world), f);
  const double modulus = world.model().materials[0].young;
  for (const Sym<D>& sigma : element_stresses(world))
    ASSERT_LT(distance(sigma, expected), kExact * modulus);
  const std::vector<bool> inner = inner_nodes(world.model());
  const auto force = nodal_forces<ElementForce<D>>(world);
  double most = 0;
  for (const Vec<D>& v : force) most = std::max(most, norm(v));
  int seen = 0;
  for (std::size_t n = 0; n < force.size(); ++n)
    if (inner[n]) {
      ++seen;
      ASSERT_LT(norm(force[n]), kExact * most) << n;
    }
  EXPECT_GT(seen, 0);
}

/// F(t) = R(4 pi t) U(t) for t from 0 to 1 (V-003).
template <int D>
Mat<D> turned_stretch(double t) {
  Mat<D> u = Mat<D>::identity();
  const double stretch[3] = {1.3, 0.8, 1.1};
  for (int i = 0; i < D; ++i) u(i, i) += t * (stretch[i] - 1);
  u(0, 1) += 0.2 * t;
  const double angle = 4 * 3.14159265358979323846 * t;
  if constexpr (D == 2) {
    return rotation_matrix(angle) * u;
  } else {
    return rotation_matrix(Vec<3>{{1, 2, 3}}, angle) * u;
  }
}

template <int D>
void check_maps(const BlockScene& scene) {
  SceneWorld<D> world(scene.text());
  world.simulation.start();
  for (double t = 0.05; t < 1.001; t += 0.05) {
    SCOPED_TRACE(t);
    check_map<D>(world, turned_stretch<D>(t));
  }
}

TEST(PatchAffine, TrianglesOfAnyShape) {
  for (const char* pattern : {"cross", "right", "union-jack"}) {
    SCOPED_TRACE(pattern);
    BlockScene scene;
    scene.pattern = pattern;
    scene.jitter = 0.3;
    check_maps<2>(scene);
    scene.plane = "stress";
    check_maps<2>(scene);
  }
}

TEST(PatchAffine, TetrahedraOfAnyShape) {
  for (const char* pattern : {"kuhn", "five"}) {
    SCOPED_TRACE(pattern);
    BlockScene scene{3, "[1, 1, 1]", "[4, 4, 4]"};
    scene.pattern = pattern;
    scene.jitter = 0.3;
    check_maps<3>(scene);
  }
}

/// MacNeal and Harder's field: u = a M X, M symmetric with 1 and 1/2, and their stresses, which
/// are linear in a = 1e-3; the finite law meets them as a falls.
template <int D>
void check_macneal_harder(BlockScene scene, const std::string& mesh, double direct, double shear) {
  const TempFolder folder;
  put_text(folder / "patch.msh", mesh);
  scene.file = folder / "patch.msh";
  scene.young = 1e6;
  scene.poisson = 0.25;
  SceneWorld<D> world(scene.text());
  world.simulation.start();
  for (const double amplitude : {1e-3, 1e-7}) {
    Mat<D> f = Mat<D>::identity();
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) f(i, j) += amplitude * (i == j ? 1 : 0.5);
    put_field<NodePosition<D>, D>(world, [&f](const Vec<D>& x) { return f * x; });
    if (amplitude == 1e-3) check_map<D>(world, f);
    // Strains of 1e-7 leave 9 digits of the positions.
    const double allowed = std::max(5 * amplitude, 1e-8);
    for (const Sym<D>& sigma : element_stresses(world)) {
      EXPECT_NEAR(sigma(0, 0) / amplitude, 1e3 * direct, allowed * 1e3 * direct);
      EXPECT_NEAR(sigma(1, 1) / amplitude, 1e3 * direct, allowed * 1e3 * direct);
      EXPECT_NEAR(sigma(0, 1) / amplitude, 1e3 * shear, allowed * 1e3 * direct);
    }
  }
}

TEST(PatchMacNealHarder, Plane) {
  BlockScene scene;
  check_macneal_harder<2>(scene, macneal_harder_plane(), 1600, 400);
  scene.plane = "stress";
  check_macneal_harder<2>(scene, macneal_harder_plane(), 4000.0 / 3, 400);
}

TEST(PatchMacNealHarder, Space) {
  BlockScene scene;
  scene.dimension = 3;
  check_macneal_harder<3>(scene, macneal_harder_space(), 2000, 400);
}

}  // namespace
}  // namespace breccia
