// V-031: shocks of Tillotson's equation in strips that run into a mirror, which is the impact of two
// like plates at twice the velocity; S-24: what becomes vapour flies apart; S-11: flat elements.
#include "harness/simulation.hpp"
#include "harness/temp_folder.hpp"
#include "scene/commands.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace {

using namespace breccia;

struct Solid {
  const char* name;
  double density, b, bulk, bulk2, energy, begin, end;  ///< a = 0.5 for all of them
};
constexpr Solid kAluminium{"aluminium", 2700, 1.63, 75.2e9, 65e9, 5e6, 3e6, 13.9e6};
constexpr Solid kGranite{"granite", 2680, 1.3, 18e9, 18e9, 16e6, 3.5e6, 18e6};
constexpr Solid kIron{"iron", 7800, 1.5, 128e9, 105e9, 9.5e6, 2.4e6, 8.67e6};

/// A strip one cell high between planes of symmetry that runs into one at x = 0.
std::string strip(const Solid& m, double speed, double length, int cells, double duration) {
  const double cell = length / cells;
  std::string text = fmt::format(
      "title = \"strip\"\nreference = \"V-031\"\nexpected = \"a shock\"\n"
      "[run]\ndimension = 2\nduration = {}\n"
      "[[body]]\nname = \"bar\"\nmaterial = \"m\"\nvelocity = [{}, 0]\n"
      "shape = {{ rectangle = {{ corner = [0, 0], size = [{}, {}] }} }}\n"
      "mesh = {{ generator = \"structured\", cells = [{}, 1], pattern = \"right\" }}\n"
      "[material.m]\ndensity = {}\nelastic = {{ young = {}, poisson = 0.3 }}\n"
      "j2 = {{ yield = \"1 MPa\" }}\n"
      "eos = {{ tillotson = {{ a = 0.5, b = {}, bulk = {}, bulk2 = {}, energy = {}, "
      "energy_begin = {}, energy_end = {} }} }}\n",
      duration, -speed, length, cell, cells, m.density, 1.2 * m.bulk, m.b, m.bulk, m.bulk2,
      m.energy, m.begin, m.end);
  for (const char* plane : {"[0, 0], normal = [1, 0]", "[0, 0], normal = [0, 1]"})
    text += fmt::format("[[boundary]]\nplane = {{ point = {} }}\nsymmetry = true\n", plane);
  return text + fmt::format(
                    "[[boundary]]\nplane = {{ point = [0, {}], normal = [0, 1] }}\n"
                    "symmetry = true\n",
                    cell);
}

/// Pressure behind the front to 1 % and its velocity over 10 mm to 0.5 %.
void check_shock(const Solid& m, double u, double velocity) {
  constexpr double kLength = 0.05;
  constexpr int kCells = 200;
  const double pressure = m.density * velocity * u, there = 0.02 / velocity;
  std::string text = strip(m, u, kLength, kCells, 1.3 * there);
  for (const char* sensor : {"a", "b"})
    text += fmt::format("[[sensor]]\nname = \"{}\"\npoint = [{}, {}]\n", sensor,
                        sensor[0] == 'a' ? 0.01 : 0.02, kLength / kCells / 2);
  text += fmt::format(
      "[output]\nframes = 0\nhistory = {}\n"
      "[[check]]\nname = \"pressure\"\nvalue = \"at(-a.sxx, {} s)\"\nreference = \"{} Pa\"\n"
      "tolerance = \"1 %\"\n"
      "[[check]]\nname = \"velocity\"\n"
      "value = \"10 mm / (arrival(abs(b.sxx), {} Pa) - arrival(abs(a.sxx), {} Pa))\"\n"
      "reference = \"{} m/s\"\ntolerance = \"0.5 %\"\n",
      there / 2000, 0.9 * there, pressure, pressure / 2, pressure / 2, velocity);
  const TempFolder folder;
  put_text(folder / "strip.toml", text);
  testing::internal::CaptureStdout();
  const int status = run_scene({folder / "strip.toml", {}, folder / "out", false, false, false});
  const std::string said = testing::internal::GetCapturedStdout();
  EXPECT_EQ(status, 0) << m.name << " " << u << "\n" << said;
}

