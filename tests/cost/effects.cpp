// V-149: a scene pays for the effects that it names and for no other, and a step allocates
// nothing. Counted by the callbacks of Kokkos Tools.
#include "cost/effect_scenes.hpp"
#include "cost/kokkos_log.hpp"
#include "io/digest.hpp"
#include "scene/state_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace breccia {
namespace {

/// The block in the plane with one effect, or with several.
BlockScene with(const std::vector<std::string>& effects) {
  std::string sections;
  for (const EffectCase& effect : effect_cases(2))
    if (std::find(effects.begin(), effects.end(), effect.name) != effects.end())
      sections += effect.section;
  return cost_block(2, sections);
}

/// Everything that a run of some steps with history rows does, from reading the scene on.
template <int D, class Look>
void run_logged(const BlockScene& scene, const Look& look) {
  const KokkosLog log;
  SceneWorld<D> world(scene.text());
  world.simulation.start();
  put_field<NodeVelocity<D>, D>(world, [](const Vec<D>& x) {
    Vec<D> v = Vec<D>::zero();
    v[0] = x[1];
    v[1] = 0.3 * x[0];
    return v;
  });
  world.steps(60);
  Row row;
  for (const auto& m : world.simulation.modules())
    m->observe(world.model(), world.simulation.clock(), Moment::before, row);
  world.step_and_book();
  look(world, log);
}

template <int D>
bool has_tasks(SceneWorld<D>& world, const std::string& effect) {
  for (const Task& task : world.simulation.plan().tasks())
    if (task.effect == effect) return true;
  return false;
}

template <int D>
void expect_nothing_of(const EffectCase& effect, SceneWorld<D>& world, const KokkosLog& log) {
  EXPECT_EQ(log.launches_of(effect.name), 0) << effect.name;
  EXPECT_EQ(log.allocations_of(effect.name), 0) << effect.name;
  EXPECT_EQ(world.store().bytes(effect.name), 0u) << effect.name;
  EXPECT_FALSE(has_tasks(world, effect.name)) << effect.name;
}

template <int D>
void expect_work_of(const EffectCase& effect, SceneWorld<D>& world, const KokkosLog& log) {
  EXPECT_EQ(log.launches_of(effect.name) > 0, effect.launches) << effect.name;
  EXPECT_EQ(has_tasks(world, effect.name), effect.tasks) << effect.name;
  const bool memory = log.allocations_of(effect.name) > 0 || world.store().bytes(effect.name) > 0;
  EXPECT_EQ(memory, effect.memory) << effect.name;
}

/// With none, with each, and with each pair of effects: what the scene names is there, and of
/// everything else neither a byte, a task, an allocation nor a launch.
template <int D>
void check_all_pairs() {
  const std::vector<EffectCase> all = effect_cases(D);
  run_logged<D>(cost_block(D, ""), [&all](SceneWorld<D>& world, const KokkosLog& log) {
    EXPECT_GT(log.launches_of("motion"), 0);
    EXPECT_GT(log.launches_of("solid"), 0);
    for (const EffectCase& effect : all) expect_nothing_of(effect, world, log);
  });
  for (std::size_t a = 0; a < all.size(); ++a)
    for (std::size_t b = a; b < all.size(); ++b) {
      SCOPED_TRACE(all[a].name + " and " + all[b].name);
      const std::string sections = all[a].section + (a == b ? "" : all[b].section);
      run_logged<D>(cost_block(D, sections), [&](SceneWorld<D>& world, const KokkosLog& log) {
        for (std::size_t e = 0; e < all.size(); ++e)
          if (e == a || e == b)
            expect_work_of(all[e], world, log);
          else
            expect_nothing_of(all[e], world, log);
      });
    }
}

TEST(Cost, OneByOneAndInPairsAScenePaysForWhatItNames) {
  check_all_pairs<2>();
}

TEST(Cost, TheSameInSpace) {
  check_all_pairs<3>();
}

// What a material does not do has no field, in scenes of other materials' laws too.
TEST(Cost, AnAbsentPartOfTheSolidHasNoField) {
  for (std::size_t with = 0; with <= kPartCases.size(); ++with) {
    BlockScene scene;
    if (with < kPartCases.size()) scene.material = kPartCases[with].material;
    if (with == 0) scene.material.clear(), scene.damping = 0.02;
    run_logged<2>(scene, [with](SceneWorld<2>& world, const KokkosLog&) {
      std::set<std::string> fields;
      for (const Store::Block& block : world.store().blocks()) fields.emplace(block.info.name);
      for (std::size_t part = 0; part < kPartCases.size(); ++part) {
        if (kPartCases[part].field.empty()) continue;
        EXPECT_EQ(fields.count(kPartCases[part].field), part == with ? 1u : 0u)
            << kPartCases[part].name;
      }
    });
  }
}

// Nothing is hidden under other names: each allocation is a field of motion or solid, or bears
// their name.
TEST(Cost, AnElasticSceneAllocatesForMotionAndSolidOnly) {
  run_logged<2>(BlockScene{}, [](SceneWorld<2>& world, const KokkosLog& log) {
    std::set<std::string> fields;
    for (const Store::Block& block : world.store().blocks()) {
      EXPECT_TRUE(block.owner == "motion" || block.owner == "solid") << block.info.name;
      fields.insert("breccia::" + std::string(block.info.name));
    }
    for (const auto& [label, count] : log.record().allocations) {
      const bool own = label.rfind("breccia::motion::", 0) == 0 ||
                       label.rfind("breccia::solid::", 0) == 0 || label.rfind("Kokkos::", 0) == 0;
      // The host copies of fields that the start state is made in.
      const bool field =
          fields.count(label) != 0 || fields.count(label.substr(0, label.find("_mirror"))) != 0;
      EXPECT_TRUE(own || field) << label << " is allocated " << count << " times";
    }
  });
}

/// Launches, allocations, copies and fences of one ordinary step.
KokkosLog::Record step_record(const BlockScene& scene) {
  SceneWorld<2> world(scene.text());
  world.simulation.start();
  world.steps(60);  // past the first lists and the first renewal of the step
  const KokkosLog log;
  for (int i = 0; i < 10; ++i) world.step();
  return log.record();
}

TEST(Cost, AStepAllocatesCopiesAndWaitsForNothing) {
  std::vector<std::string> all;
  for (const EffectCase& effect : effect_cases(2))
    if (effect.name != "rest") all.push_back(effect.name);  // it sums up an energy
  for (const BlockScene& scene : {BlockScene{}, with(all)}) {
    const KokkosLog::Record record = step_record(scene);
    for (const auto& [label, count] : record.allocations)
      ADD_FAILURE() << label << " is allocated " << count << " times in ten steps";
    for (const std::string& copy : record.copies) ADD_FAILURE() << "copied: " << copy;
    EXPECT_FALSE(record.launches.empty());
  }
}

// What the cost sheet says of the memory that no field holds, against what the effect holds.
TEST(Cost, BytesOfModulesAreThoseOfKokkos) {
  for (const char* effect : {"fracture", "contact"}) {
    const KokkosLog log;
    SceneWorld<2> world(with({effect}).text());
    world.simulation.start();
    world.steps(60);
    std::size_t told = 0;
    for (const auto& m : world.simulation.modules())
      if (m->key() == effect) told = m->bytes();
    const auto held = static_cast<std::size_t>(log.held_by(effect));
    EXPECT_GT(held, 0u) << effect;
    EXPECT_NEAR(static_cast<double>(told), static_cast<double>(held), 0.1 * held) << effect;
  }
}

TEST(Cost, AnElasticStepIsTwoLaunches) {
  const KokkosLog::Record record = step_record(BlockScene{});
  EXPECT_EQ(record.launches.at("breccia::solid::element_force"), 10);
  EXPECT_EQ(record.launches.at("breccia::motion::node_motion"), 10);
  EXPECT_EQ(record.launches.size(), 2u);
}

TEST(Cost, LaunchesOfTheCostSheetAreThoseOfKokkos) {
  const KokkosLog log;
  SceneWorld<2> world(with({"boundary"}).text());
  world.simulation.start();
  const std::int64_t before = log.launches();
  world.steps(120);
  std::int64_t booked = 0;
  for (const Cost& cost : world.simulation.plan().costs()) booked += cost.launches;
  EXPECT_EQ(booked, log.launches() - before);
}

// A body that moves as a whole and touches nothing: no point has anybody near it, so that contact
// is one look at the surface's nodes in eight steps, and a search now and then.
TEST(Cost, ContactOfAWholeBodyIsALookNowAndThen) {
  SceneWorld<2> world(with({"contact"}).text());
  world.simulation.start();
  put_field<NodeVelocity<2>, 2>(world, [](const Vec<2>& x) {
    return Vec<2>{{0.1 - 0.1 * x[1], 0.1 * x[0]}};
  });
  world.steps(20);
  const KokkosLog log;
  world.steps(400);
  Counts counts;
  for (const auto& m : world.simulation.modules()) m->count(world.model(), counts);
  EXPECT_EQ(counts.contact_points, 0);
  EXPECT_EQ(world.store().count(Entity::contact_point), 0);
  EXPECT_EQ(log.record().launches.count("breccia::contact::force"), 0u);
  EXPECT_LE(log.record().launches.at("breccia::contact::node_way"), 51);
}

// A fragment that flies off does not make all others search.
TEST(Cost, FragmentsThatFlyClearNeedNoSearch) {
  BlockScene scene = with({"contact"});
  scene.more +=
      "[[body]]\nname = \"fragment\"\nmaterial = \"m\"\nvelocity = [0, 500]\n"
      "shape = { rectangle = { corner = [0.4, 1.05], size = [0.1, 0.1] } }\n"
      "mesh = { generator = \"structured\", cells = [2, 2] }\n";
  SceneWorld<2> world(scene.text());
  world.simulation.start();
  world.steps(60);
  const KokkosLog log;
  world.steps(400);
  EXPECT_LE(log.record().launches.at("breccia::contact::node_way"), 60);
  EXPECT_EQ(log.record().launches.count("breccia::contact::boxes"), 0u);
}

std::string hash_after(const BlockScene& scene, int steps) {
  SceneWorld<2> world(scene.text());
  world.simulation.start();
  put_field<NodeVelocity<2>, 2>(world, [](const Vec<2>& x) {
    return Vec<2>{{std::sin(3 * x[1]), std::cos(2 * x[0])}};
  });
  world.steps(steps);
  Digest digest;
  const std::size_t bytes = sizeof(double) * 2 * static_cast<std::size_t>(world.model().nodes());
  digest.update(world.host<NodePosition<2>>().data(), bytes);
  digest.update(world.host<NodeVelocity<2>>().data(), bytes);
  return hex16(digest.value());
}

// Effects that are named and have nothing to do leave every bit alone: no weight, a sensor, a
// strength far above the stress, contact with nobody near.
TEST(Cost, NeutralEffectsDoNotChangeTheBits) {
  // A fixed step, for springs that may come lower the factor of the automatic one.
  const auto fixed = [](BlockScene scene) {
    scene.run = "duration = 1\nstep = 5e-5";
    return scene;
  };
  const std::string plain = hash_after(fixed(with({})), 200);
  EXPECT_EQ(hash_after(fixed(cost_block(2, "[gravity]\nacceleration = [0, 0]\n")), 200), plain);
  for (const char* effect : {"sensor", "fracture", "contact"})
    EXPECT_EQ(hash_after(fixed(with({effect})), 200), plain) << effect;
  EXPECT_NE(hash_after(fixed(with({"gravity"})), 200), plain);
}

}  // namespace
}  // namespace breccia
