// V-009 on whole bodies: the stable step of the code against the largest rate of the assembly, at
// rest and deformed; just below the limit a body stays bounded, just above it does not.
#include "harness/modes.hpp"
#include "harness/temp_folder.hpp"
#include "harness/tensors.hpp"
#include "harness/waves.hpp"

#include <gtest/gtest.h>

namespace breccia {
namespace {

/// Ratio of the code's step (all of its bound) to the exact limit.
template <int D>
double share_of_limit(const BlockScene& block, const Mat<D>& f) {
  BlockScene scene = block;
  scene.run = "duration = 1\nstep_factor = 1";
  SceneWorld<D> world(scene.text());
  world.simulation.start();
  put_field<NodePosition<D>, D>(world, [&f](const Vec<D>& x) { return f * x; });
  return world.simulation.stable(true).dt * largest_rate(world) / 2;
}

template <int D>
Mat<D> diagonal(const Vec<3>& stretch) {
  Mat<D> f = Mat<D>::zero();
  for (int i = 0; i < D; ++i) f(i, i) = stretch[i];
  return f;
}

template <int D>
void check_share(const BlockScene& scene, const std::vector<Vec<3>>& stretches) {
  for (const Vec<3>& s : stretches) {
    const double share = share_of_limit<D>(scene, diagonal<D>(s));
    std::printf("%s nu %.4f stretch %.2f %.2f %.2f: %.3f of the limit\n", scene.pattern.c_str(),
                scene.poisson, s[0], s[1], s[2], share);
    EXPECT_LE(share, 1 + 1e-6);
    EXPECT_GE(share, 0.4);
  }
}

template <int D>
std::string one_element(const TempFolder& folder) {
  const std::string file = folder / "one.msh";
  put_text(file, D == 2 ? "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0.1 0\n"
                          "3 0.3 0.8 0\n$EndNodes\n$Elements\n1\n1 2 2 1 1 1 2 3\n$EndElements\n"
                        : "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0.1 0\n"
                          "3 0.3 0.8 0\n4 0.2 0.1 0.9\n$EndNodes\n$Elements\n1\n"
                          "1 4 2 1 1 1 2 3 4\n$EndElements\n");
  return file;
}

const std::vector<Vec<3>> kAtRest = {{{1, 1, 1}}};
const std::vector<Vec<3>> kDeformed = {{{0.8, 1, 1}},    {{0.5, 1, 1}}, {{0.3, 0.5, 0.5}},
                                       {{1.2, 1, 1}},    {{2, 1, 1}},   {{0.6, 1.5, 1}},
                                       {{0.9, 0.9, 0.9}}};

TEST(StepOfBodies, TrianglesAtRest) {
  for (const char* pattern : {"cross", "right", "union-jack"})
    for (const double poisson : {0.0, 0.3, 0.4999}) {
      BlockScene scene;
      scene.cells = "[3, 3]";
      scene.pattern = pattern;
      scene.poisson = poisson;
      scene.jitter = 0.3;
      check_share<2>(scene, kAtRest);
      scene.plane = "stress";
      check_share<2>(scene, kAtRest);
    }
}

TEST(StepOfBodies, TetrahedraAtRest) {
  for (const char* pattern : {"kuhn", "five"})
    for (const double poisson : {0.0, 0.3, 0.4999}) {
      BlockScene scene{3, "[1, 1, 1]", "[2, 2, 2]"};
      scene.pattern = pattern;
      scene.poisson = poisson;
      scene.jitter = 0.3;
      check_share<3>(scene, kAtRest);
    }
}

// Pressed bodies are stiffer than their elastic constants say: S-10, S-11.
TEST(StepOfBodies, DeformedBodies) {
  for (const double poisson : {0.0, 0.3, 0.45}) {
    BlockScene plane;
    plane.cells = "[3, 3]";
    plane.poisson = poisson;
    plane.jitter = 0.2;
    check_share<2>(plane, kDeformed);
    BlockScene space{3, "[1, 1, 1]", "[2, 2, 2]"};
    space.poisson = poisson;
    space.jitter = 0.2;
    check_share<3>(space, kDeformed);
  }
}

// Alone, where no neighbour shares the load, the bound is sharpest.
template <int D>
void check_deformed_element() {
  const TempFolder folder;
  for (const double poisson : {0.0, 0.3, 0.4999}) {
    BlockScene scene;
    scene.dimension = D;
    scene.file = one_element<D>(folder);
    scene.poisson = poisson;
    check_share<D>(scene, kDeformed);
  }
}

TEST(StepOfBodies, DeformedElements) {
  check_deformed_element<2>();
  check_deformed_element<3>();
}

// S-02: cells a hundred and a thousand times as long as high.
TEST(StepOfBodies, Slivers) {
  for (const char* height : {"0.01", "0.001"}) {
    BlockScene scene;
    scene.size = std::string("[1, ") + height + "]";
    scene.cells = "[2, 2]";
    check_share<2>(scene, kAtRest);
  }
}

/// Largest kinetic energy over that at the start, while one free element shakes.
template <int D>
double growth(double share, int steps) {
  const TempFolder folder;
  BlockScene scene;
  scene.dimension = D;
  scene.file = one_element<D>(folder);
  SceneWorld<D> world(scene.text());
  world.simulation.start();
  const Random random{23, 1};
  int n = 0;
  put_field<NodeVelocity<D>, D>(world, [&](const Vec<D>&) {
    Vec<D> v;
    for (int d = 0; d < D; ++d) v[d] = 1e-6 * random.normal(static_cast<std::uint64_t>(n), d + 1u);
    ++n;
    return v;
  });
  Clock clock;
  clock.dt = share * 2 / largest_rate(world);
  const double start = world.simulation.motion().kinetic_energy(world.model());
  double most = start;
  for (int i = 0; i < steps; ++i) {
    run_step(world, clock);
    if (i % 10 == 0 || i < 200)
      most = std::max(most, world.simulation.motion().kinetic_energy(world.model()));
  }
  return most / start;
}

// At 0.99 of the limit the kinetic energy swings up to 1 / (1 - 0.99^2) = 50 times what it was.
TEST(StepOfBodies, JustBelowTheLimitIsBounded) {
  EXPECT_LT(growth<2>(0.99, 10000), 100);
  EXPECT_LT(growth<3>(0.99, 10000), 100);
}

TEST(StepOfBodiesSlow, JustBelowTheLimitIsBoundedForLong) {
  EXPECT_LT(growth<2>(0.99, 100000), 100);
  EXPECT_LT(growth<3>(0.99, 100000), 100);
}

// At 1.02 it grows 2.2 times in every step.
TEST(StepOfBodies, JustAboveTheLimitDiverges) {
  EXPECT_GT(growth<2>(1.02, 40), 1e6);
  EXPECT_GT(growth<3>(1.02, 40), 1e6);
}

}  // namespace
}  // namespace breccia