TEST(Hugoniot, Aluminium) {
  check_shock(kAluminium, 1000, 6753.49);
}

TEST(HugoniotSlow, Table) {
  check_shock(kAluminium, 500, 6016.25);
  check_shock(kAluminium, 2500, 8870.61);
  check_shock(kAluminium, 5000, 12126.5);
  check_shock(kGranite, 500, 3325.36);
  check_shock(kGranite, 1000, 4073.74);
  check_shock(kGranite, 2500, 6374.25);
  check_shock(kGranite, 5000, 10232.3);
  check_shock(kIron, 1000, 5501.17);
  check_shock(kIron, 2500, 7717.24);
}

// S-24: shocked to 494 GPa, far above the energy of vapour, then free to fly apart.
TEST(HugoniotSlow, AluminiumFliesApart) {
  SceneWorld<2> world(strip(kAluminium, 10e3, 5e-3, 25, 1));
  world.simulation.start();
  double least = 1e300, start = 0;
  Ledger last;
  while (world.time() < 10e-6) {
    const double before = world.time();
    const Ledger ledger = world.step_and_book();
    if (start == 0) start = ledger.kinetic;
    least = std::min(least, world.time() - before);
    last = ledger;
    ASSERT_TRUE(std::isfinite(ledger.kinetic));
    ASSERT_LE(ledger.kinetic, 1.01 * start);
  }
  EXPECT_GT(least, 1e-11);  // a thousandth of the first step
  const auto x = world.host<NodePosition<2>>();
  double far = 0;
  for (Index n = 0; n < world.model().nodes(); ++n) far = std::max(far, x(n, 0));
  EXPECT_GT(far, 20 * 5e-3);
  std::printf("%.0f times as long, %.3f of the energy of motion, shortest step %.2g s\n",
              far / 5e-3, last.kinetic / start, least);
}

/// A square of 1 mm of soft copper between a mirror and a plate that comes down at 10 m/s.
std::string squeezed() {
  return "[run]\ndimension = 2\nduration = 1\n"
         "[[body]]\nname = \"b\"\nmaterial = \"m\"\n"
         "shape = { rectangle = { corner = [0, 0], size = [0.001, 0.001] } }\n"
         "mesh = { generator = \"structured\", cells = [2, 2] }\n"
         "[material.m]\ndensity = 8930\nelastic = { young = 117e9, poisson = 0.35 }\n"
         "j2 = { yield = 100e6, hardening = 50e6 }\n"
         "[[boundary]]\nplane = { point = [0, 0], normal = [0, 1] }\nsymmetry = true\n"
         "[[boundary]]\nplane = { point = [0, 0], normal = [1, 0] }\nsymmetry = true\n"
         "[[boundary]]\nplane = { point = [0, 0.001], normal = [0, 1] }\n"
         "velocity = [\"free\", \"-10 m/s\"]\nramp = \"2 us\"\n";
}

// S-11: flattened to a fiftieth at its volume it runs on, and the step follows the thickness.
TEST(Squeezed, FlatElementsShortenTheStep) {
  SceneWorld<2> world(squeezed());
  world.simulation.start();
  const double first = world.simulation.clock().dt;
  while (world.time() < 99e-6) world.step();
  const auto x = world.host<NodePosition<2>>();
  double high = 0, wide = 0;
  for (Index n = 0; n < world.model().nodes(); ++n) {
    ASSERT_TRUE(std::isfinite(x(n, 0)) && std::isfinite(x(n, 1)));
    high = std::max(high, x(n, 1)), wide = std::max(wide, x(n, 0));
  }
  EXPECT_NEAR(high, 0.02e-3, 1e-6);
  EXPECT_GT(wide, 20e-3);
  const double last = world.simulation.clock().dt;
  EXPECT_LT(last, first / 20);
  EXPECT_GT(last, first / 200);
}

}  // namespace
