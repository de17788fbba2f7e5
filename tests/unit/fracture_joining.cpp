#include "harness/fracture_world.hpp"
#include "mesh/geometry.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace breccia {
namespace {

/// A block of cells of 1 mm; one triangle inside, whose upright face is weaker than all others, is
/// of another material.
struct WeakFace {
  static void mark(Model<2>& model) {
    for (Index e = 0; e < model.elements(); ++e) {
      const auto at = centroid<2>(corners(model.mesh, e));
      if (std::hypot(at[0] - 2.8333e-3, at[1] - 2.5e-3) < 1e-5) model.mesh.body[e] = 1;
    }
  }

  static std::string law(const std::string& head, double strength) {
    return head + "tensile_strength = " + std::to_string(strength) +
           "\ncohesion = 50e6\nenergy_tension = 20\nenergy_shear = 200\n";
  }

  explicit WeakFace(double stress)
      : world(block_scene(2, "cross", "[6, 6]", "[6e-3, 6e-3]",
                          law("[fracture.rock]\n", 6e6) +
                              law("[[interface]]\nbetween = [\"rock\", \"other\"]\n", 4e6)),
              mark) {
    world.start();
    const auto x = world.host<NodePosition<2>>();
    const double modulus = 72e9;  // lambda + 2 mu
    for (Index n = 0; n < world.model.nodes(); ++n) x(n, 0) *= 1 + stress / modulus;
    Kokkos::deep_copy(world.model.store.get<NodePosition<2>>(), x);
  }

  Index inserted() { return world.model.store.count(Entity::interface); }
  bool opens() {
    const auto active = world.host<InterfaceActive<2>>();
    return active(0, 0) != 0 && active(0, 1) != 0;
  }

  FractureWorld<2> world;
};

// Below its strength a locked face waits; the others are far from theirs.
TEST(FractureJoining, LockedFaceWaitsBelowItsStrength) {
  WeakFace block(3.9e6);
  for (int i = 0; i < 4; ++i) block.world.step();
  EXPECT_EQ(block.inserted(), 1);
  EXPECT_FALSE(block.opens());
}

// Beyond it, its neighbours with half of their strength or more come along, and it opens. Diagonal
// faces bear two thirds of the stress, level ones, with a third, stay.
TEST(FractureJoining, LockedFaceBeyondItsStrengthOpens) {
  WeakFace block(4.1e6);
  block.world.step();
  EXPECT_EQ(block.inserted(), 1);
  EXPECT_FALSE(block.opens());
  block.world.step();
  EXPECT_TRUE(block.opens());
  const Index joined = block.inserted();
  EXPECT_GE(joined, 3);   // at either end one more at least
  EXPECT_LE(joined, 15);  // all faces at its two nodes
  const auto status = block.world.host<FaceStatus>();
  const auto& shared = block.world.model.topology.shared;
  for (std::size_t f = 0; f < shared.size(); ++f) {
    if (status(f) != face_status::inserted) continue;
    const auto x = block.world.host<NodePosition<2>>();
    const auto nodes = block.world.host<ElementNodes<2>>();
    const Index e = shared[f].left;
    const Index a = nodes(e, face_node<2>(shared[f].left_face, 0)),
                b = nodes(e, face_node<2>(shared[f].left_face, 1));
    EXPECT_GT(std::abs(x(a, 1) - x(b, 1)), 1e-5) << "a level face";
  }
}

}  // namespace
}  // namespace breccia
