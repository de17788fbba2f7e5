// Laws of friction other than Coulomb's, on a block that a spring pulls or a plate drives.
#include "contact_samples.hpp"
#include "harness/scenes.hpp"
#include "modules/contact/contact_fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace {

using namespace breccia;

constexpr double kG = 9.81, kMass = 10;  // 0.2 m x 0.025 m x 1 m of 2000 kg/m3
constexpr double kWeight = kMass * kG, kDrop = 0.2 * kWeight, kWeakening = 1e-3;
constexpr double kCritical = kDrop / kWeakening;

/// The block of V-044 on a floor that is held: gravity stands for the spring and its dashpot.
class Slider {
 public:
  Slider(double stiffness, double damping)
      : world(contact_scene(
            {{"floor", "[-0.05, -0.05]", "[0.35, 0.05]", "[12, 1]"},
             {"block", "[0, 0]", "[0.2, 0.025]", "[8, 1]"}},
            "density = 2000\ndamping = 1.0\nelastic = { young = 20e6, poisson = 0.2 }\n",
            "friction = 0.6\ndamping = 0.5\nlaw = \"slip_weakening\"\ndynamic = 0.4\n"
            "weakening_slip = 1e-3",
            {},
            "[gravity]\nacceleration = [0, 0]\n[[boundary]]\nwhere = \"floor\"\nfixed = [0, 0]\n")),
        stiffness_(stiffness),
        damping_(damping) {
    world.simulation.start();
    run_to(world, 0.05, [&] {
      const double weight = std::min(1.0, world.time() / 0.03);
      const double along = std::clamp((world.time() - 0.03) / 0.02, 0.0, 1.0);
      pull_ = 0.58 * along * kWeight;
      world.model().gravity = {{pull_ / kMass, -weight * kG}};
      world.step();
    });
    start_ = momentum(world, "block").centre[0];
    loaded_ = pull_ / stiffness_;
  }

  /// One step at the other end's speed `drive`; leaves `speed`, `pull`, `slid`.
  void step(double drive) {
    loaded_ += drive * world.simulation.clock().dt;
    const Momentum block = momentum(world, "block");
    speed = block.velocity()[0];
    slid = block.centre[0] - start_;
    pull_ = stiffness_ * (loaded_ - slid);
    world.model().gravity = {{(pull_ + damping_ * (drive - speed)) / kMass, -kG}};
    world.step();
  }
  double pull() const { return pull_; }

  SceneWorld<2> world;
  double speed = 0, slid = 0;

 private:
  double stiffness_, damping_, pull_ = 0, start_ = 0, loaded_ = 0;
};

// Above k_c the block weakens steadily, k / (k - k_c) = 6 times as fast as the drive.
TEST(ContactFrictionLaws, StiffSpringSlidesSteadily) {
  Slider slider(1.2 * kCritical, 2 * std::sqrt(0.2 * kCritical * kMass));
  double fastest = 0;
  run_to(slider.world, 0.9, [&] {
    slider.step(5e-4);
    fastest = std::max(fastest, slider.speed);
  });
  std::printf("fastest %.5f m/s, pull at the end %.5f of the weight\n", fastest,
              slider.pull() / kWeight);
  EXPECT_NEAR(fastest, 3e-3, 0.05 * 3e-3);
  EXPECT_NEAR(slider.pull(), 0.4 * kWeight, 0.01 * kWeight);
}

// Below it, an event: N ds (mu_s - mu_d) = k ds^2 / 2 + N (mu_s - mu_d) D_c / 2 and the heat
// N (mu_d ds + (mu_s - mu_d) D_c / 2). The drive stops when the block has begun.
TEST(ContactFrictionLaws, SoftSpringSlipsAsItsEnergySays) {
  const double k = 0.2 * kCritical;
  Slider slider(k, 0);
  SceneWorld<2>& world = slider.world;
  const double before = world.step_and_book().value("CT_friction");
  while (slider.pull() < 0.599 * kWeight) slider.step(0.01);
  while (slider.speed < 1e-3 && world.time() < 3) slider.step(1e-4);
  while (slider.speed > 0 && world.time() < 3) slider.step(0);
  ASSERT_LT(world.time(), 3);
  const Ledger ledger = world.step_and_book();
  const double slip = (kDrop + std::sqrt(kDrop * kDrop - k * kDrop * kWeakening)) / k;
  const double slid = (0.6 * kWeight - slider.pull()) / k;
  const double heat = kWeight * (0.4 * slid + 0.2 * kWeakening / 2);
  const double spent = ledger.value("CT_friction") - before;
  std::printf("slip %.5f of %.5f m, heat %.4f of %.4f J, res_1 %.1e, res_2 %.1e\n", slid, slip,
              spent, heat, ledger.residual_1(), ledger.residual_2());
  EXPECT_NEAR(slid, slip, 0.01 * slip);
  EXPECT_NEAR(spent, heat, 0.01 * heat);
  EXPECT_LT(std::abs(ledger.residual_1()), 1e-12);
  EXPECT_LT(std::abs(ledger.residual_2()), 0.01);
}

/// Drag over pressure of all contact on a body.
double friction_on(SceneWorld<2>& world, const std::string& body) {
  const auto force = world.host<ContactForce<2>>();
  const Mesh<2>& mesh = world.model().mesh;
  Vec<2> sum = Vec<2>::zero();
  for (Index e = 0; e < mesh.elements(); ++e)
    for (int a = 0; a < 3; ++a)
      if (mesh.body[static_cast<std::size_t>(e)] == find_body(mesh, body))
        for (int d = 0; d < 2; ++d) sum[d] += force(e, a, d);
  return -sum[0] / sum[1];
}

