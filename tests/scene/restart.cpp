// V-147: what is saved and loaded goes on with the same bits.
#include "harness/scenes.hpp"
#include "harness/temp_folder.hpp"
#include "modules/contact/contact_fields.hpp"
#include "scene/state_file.hpp"

#include <gtest/gtest.h>

namespace breccia {
namespace {

const char* kEverything = R"(
[gravity]
acceleration = [0, -9.81]
[[boundary]]
where = "b.left"
velocity = ["3 m/s", "free"]
ramp = "2 ms"
[[boundary]]
where = "b.right"
traction = [0, "2 MPa"]
table = [[0, 0], ["1 ms", 1], ["3 ms", -1]]
[[boundary]]
where = "b.top"
pressure = "5 MPa"
[[sensor]]
name = "s"
point = [0.3, 0.6]
)";

std::string in_space(std::string text) {
  const auto replace = [&text](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  replace("[0, -9.81]", "[0, -9.81, 1]");
  replace("[\"3 m/s\", \"free\"]", "[\"3 m/s\", \"free\", 0]");
  replace("[0, \"2 MPa\"]", "[0, \"2 MPa\", \"1 MPa\"]");
  replace("[0.3, 0.6]", "[0.3, 0.6, 0.2]");
  return text;
}

/// What a run would write of a step: a row with all columns, and the residuals.
template <int D>
std::vector<double> observed_step(SceneWorld<D>& world) {
  Row row;
  Ledger ledger;
  auto& s = world.simulation;
  s.step(1e30, {[&] {
                  s.book_before(ledger);
                  for (const auto& m : s.modules())
                    m->observe(world.model(), s.clock(), Moment::before, row);
                },
                [&] {
                  s.book_after(ledger);
                  for (const auto& m : s.modules())
                    m->observe(world.model(), s.clock(), Moment::after, row);
                }});
  std::vector<double> values = row.values();
  values.insert(values.end(), {ledger.kinetic, ledger.stored(), ledger.dissipated(),
                               ledger.external(), ledger.residual_1(), ledger.residual_2()});
  return values;
}

template <int D>
void check_restart(const BlockScene& scene, int before, int after) {
  const TempFolder folder;
  const std::string file = folder / "state.h5";
  const CheckpointIdentity identity = identity_of(scene.text());

  SceneWorld<D> whole(scene.text());
  whole.simulation.start();
  whole.steps(before);
  OutputState output;
  output.history_rows = 7;
  output.frame_times = {0, 0.5};
  save_state(file, identity, whole.simulation, output);
  whole.steps(after);
  const auto expected = observed_step(whole);

  SceneWorld<D> resumed(scene.text());
  const OutputState read = load_state(file, identity, resumed.simulation);
  EXPECT_EQ(read.history_rows, 7);
  EXPECT_EQ(read.frame_times, output.frame_times);
  EXPECT_EQ(resumed.simulation.clock().step, before);
  resumed.steps(after);
  EXPECT_EQ(observed_step(resumed), expected);
  EXPECT_EQ(resumed.time(), whole.time());
  EXPECT_EQ(state_hash(resumed.simulation), state_hash(whole.simulation));
  EXPECT_EQ(resumed.simulation.step_record().min, whole.simulation.step_record().min);
  EXPECT_EQ(resumed.simulation.counts().released, whole.simulation.counts().released);
}

// Before the first step, between two looks at the stable step, and right at one of them.
TEST(Restart, TrianglesGoOnBitForBit) {
  BlockScene scene;
  scene.jitter = 0.3;
  scene.damping = 0.1;
  scene.more = kEverything;
  for (const int before : {0, 1, 37, 50, 51}) check_restart<2>(scene, before, 80);
  scene.plane = "stress";
  check_restart<2>(scene, 20, 80);
  scene.run += "\nprecision = \"mixed\"";
  check_restart<2>(scene, 37, 80);
}

TEST(Restart, TetrahedraGoOnBitForBit) {
  BlockScene scene{3, "[1, 1, 1]", "[3, 3, 3]"};
  scene.jitter = 0.3;
  scene.damping = 0.1;
  scene.more = in_space(kEverything);
  for (const int before : {0, 37}) check_restart<3>(scene, before, 80);
  scene.run += "\nprecision = \"mixed\"";
  check_restart<3>(scene, 37, 80);
}

// In the middle of the release, and in its last steps; with faces that break at the rim.
TEST(Restart, ExcavationsGoOnBitForBit) {
  BlockScene scene{2, "[1, 1]", "[8, 8]"};
  scene.jitter = 0.25;
  scene.more =
      "[[initial_stress]]\nstress = [4e6, 0, 1e6, 0]\n"
      "[[boundary]]\nwhere = \"b\"\nheld = true\n"
      "[[excavate]]\nbox = { lower = [0.3, 0.3], upper = [0.7, 0.7] }\nrelease = 1e-3\n"
      "[[excavate]]\nbox = { lower = [0, 0], upper = [0.2, 1] }\nat = 8e-4\nrelease = 1e-3\n"
      "[contact]\nfriction = 0.3\n"
      "[fracture.m]\ntensile_strength = 6e6\ncohesion = 20e6\nfriction_angle = 0.7\n"
      "energy_tension = 2000\nenergy_shear = 20000\n";
  SceneWorld<2> world(scene.text());
  world.simulation.start();
  world.steps(210);
  EXPECT_GT(world.time(), 1.81e-3) << "both are to be complete";
  for (const int before : {1, 30, 80, 150}) check_restart<2>(scene, before, 60);
}

/// A block that turns so fast that it bursts; the checkpoint lies where faces break at every step.
BlockScene bursting(int dimension) {
  BlockScene scene{dimension, dimension == 2 ? "[0.1, 0.1]" : "[0.02, 0.02, 0.02]",
                   dimension == 2 ? "[16, 16]" : "[4, 4, 4]"};
  scene.jitter = 0.25;
  scene.density = 2600;
  scene.young = 60e9;
  scene.poisson = 0.25;
  scene.body = dimension == 2 ? "spin = 3500" : "spin = [2000, 5000, 18000]";
  scene.more =
      "[fracture.m]\ntensile_strength = 8e6\ncohesion = 20e6\nfriction_angle = 0.7\n"
      "energy_tension = 20\nenergy_shear = 200\n";
  if (dimension == 2) scene.more += "[contact]\nfriction = 0.3\n";
  return scene;
}

template <int D>
void check_bursting(int before, int after, const std::string& run = {}) {
  BlockScene scene = bursting(D);
  scene.run += run;
  SceneWorld<D> world(scene.text());
  world.simulation.start();
  world.steps(before);
  const Counts at_checkpoint = world.simulation.counts();
  world.steps(after);
  const Counts at_end = world.simulation.counts();
  // Otherwise this would show nothing.
  EXPECT_GT(at_checkpoint.released, 0);
  EXPECT_GT(at_end.released, at_checkpoint.released);
  check_restart<D>(scene, before, after);
}

TEST(Restart, BurstingBlockGoesOnBitForBit) {
  check_bursting<2>(400, 100);
  check_bursting<3>(400, 100);
  check_bursting<2>(400, 100, "\nprecision = \"mixed\"");
}

// Fields and rounding are of another kind: refused, not converted.
TEST(Restart, OfTheOtherPrecisionIsRefused) {
  const TempFolder folder;
  const std::string file = folder / "state.h5";
  BlockScene scene;
  SceneWorld<2> world(scene.text());
  world.simulation.start();
  save_state(file, identity_of(scene.text()), world.simulation, {});
  scene.run += "\nprecision = \"mixed\"";
  SceneWorld<2> mixed(scene.text());
  EXPECT_THROW(load_state(file, identity_of(scene.text()), mixed.simulation), Error);
}

// A fragment that flies off, and one that flies on to a wall: before, on the way and there.
TEST(Restart, FlyingPiecesGoOnBitForBit) {
  BlockScene scene;
  scene.jitter = 0.3;
  scene.more =
      "[contact]\nfriction = 0.3\n"
      "[[body]]\nname = \"off\"\nmaterial = \"m\"\nvelocity = [0, 500]\n"
      "shape = { rectangle = { corner = [0.4, 1.05], size = [0.1, 0.1] } }\n"
      "mesh = { generator = \"structured\", cells = [2, 2] }\n"
      "[[body]]\nname = \"on\"\nmaterial = \"m\"\nvelocity = [-300, 0]\nspin = 5\n"
      "shape = { rectangle = { corner = [2.2, 0.4], size = [0.1, 0.1] } }\n"
      "mesh = { generator = \"structured\", cells = [2, 2] }\n";
  for (const int before : {1, 40, 100, 300}) check_restart<2>(scene, before, 100);
}

// A rigid hammer beats a block that stands on a turning rigid table.
TEST(Restart, RigidBodiesGoOnBitForBit) {
  BlockScene scene;
  scene.jitter = 0.3;
  scene.more =
      "[contact]\nfriction = 0.3\n"
      "[[body]]\nname = \"hammer\"\nmaterial = \"m\"\nrigid = true\nvelocity = [0, -20]\nspin = "
      "30\n"
      "shape = { rectangle = { corner = [0.3, 1.01], size = [0.5, 0.5] } }\n"
      "mesh = { generator = \"structured\", cells = [2, 2] }\n"
      "[[body]]\nname = \"table\"\nmaterial = \"m\"\nrigid = true\n"
      "shape = { rectangle = { corner = [-1, -0.5], size = [3, 0.49] } }\n"
      "mesh = { generator = \"structured\", cells = [6, 2] }\n"
      "[[boundary]]\nwhere = \"table\"\nfixed = [0, 0]\nspin = 0.5\nramp = 0.01\n";
  check_restart<2>(scene, 150, 60);
}

// The hash must be able to tell: one bit of one velocity changes it.
// A fault that slides, and one through an open fracture; before its faces are there, and after.
TEST(Restart, FaultsGoOnBitForBit) {
  for (const char* law : {"law = \"slip_weakening\"\ncoefficient = 0.4\ndynamic = 0.2\n"
                          "weakening_slip = 1e-4\n",
                          "law = \"ageing\"\ncoefficient = 0.3\na = 0.01\nb = 0.02\n"
                          "state_slip = 1e-5\n"}) {
    BlockScene scene{2, "[1, 1]", "[4, 4]"};
    scene.damping = 0.1;
    scene.more = std::string(
                     "[gravity]\nacceleration = [4.905, -8.4957]\n"
                     "[[boundary]]\nwhere = \"b.bottom\"\nfixed = [0, 0]\n"
                     "[[fractures]]\nname = \"f\"\nbody = \"b\"\nkind = \"closed\"\n"
                     "lines = [[[0, 0.5], [1, 0.5]]]\n[fractures.friction]\n") +
                 law +
                 "[[fractures]]\nname = \"o\"\nbody = \"b\"\nkind = \"open\"\n"
                 "lines = [[[0.5, 0.5], [0.5, 1]]]\n";
    for (const int before : {0, 1, 300}) check_restart<2>(scene, before, 80);
  }
}

// A block that slides over a body, in the middle of what its law of friction remembers.
TEST(Restart, FrictionOfContactGoesOnBitForBit) {
  for (const char* law : {"law = \"slip_weakening\"\ndynamic = 0.2\nweakening_slip = 1e-4\n",
                          "law = \"velocity_weakening\"\ndynamic = 0.2\nweakening_speed = 1e-2\n",
                          "law = \"ageing\"\na = 0.01\nb = 0.02\nstate_slip = 1e-5\n"}) {
    BlockScene scene{2, "[1, 1]", "[4, 4]"};
    scene.damping = 0.1;
    scene.more = std::string(
                     "[[body]]\nname = \"table\"\nmaterial = \"m\"\n"
                     "shape = { rectangle = { corner = [-0.5, -0.5], size = [2, 0.5] } }\n"
                     "mesh = { generator = \"structured\", cells = [10, 2] }\n"
                     "[[boundary]]\nwhere = \"table\"\nfixed = [0, 0]\n"
                     "[gravity]\nacceleration = [4.905, -8.4957]\nramp = 0.01\n"
                     "[contact]\nfriction = 0.4\n") +
                 law;
    SceneWorld<2> world(scene.text());
    world.simulation.start();
    world.steps(900);
    const auto rubbed = world.host<ContactRubbed>();
    double most = 0;
    for (Index a = 0; a < world.store().count(Entity::contact_point); ++a)
      most = std::max(most, rubbed(a, 0, 0));
    EXPECT_GT(most, 1e-6) << law;
    EXPECT_LT(most, 1e-3) << law;
    for (const int before : {0, 1, 900}) check_restart<2>(scene, before, 80);
  }
}

TEST(Restart, HashSeesOneBit) {
  SceneWorld<2> world(BlockScene{}.text());
  world.simulation.start();
  const std::string before = state_hash(world.simulation);
  const auto v = world.host<NodeVelocity<2>>();
  v(5, 1) = 5e-324;
  world.put<NodeVelocity<2>>(v);
  EXPECT_NE(state_hash(world.simulation), before);
  v(5, 1) = 0;
  world.put<NodeVelocity<2>>(v);
  EXPECT_EQ(state_hash(world.simulation), before);
}

TEST(Restart, AnotherSceneIsRefused) {
  const TempFolder folder;
  BlockScene scene;
  SceneWorld<2> world(scene.text());
  world.simulation.start();
  save_state(folder / "state.h5", identity_of(scene.text()), world.simulation, {});
  scene.poisson = 0.31;
  SceneWorld<2> other(scene.text());
  EXPECT_THROW(load_state(folder / "state.h5", identity_of(scene.text()), other.simulation), Error);
}

}  // namespace
}  // namespace breccia
