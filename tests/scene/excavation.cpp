// Excavations: what is taken out leaves with its stress, its mass and its energy, booked to the
// last joule; what stays finds its new balance.
#include "fields/interface_fields.hpp"
#include "harness/scenes.hpp"
#include "modules/excavation/floating_pieces.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace breccia {
namespace {

/// Elements with all of their stress, none of it, and something in between.
template <int D>
std::array<int, 3> census(SceneWorld<D>& world) {
  const auto share = world.template host<ElementShare>();
  std::array<int, 3> count{};
  for (Index e = 0; e < world.model().elements(); ++e)
    ++count[share(e) == 1 ? 0 : share(e) == 0 ? 1 : 2];
  return count;
}

/// Runs beyond time `end`, with even steps; the worst residuals on the way.
template <int D>
Ledger run_to(SceneWorld<D>& world, double end, double& worst_1, double& worst_2) {
  worst_1 = worst_2 = 0;
  Ledger ledger;
  world.simulation.start();
  while (world.time() < end) {
    ledger = world.step_and_book();
    worst_1 = std::max(worst_1, ledger.residual_1());
    if (world.time() < 1e-3) continue;  // too little energy to compare with
    worst_2 = std::max(worst_2, ledger.residual_2());
  }
  return ledger;
}

std::string hole(int dimension, const char* stress) {
  const char* third = dimension == 3 ? ", 0.3" : "";
  return fmt::format(
      "[[initial_stress]]\nstress = {}\n[[boundary]]\nwhere = \"b\"\nheld = true\n"
      "[[excavate]]\nbox = {{ lower = [0.3, 0.3{}], upper = [0.7, 0.7{}] }}\nat = 1e-4\n"
      "release = 4e-3\n",
      stress, third, dimension == 3 ? ", 0.7" : "");
}

/// The worst level 2 residual of a run with this step factor, after a look at the rest.
template <int D>
double mismatch(BlockScene scene, double factor) {
  scene.run += fmt::format("\nstep_factor = {}", factor);
  SceneWorld<D> world(scene.text());
  double worst_1, worst_2;
  const Ledger ledger = run_to(world, 5e-3, worst_1, worst_2);
  EXPECT_LT(worst_1, 1e-12);
  EXPECT_GT(ledger.value("EXCAVATED"), 0.02 * ledger.stored());
  EXPECT_GT(census(world)[1], 0);
  EXPECT_EQ(census(world)[2], 0);
  return worst_2;
}

// Leapfrog and trapezes are exact to second order in the step: about a thousandth of the
// energy in play with a hundred steps in the ramp, and a quarter of that with twice as many.
template <int D>
void check_books(BlockScene scene) {
  scene.jitter = 0.2;
  if (scene.more.empty())
    scene.more = hole(D, D == 2 ? "[-1e6, -2e6, -1e6, 3e5]" : "[-1e6, -2e6, -1e6, 3e5, 0, 1e5]");
  const double coarse = mismatch<D>(scene, 0.9), fine = mismatch<D>(scene, 0.45);
  EXPECT_LT(coarse, 2e-3);
  EXPECT_LT(fine, 0.35 * coarse);
}

TEST(Excavation, BooksTheEnergyOfWhatItTakes) {
  check_books<2>({2, "[1, 1]", "[10, 10]"});
  check_books<3>({3, "[1, 1, 1]", "[5, 5, 5]"});
}

TEST(Excavation, BooksTheEnergyOfComposites) {
  BlockScene scene{2, "[1, 1]", "[10, 10]"};
  scene.element = "tri6c";
  check_books<2>(scene);
}

TEST(Excavation, BooksTheEnergyOfAnisotropicElements) {
  BlockScene scene{2, "[1, 1]", "[10, 10]"};
  scene.elastic = false;
  scene.material =
      "transversely_isotropic = { young = 1e9, young_axis = 5e8, poisson = 0.25, poisson_axis = "
      "0.2, shear_axis = 3e8 }";
  check_books<2>(scene);
}

// No initial stress: hyperelastic elements, whose energies nobody keeps. They are stretched by
// what moves the ends.
TEST(Excavation, BooksTheEnergyOfElementsWithoutMemory) {
  BlockScene scene{2, "[1, 1]", "[10, 10]"};
  scene.more =
      "[[boundary]]\nwhere = \"b.left\"\nfixed = [0, 0]\n"
      "[[boundary]]\nwhere = \"b.right\"\nvelocity = [1, 0]\nramp = 3e-3\n"
      "[[excavate]]\nbox = { lower = [0.3, 0.3], upper = [0.7, 0.7] }\nat = 1e-3\n"
      "release = 3e-3\n";
  check_books<2>(scene);
}

/// A bar along x between two walls, under stress, whose right half is taken out.
BlockScene clamped_bar(const std::string& more) {
  BlockScene scene;
  scene.size = "[2, 0.4]";
  scene.cells = "[20, 4]";
  scene.poisson = 0;
  scene.run = "duration = 10\nrest = { tolerance = 1e-6 }";
  scene.more =
      "[[boundary]]\nwhere = \"b.left\"\nfixed = [0, 0]\n"
      "[[boundary]]\nwhere = \"b.right\"\nfixed = [0, 0]\n"
      "[[boundary]]\nwhere = \"b.top\"\nheld = true\n"
      "[[boundary]]\nwhere = \"b.bottom\"\nheld = true\n"
      "[[excavate]]\nbox = { lower = [1, 0], upper = [2, 0.4] }\nrelease = 0.1\n" +
      more;
  return scene;
}

// The free half gets longer by sigma / E times its length, 1e-3. The energy of the right half leaves
// with it, the left half gives that of its stress along x to it: slowly, so hardly any as motion.
// The stress across stays, held at top and bottom.
TEST(Excavation, LetsABarGo) {
  const BlockScene scene = clamped_bar("[[initial_stress]]\nstress = [-1e6, -1e6, 0, 0]\n");
  SceneWorld<2> world(scene.text());
  world.simulation.start();
  Ledger ledger;
  while (!world.model().rest.reached && world.time() < 10) ledger = world.step_and_book();
  ASSERT_TRUE(world.model().rest.reached);
  EXPECT_GE(world.model().rest.time, 0.1);
  const auto x = world.host<NodePosition<2>>();
  const auto v = world.host<NodeVelocity<2>>();
  const auto mass = world.host<NodeMass>();
  for (Index n = 0; n < world.model().mesh.points(); ++n) {
    const double at = world.model().mesh.point[n][0];
    if (at > 1.01) {
      EXPECT_EQ(mass(n), 0);
      EXPECT_EQ(norm(row<2>(v, n)), 0);
    } else {
      // Second order terms of a strain of 1e-3.
      EXPECT_NEAR(x(n, 0) - at, 1e-3 * at, 2e-6);
    }
  }
  for (const Sym<2>& s : element_stresses(world)) EXPECT_LT(std::abs(s(0, 0)), 10);
  const double half = 0.5 * 1e6 * 1e6 / 1e9 * 0.4;  // per direction and half
  EXPECT_NEAR(ledger.stored_start, 4 * half, 1e-3 * half);
  EXPECT_NEAR(ledger.stored(), half, 3e-3 * half);
  EXPECT_NEAR(ledger.value("EXCAVATED") + ledger.value("RELAX"), 3 * half, 5e-3 * half);
  EXPECT_LT(ledger.value("RELAX"), 0.02 * half);
  EXPECT_LT(ledger.residual_1(), 1e-12);
}

// The foot bears what is left, not half an element more: mass goes with the elements.
TEST(Excavation, TakesTheWeightAlong) {
  BlockScene scene;
  scene.size = "[0.4, 2]";
  scene.cells = "[4, 20]";
  scene.run = "duration = 10\nrest = { tolerance = 1e-7 }";
  scene.more =
      "[gravity]\nacceleration = [0, -10]\n"
      "[[boundary]]\nname = \"foot\"\nwhere = \"b.bottom\"\nfixed = [0, 0]\n"
      "[[sensor]]\nname = \"r\"\nreaction = \"foot\"\n"
      "[[excavate]]\nbox = { lower = [0, 1], upper = [0.4, 2] }\nrelease = 0.02\n";
  SceneWorld<2> world(scene.text());
  world.simulation.start();
  while (!world.model().rest.reached && world.time() < 10) world.step();
  ASSERT_TRUE(world.model().rest.reached);
  world.steps(1);
  const auto force = world.host<NodeReaction<2>>();
  double sum = 0;
  for (Index n = 0; n < world.model().nodes(); ++n) sum += force(n, 1);
  EXPECT_NEAR(sum, 1000 * 10 * 0.4, 1e-4 * 4000);
  const auto mass = world.host<NodeMass>();
  EXPECT_NEAR(std::accumulate(mass.data(), mass.data() + world.model().nodes(), 0.0), 400, 1e-9);
}

TEST(Excavation, TakesCompositesWhole) {
  BlockScene scene{2, "[1, 1]", "[5, 5]"};
  scene.element = "tri6c";
  scene.jitter = 0.3;
  scene.more =
      "[[excavate]]\nbox = { lower = [0.33, 0.2], upper = [0.77, 0.61] }\nrelease = 1e-4\n";
  SceneWorld<2> world(scene.text());
  world.simulation.start();
  while (world.time() < 2e-4) world.step();
  const auto share = world.host<ElementShare>();
  EXPECT_GT(census(world)[1], 0);
  EXPECT_EQ(census(world)[1] % 4, 0);
  for (Index e = 0; e < world.model().elements(); ++e) EXPECT_EQ(share(e), share(e / 4 * 4));
}

TEST(Excavation, IsPaidForWhereItIsOnly) {
  SceneWorld<2> plain(BlockScene{}.text());
  plain.simulation.start();
  plain.steps(3);
  EXPECT_FALSE(plain.store().has<ElementShare>());
  EXPECT_FALSE(plain.store().has<ElementCauchy<2>>());
}

// Below a slot across the whole block hangs nothing: the part above it floats.
TEST(Excavation, FindsPiecesThatNothingHolds) {
  BlockScene scene{2, "[1, 1]", "[10, 10]"};
  SceneWorld<2> world(scene.text());
  const Mesh<2>& mesh = world.model().mesh;
  std::vector<Index> mark(mesh.element.size(), 0);
  std::vector<std::uint8_t> held(mesh.point.size(), 0);
  for (std::size_t n = 0; n < held.size(); ++n) held[n] = mesh.point[n][1] == 0;
  for (std::size_t e = 0; e < mark.size(); ++e) {
    double y = 0;
    for (const Index n : mesh.element[e]) y += mesh.point[n][1] / 3;
    mark[e] = y > 0.4 && y < 0.6;
  }
  const auto pieces = floating_pieces(mesh, world.model().topology, mark, held);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_NEAR(pieces[0].volume, 0.4, 1e-12);
  EXPECT_NEAR(pieces[0].place[0], 0.5, 1e-12);
  EXPECT_NEAR(pieces[0].place[1], 0.8, 1e-12);
  for (std::size_t n = 0; n < held.size(); ++n) held[n] = held[n] || mesh.point[n][1] == 1;
  EXPECT_TRUE(floating_pieces(mesh, world.model().topology, mark, held).empty());
  held.assign(held.size(), 0);  // nothing was held before either
  EXPECT_TRUE(floating_pieces(mesh, world.model().topology, mark, held).empty());
}

/// A block of rock under a stress that tears it at the hole.
BlockScene torn(const std::string& release) {
  BlockScene scene{2, "[1, 1]", "[16, 16]"};
  scene.jitter = 0.25;
  scene.density = 2600;
  scene.young = 60e9;
  scene.poisson = 0.25;
  scene.more = fmt::format(
      "[[initial_stress]]\nstress = [4e6, 0, 1e6, 0]\n"
      "[[boundary]]\nwhere = \"b\"\nheld = true\n"
      "[[excavate]]\nbox = {{ lower = [0.4, 0.4], upper = [0.6, 0.6] }}\nrelease = {}\n"
      "[fracture.m]\ntensile_strength = 8e6\ncohesion = 20e6\nfriction_angle = 0.7\n"
      "energy_tension = 20\nenergy_shear = 200\n",
      release);
  return scene;
}

void check_torn(const std::string& more) {
  BlockScene scene = torn("2e-4");
  scene.more += more;
  SceneWorld<2> world(scene.text());
  double worst_1, worst_2;
  run_to(world, 1.2e-3, worst_1, worst_2);
  EXPECT_LT(worst_1, 1e-11);
  EXPECT_GT(world.simulation.counts().released, 3);
  const auto share = world.host<ElementShare>();
  const auto status = world.host<FaceStatus>();
  const auto nodes = world.host<ElementNodes<2>>();
  const auto mass = world.host<NodeMass>();
  int cut = 0;
  for (std::size_t f = 0; f < world.model().topology.shared.size(); ++f) {
    const SharedFace& face = world.model().topology.shared[f];
    const double left = share(face.left), right = share(face.right);
    if (left != 0 && right != 0) continue;
    EXPECT_EQ(status(f), left == right ? face_status::tied : face_status::cut);
    cut += left != right;
  }
  EXPECT_GT(cut, 8);
  // What is gone shares no node with what stays, whose nodes weigh what their elements weigh.
  for (Index e = 0; e < world.model().elements(); ++e)
    for (int a = 0; a < 3; ++a) EXPECT_EQ(mass(nodes(e, a)) > 0, share(e) > 0);
}

TEST(Excavation, LetsTheRimTear) {
  check_torn("");
}
TEST(Excavation, LetsTheRimTearWithContact) {
  check_torn("[contact]\nfriction = 0.3\n");
}

// A slot between two blocks that close: its walls press, though nothing of them was free before.
TEST(Excavation, MakesSurfaceThatTouches) {
  BlockScene scene{2, "[1, 1]", "[10, 10]"};
  scene.more =
      "[contact]\nfriction = 0\n"
      "[[boundary]]\nwhere = \"b.bottom\"\nfixed = [0, 0]\n"
      "[[boundary]]\nwhere = \"b.top\"\nvelocity = [0, -20]\n"
      "[[excavate]]\nbox = { lower = [0, 0.4], upper = [1, 0.5] }\nrelease = 1e-4\n";
  SceneWorld<2> world(scene.text());
  world.simulation.start();
  double worst = 0;
  while (world.time() < 8e-3) worst = std::max(worst, world.step_and_book().residual_1());
  EXPECT_LT(worst, 1e-11);
  // 0.16 m of way and 0.1 m of slot: what is left is pressed into the blocks.
  const auto x = world.host<NodePosition<2>>();
  double lower = -1, upper = 2;
  for (Index n = 0; n < world.model().mesh.points(); ++n) {
    const double y = world.model().mesh.point[n][1];
    if (std::abs(y - 0.4) < 1e-9) lower = std::max(lower, x(n, 1));
    if (std::abs(y - 0.5) < 1e-9) upper = std::min(upper, x(n, 1));
  }
  EXPECT_LT(lower, 0.4 - 0.005);
  EXPECT_GT(upper, lower - 0.01);
}

}  // namespace
}  // namespace breccia
