#include "harness/fracture_world.hpp"
#include "mesh/geometry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace breccia {
namespace {

// A bar of 10 mm pulled at a constant rate of strain: both ends and all points between start with
// the velocity of uniform stretching, so that no wave disturbs it. Its middle section is weak.
constexpr double kLength = 10e-3, kStrength = 8e6, kEnergy = 50;
constexpr double kRate = 40;  // 1/s

template <int D>
struct Bar {
  static constexpr double area = D == 2 ? 1e-3 : 1e-6;

  static std::string scene(const std::string& alpha, const std::string& softening,
                           const std::string& more = "") {
    const std::string law =
        "[[interface]]\nbetween = [\"rock\", \"other\"]\ntensile_strength = 8e6\ncohesion = 24e6\n"
        "friction_angle = \"50 deg\"\nenergy_tension = 50\nenergy_shear = 500\nalpha = " +
        alpha + "\nsoftening = \"" + softening + "\"\n" + more;
    const std::string free = D == 2 ? "\"free\"]" : "\"free\", \"free\"]";
    const std::string ends = "[[boundary]]\nwhere = \"block.left\"\nvelocity = [-0.2, " + free +
                             "\n[[boundary]]\nwhere = \"block.right\"\nvelocity = [0.2, " + free +
                             "\n";
    return D == 2 ? block_scene(2, "cross", "[20, 2]", "[10e-3, 1e-3]", law, ends)
                  : block_scene(3, "kuhn", "[20, 2, 2]", "[10e-3, 1e-3, 1e-3]", law, ends);
  }

  static void give_right_half(Model<D>& model) {
    for (Index e = 0; e < model.elements(); ++e)
      if (model.mesh.body[e] == 0 && centroid<D>(corners(model.mesh, e))[0] > kLength / 2)
        model.mesh.body[e] = 1;
    // Poisson's ratio would make waves at the ends.
    for (Material& material : model.materials) material.poisson = 0;
  }

  explicit Bar(const std::string& scene) : world(scene, give_right_half) {
    world.start();
    world.set_velocity([](const Vec<D>& x) {
      Vec<D> v = Vec<D>::zero();
      if (x[0] < 0.5) v[0] = kRate * (x[0] - kLength / 2);
      return v;
    });
  }

  /// Force between the halves through corners that have split, N.
  double held() {
    const auto force = world.template host<InterfacePairForce<D>>();
    double sum = 0;
    for (Index i = 0; i < world.model.store.count(Entity::interface); ++i)
      for (int c = 0; c < D; ++c) sum += force(i, c, 0);
    return std::abs(sum);
  }

  FractureWorld<D> world;
};

struct Outcome {
  double peak = 0, worst_1 = 0, worst_2 = 0;
  Ledger end;
  Counts counts;
  std::vector<Event> events;
};

template <int D>
Outcome pull_apart(Bar<D>& bar) {
  Outcome out;
  // The halves part at 0.4 m/s; w_f is 12.5 um, 16.2 um for the z-curve.
  while (bar.world.clock.time < 5.5e-5) {
    if (bar.world.clock.step % 10 != 0) {
      bar.world.step();
    } else {
      const Ledger ledger = bar.world.step_and_book();
      out.worst_1 = std::max(out.worst_1, ledger.residual_1());
      out.worst_2 = std::max(out.worst_2, ledger.residual_2());
      out.end = ledger;
    }
    out.peak = std::max(out.peak, bar.held());
  }
  bar.world.fracture.count(bar.world.model, out.counts);
  out.events = bar.world.fracture.take_events();
  return out;
}

template <int D>
void check_bar(const std::string& alpha, const std::string& softening) {
  SCOPED_TRACE("alpha " + alpha + " " + softening);
  Bar<D> bar(Bar<D>::scene(alpha, softening));
  const Outcome out = pull_apart(bar);
  EXPECT_NEAR(out.peak / (kStrength * Bar<D>::area), 1, 0.01);
  EXPECT_NEAR(out.end.value("IF_G1") / (kEnergy * Bar<D>::area), 1, 1e-4);
  EXPECT_NEAR(out.end.value("IF_G2"), 0, 1e-6 * kEnergy * Bar<D>::area);
  EXPECT_NEAR(out.end.value("IF_stored"), 0, 1e-6 * kEnergy * Bar<D>::area);
  EXPECT_LT(out.worst_1, 1e-12);
  EXPECT_LT(out.worst_2, 1e-3);
  const int faces = D == 2 ? 2 : 8;
  EXPECT_EQ(out.counts.released, faces);
  EXPECT_EQ(out.counts.inserted, 0);
  ASSERT_EQ(out.events.size(), static_cast<std::size_t>(faces));
  for (const Event& event : out.events) {
    EXPECT_NEAR(event.place[0], kLength / 2, 1e-4);
    EXPECT_NEAR(std::abs(event.normal[0]), 1, 1e-6);
    EXPECT_NEAR(event.mode, 1, 1e-3);
    EXPECT_NEAR(event.energy_tension / (kEnergy * event.area), 1, 1e-3);
  }
}

TEST(FractureBar, StrengthAndEnergyDoNotDependOnAlpha2d) {
  for (const std::string alpha : {"0", "0.5", "0.95", "1"})
    for (const std::string softening : {"linear", "z_curve"}) check_bar<2>(alpha, softening);
}

TEST(FractureBar, StrengthAndEnergyDoNotDependOnAlpha3d) {
  for (const std::string alpha : {"0", "0.95"}) check_bar<3>(alpha, "linear");
}

/// Uniform stretching at kRate, eight times the reference: twice the strength, the same energy.
template <int D>
void check_rate() {
  Bar<D> bar(
      Bar<D>::scene("0.95", "linear", "rate_reference = 5\nrate_exponent = 0.3333333333333333\n"));
  const Outcome out = pull_apart(bar);
  EXPECT_NEAR(out.peak / (2 * kStrength * Bar<D>::area), 1, 0.01);
  EXPECT_NEAR(out.end.value("IF_G1") / (kEnergy * Bar<D>::area), 1, 1e-4);
  EXPECT_LT(out.worst_2, 1e-3);
}

TEST(FractureBar, StrengthFollowsTheRateAtInsertion) {
  check_rate<2>();
  check_rate<3>();
}

}  // namespace
}  // namespace breccia