// A plate at 1 mm/s over an elastic floor, then at 10 mm/s: mu goes up by a ln 10 at once, and
// ends (a - b) ln 10 above where it was.
TEST(ContactFrictionLaws, StepsOfSpeedFollowRateAndState) {
  for (const char* law : {"ageing", "slip_law"}) {
    Slab plate{"plate", "[0, 0]", "[0.1, 0.05]", "[4, 2]"};
    plate.velocity = "[\"1 mm/s\", 0]\nrigid = true";
    SceneWorld<2> world(contact_scene(
        {{"floor", "[-0.05, -0.05]", "[0.2, 0.05]", "[8, 2]"}, plate},
        "density = 2000\ndamping = 1.0\nelastic = { young = 20e6, poisson = 0.2 }\n",
        fmt::format("friction = 0.6\ndamping = 0.1\nlaw = \"{}\"\na = 0.010\nb = 0.015\n"
                    "state_slip = \"0.1 mm\"\nreference_speed = \"1 mm/s\"",
                    law),
        {},
        "[gravity]\nacceleration = [0, -9.81]\nramp = 0.03\n"
        "[[boundary]]\nwhere = \"floor.bottom\"\nfixed = [0, 0]\n"
        "[[boundary]]\nwhere = \"plate\"\nvelocity = [\"1 mm/s\", \"free\"]\n"
        "table = [[0, 1], [0.15, 1], [0.15001, 10], [1, 10]]\n"));
    world.simulation.start();
    run_to(world, 0.15);
    const double before = friction_on(world, "plate"), decade = std::log(10.0);
    double peak = 0;
    run_to(world, 0.23, [&] {
      world.step();
      peak = std::max(peak, friction_on(world, "plate"));
    });
    const double after = friction_on(world, "plate");
    const Ledger ledger = world.step_and_book();
    std::printf("%s: %.5f, up by %.4f of a ln 10, ends %.4f of (a - b) ln 10; res_2 %.1e\n", law,
                before, (peak - before) / (0.010 * decade), (after - before) / (-0.005 * decade),
                ledger.residual_2());
    EXPECT_NEAR(before, 0.6, 2e-4);
    EXPECT_NEAR(peak - before, 0.010 * decade, 0.03 * 0.010 * decade);
    EXPECT_NEAR(after - before, -0.005 * decade, 0.03 * 0.005 * decade);
    EXPECT_LT(std::abs(ledger.residual_2()), 0.01);
  }
}

/// How far the half of the unit block above its middle has gone along x, and its speed.
void upper_half(SceneWorld<2>& world, double& slid, double& speed) {
  const auto nodes = world.host<ElementNodes<2>>();
  const auto x = world.host<NodePosition<2>>(), reference = world.host<NodeReference<2>>();
  const auto v = world.host<NodeVelocity<2>>();
  double count = 0;
  slid = speed = 0;
  for (Index e = 0; e < world.model().elements(); ++e) {
    double y = 0;
    for (int a = 0; a < 3; ++a) y += reference(nodes(e, a), 1) / 3;
    if (y < 0.5) continue;
    for (int a = 0; a < 3; ++a, count += 1) {
      slid += x(nodes(e, a), 0) - reference(nodes(e, a), 0);
      speed += v(nodes(e, a), 0);
    }
  }
  slid /= count;
  speed /= count;
}

// A fault that has slid past its weakening slip goes on as contact without its strength coming
// back: v^2 / 2 = s g sin 30 - g cos 30 (mu_d s + (mu_s - mu_d) D_c / 2).
TEST(ContactFrictionLaws, FaultsHandTheirSlipOver) {
  const std::string law = "law = \"slip_weakening\"\ndynamic = 0.2\nweakening_slip = 0.05\n";
  BlockScene scene{2, "[1, 1]", "[8, 8]"};
  scene.damping = 0.1;
  scene.more =
      "[gravity]\nacceleration = [4.905, -8.4957]\nramp = 0.02\n"
      "[[boundary]]\nwhere = \"b.bottom\"\nfixed = [0, 0]\n"
      "[[fractures]]\nname = \"f\"\nbody = \"b\"\nkind = \"closed\"\n"
      "lines = [[[0, 0.5], [1, 0.5]]]\n[fractures.friction]\ncoefficient = 0.5\n" +
      law + "[contact]\nfriction = 0.5\n" + law;
  SceneWorld<2> world(scene.text());
  world.simulation.start();
  double slid = 0, speed = 0;
  while (slid < 0.1 && world.time() < 1) {
    ASSERT_FALSE(world.model().stop.raised) << world.model().stop.cause;
    world.steps(10);
    upper_half(world, slid, speed);
  }
  const double g = 9.81, cosine = std::sqrt(0.75);
  const double expected =
      std::sqrt(2 * (slid * 0.5 * g - g * cosine * (0.2 * slid + 0.3 * 0.05 / 2)));
  const auto rubbed = world.host<ContactRubbed>();
  const auto memory = world.host<ContactMemory<2>>();
  int pressing = 0;
  for (Index a = 0; a < world.store().count(Entity::contact_point); ++a) {
    if (!(memory(a, 0, ContactHistory<2>::depth) > 0)) continue;
    ++pressing;
    EXPECT_GT(rubbed(a, 0, 0), 0.0625);  // half a face, with which contact began
    EXPECT_LT(rubbed(a, 0, 0), 1.05 * slid);
  }
  std::printf("%d points, %.4f m/s of %.4f m/s after %.4f m\n", pressing, speed, expected, slid);
  EXPECT_GT(pressing, 10);
  EXPECT_NEAR(speed, expected, 0.02 * expected);
}

}  // namespace
