// V-149: a scene pays for the effects that it names and for no other, and a step allocates
// nothing. Counted by the callbacks of Kokkos Tools.
#include "cost/kokkos_log.hpp"
#include "harness/scenes.hpp"
#include "io/digest.hpp"
#include "scene/state_file.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <set>

namespace breccia {
namespace {

struct Effect {
  std::string name, section;
  bool launches;   ///< whether it launches kernels of its own in a step
  bool allocates;  ///< whether it has memory of its own
};

const std::vector<Effect> kEffects = {
    {"gravity", "[gravity]\nacceleration = [0, -9.81]\n", false, false},
    {"boundary",
     "[[boundary]]\nwhere = \"b.left\"\nfixed = [0, 0]\n"
     "[[boundary]]\nwhere = \"b.right\"\npressure = \"1 kPa\"\n",
     true, true},
    {"fracture",
     "[fracture.m]\ntensile_strength = \"10 MPa\"\ncohesion = \"20 MPa\"\nfriction_angle = \"40 "
     "deg\"\n"
     "energy_tension = \"10 kJ/m2\"\nenergy_shear = \"30 kJ/m2\"\nalpha = 1\n",
     true, true},
    {"contact", "[contact]\nfriction = 0.3\n", true, true},
    {"sensor", "[[sensor]]\nname = \"s\"\npoint = [0.4, 0.4]\n", false, true},
    // Complete before a step is looked at: while it lasts, each step asks for an energy.
    {"excavation", "[[excavate]]\nbox = { lower = [0, 0], upper = [0.3, 0.3] }\nrelease = 1e-3\n",
     true, true},
    {"rigid",
     "[[body]]\nname = \"r\"\nmaterial = \"m\"\nrigid = true\n"
     "shape = { rectangle = { corner = [0, 2], size = [1, 1] } }\n"
     "mesh = { generator = \"structured\", cells = [2, 2] }\n",
     true, true}};

BlockScene with(const std::vector<std::string>& sections) {
  BlockScene scene;
  for (const std::string& s : sections) scene.more += s;
  return scene;
}

/// Everything that a run of some steps with history rows does, from reading the scene on.
template <class Look>
void run_logged(const BlockScene& scene, const Look& look) {
  const KokkosLog log;
  SceneWorld<2> world(scene.text());
  world.simulation.start();
  put_field<NodeVelocity<2>, 2>(world, [](const Vec<2>& x) { return Vec<2>{{x[1], 0.3 * x[0]}}; });
  world.steps(60);
  Row row;
  for (const auto& m : world.simulation.modules())
    m->observe(world.model(), world.simulation.clock(), Moment::before, row);
  world.step_and_book();
  look(world, log);
}

bool has_tasks(SceneWorld<2>& world, const std::string& effect) {
  for (const Task& task : world.simulation.plan().tasks())
    if (task.effect == effect) return true;
  return false;
}

TEST(Cost, AnAbsentEffectCostsNothing) {
  run_logged(BlockScene{}, [](SceneWorld<2>& world, const KokkosLog& log) {
    EXPECT_GT(log.launches_of("motion"), 0);
    EXPECT_GT(log.launches_of("solid"), 0);
    for (const Effect& effect : kEffects) {
      EXPECT_EQ(log.launches_of(effect.name), 0) << effect.name;
      EXPECT_EQ(log.allocations_of(effect.name), 0) << effect.name;
      EXPECT_EQ(world.store().bytes(effect.name), 0u) << effect.name;
      EXPECT_FALSE(has_tasks(world, effect.name)) << effect.name;
    }
  });
}

// Nothing is hidden under other names: each allocation is a field of motion or solid, or bears
// their name.
TEST(Cost, AnElasticSceneAllocatesForMotionAndSolidOnly) {
  run_logged(BlockScene{}, [](SceneWorld<2>& world, const KokkosLog& log) {
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

// The same counters must see an effect that is there.
TEST(Cost, APresentEffectIsCounted) {
  for (const Effect& effect : kEffects)
    run_logged(with({effect.section}), [&effect](SceneWorld<2>& world, const KokkosLog& log) {
      EXPECT_EQ(log.launches_of(effect.name) > 0, effect.launches || effect.name == "sensor")
          << effect.name;
      EXPECT_EQ(has_tasks(world, effect.name), effect.launches) << effect.name;
      const bool memory =
          log.allocations_of(effect.name) > 0 || world.store().bytes(effect.name) > 0;
      EXPECT_EQ(memory, effect.allocates) << effect.name;
      for (const Effect& other : kEffects) {
        if (other.name == effect.name) continue;
        EXPECT_EQ(log.launches_of(other.name), 0) << other.name << " beside " << effect.name;
        EXPECT_EQ(world.store().bytes(other.name), 0u) << other.name << " beside " << effect.name;
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
  for (const Effect& effect : kEffects) all.push_back(effect.section);
  for (const BlockScene& scene : {BlockScene{}, with(all)}) {
    const KokkosLog::Record record = step_record(scene);
    for (const auto& [label, count] : record.allocations)
      ADD_FAILURE() << label << " is allocated " << count << " times in ten steps";
    for (const std::string& copy : record.copies) ADD_FAILURE() << "copied: " << copy;
    EXPECT_FALSE(record.launches.empty());
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
  SceneWorld<2> world(with({kEffects[1].section}).text());
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
  SceneWorld<2> world(with({kEffects[3].section}).text());
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
  BlockScene scene = with({kEffects[3].section});
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
  const auto fixed = [](std::vector<std::string> sections) {
    BlockScene scene = with(sections);
    scene.run = "duration = 1\nstep = 5e-5";
    return scene;
  };
  const std::string plain = hash_after(fixed({}), 200);
  EXPECT_EQ(hash_after(fixed({"[gravity]\nacceleration = [0, 0]\n"}), 200), plain);
  EXPECT_EQ(hash_after(fixed({kEffects[4].section}), 200), plain);
  EXPECT_EQ(hash_after(fixed({kEffects[2].section}), 200), plain);
  EXPECT_EQ(hash_after(fixed({kEffects[3].section}), 200), plain);
  EXPECT_NE(hash_after(fixed({kEffects[0].section}), 200), plain);
}

}  // namespace
}  // namespace breccia
