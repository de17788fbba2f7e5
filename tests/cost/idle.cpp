// An effect that is there and has nothing to do costs below 2 % of the step, and one that works
// somewhere costs what it does there. Times: run alone (RUN_SERIAL).
#include "core/log.hpp"
#include "cost/effect_scenes.hpp"
#include "cost/paired.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace breccia {
namespace {

/// Pairs of worlds per effect: where memory happens to lie makes twins differ by a hundredth.
constexpr int kPairs = 5;
constexpr int kTurns = 12, kSteps = 20;

template <int D>
std::unique_ptr<SceneWorld<D>> started(const BlockScene& scene) {
  auto world = std::make_unique<SceneWorld<D>>(scene.text());
  world->simulation.start();
  world->steps(60);  // past the first lists and the first renewal of the step
  return world;
}

/// What the sections add to the time of a step, as a share of it.
template <int D>
double share_of(const BlockScene& without, const BlockScene& with) {
  log::set_quiet(true);
  std::vector<double> ratio;
  for (int pair = 0; pair < kPairs; ++pair) {
    const auto a = started<D>(without), b = started<D>(with);
    ratio.push_back(paired_ratio(
        kTurns, [&] { a->steps(kSteps); }, [&] { b->steps(kSteps); }));
  }
  return median(ratio) - 1;
}

/// A true cost of 2 % in the plane and of 4 % in space (docs/cost.md), and a hundredth for the
/// machine.
template <int D>
constexpr double kBound = D == 2 ? 0.03 : 0.05;

template <int D>
void expect_idle(const std::vector<EffectCase>& effects) {
  for (const EffectCase& effect : effects) {
    const double share = share_of<D>(turning_block(D, ""), turning_block(D, effect.section));
    ::testing::Test::RecordProperty(fmt::format("{}_{}d", effect.name, D),
                                    fmt::format("{:.4f}", share));
    EXPECT_LT(share, kBound<D>) << effect.name;
  }
}

/// The effects of effect_cases() that have nothing to do on a block that turns, by name.
std::vector<EffectCase> idle(int dimension, const std::vector<std::string>& names) {
  std::vector<EffectCase> list;
  for (const EffectCase& effect : effect_cases(dimension))
    if (std::find(names.begin(), names.end(), effect.name) != names.end()) list.push_back(effect);
  return list;
}

TEST(SlowIdle, InThePlaneItCostsBelowTwoPercent) {
  std::vector<EffectCase> effects = idle(2, {"fracture", "contact", "sensor", "rigid"});
  effects.push_back({"gravity", "[gravity]\nacceleration = [0, 0]\n"});
  expect_idle<2>(effects);
  BlockScene damped = turning_block(2, "");
  damped.damping = 0.02;
  // The same measure sees what is not idle.
  EXPECT_GT(share_of<2>(turning_block(2, ""), damped), 0.1);
}

TEST(SlowIdle, InSpaceItCostsBelowFourPercent) {
  expect_idle<3>(idle(3, {"fracture", "contact", "sensor", "rigid"}));
}

// Twins show how far the measure can be trusted; damping = 0 is a twin.
TEST(SlowIdle, DampingOfZeroIsNone) {
  BlockScene zero = turning_block(2, ""), none = zero;
  none.damping = 0;
  zero.material = "bulk_viscosity = [0, 0]";
  EXPECT_LT(std::abs(share_of<2>(none, zero)), 0.015);
}

/// A block with a closed fracture and an open crack, under pressure all around, so that the one is
/// stuck and the other touches: fracture and contact work there and nowhere else.
BlockScene cracked(const std::string& size, const std::string& cells) {
  BlockScene scene =
      cost_block(2,
                 "[[fractures]]\nname = \"fault\"\nbody = \"b\"\nkind = \"closed\"\n"
                 "lines = [[[0.1, 0.5], [0.9, 0.5]]]\nfriction = { coefficient = 0.3 }\n"
                 "[[fractures]]\nname = \"crack\"\nbody = \"b\"\nkind = \"open\"\n"
                 "lines = [[[0.1, 0.25], [0.9, 0.25]]]\n"
                 "[[initial_stress]]\nstress = [\"-1 kPa\", \"-1 MPa\", 0, 0]\n"
                 "[[boundary]]\nwhere = \"b.top\"\npressure = \"1 MPa\"\n"
                 "[[boundary]]\nwhere = \"b.bottom\"\npressure = \"1 MPa\"\n" +
                     effect_cases(2)[2].section + effect_cases(2)[3].section);
  scene.size = size;
  scene.cells = cells;
  scene.pattern = "right";
  return scene;
}

Cost cost_of(SceneWorld<2>& world, const std::string& effect) {
  for (const Cost& cost : world.simulation.plan().costs())
    if (cost.effect == effect) return cost;
  return {};
}

/// Least seconds of some steps, on the clock, to which other work only adds; and their launches.
struct Least {
  double seconds = 1e300;
  std::int64_t launches = 0;

  void look(SceneWorld<2>& world, const std::string& effect) {
    const Cost before = cost_of(world, effect);
    world.steps(kSteps);
    const Cost after = cost_of(world, effect);
    seconds = std::min(seconds, after.seconds - before.seconds);
    launches += after.launches - before.launches;
  }
};

Counts counts_of(SceneWorld<2>& world) {
  Counts counts;
  for (const auto& m : world.simulation.modules()) m->count(world.model(), counts);
  return counts;
}

TEST(SlowLocal, TwiceTheBlockAroundTheSameCrackCostsTheSame) {
  log::set_quiet(true);
  const char* const effects[] = {"fracture", "contact"};
  Least small[2], large[2];
  for (int pair = 0; pair < kPairs; ++pair) {
    const auto a = started<2>(cracked("[1, 1]", "[100, 100]"));
    const auto b = started<2>(cracked("[2, 1]", "[200, 100]"));
    for (int turn = 0; turn < kTurns; ++turn)
      for (int e = 0; e < 2; ++e) {
        small[e].look(*a, effects[e]);
        large[e].look(*b, effects[e]);
      }
    EXPECT_GT(counts_of(*a).contact_points, 60);
    EXPECT_EQ(counts_of(*a).contact_points, counts_of(*b).contact_points);
    EXPECT_EQ(counts_of(*a).inserted, 80);
    EXPECT_EQ(counts_of(*b).inserted, 80);
  }
  for (int e = 0; e < 2; ++e) {
    RecordProperty(effects[e], fmt::format("{:.3f}", large[e].seconds / small[e].seconds));
    // A tenth, and a twentieth for the machine.
    EXPECT_LT(large[e].seconds, 1.15 * small[e].seconds) << effects[e];
    EXPECT_EQ(large[e].launches, small[e].launches) << effects[e];
  }
}

}  // namespace
}  // namespace breccia
