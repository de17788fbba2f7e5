// V-008: speed of short waves. In a strip the mesh is a chain of springs, whose motion in discrete
// time is known in closed form; in the plane and in space the error has a bound and an order.
#include "harness/waves.hpp"

#include <gtest/gtest.h>

namespace breccia {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// c_num / c of linear elements with lumped mass and central differences, n elements to the wave,
/// r = c dt / h.
double chain_speed(int n, double r) {
  const double kh = 2 * kPi / n;
  return 2 * std::asin(r * std::sin(0.5 * kh)) / (r * kh);
}

TEST(OrderDispersion, ClosedFormOfTheChain) {
  EXPECT_NEAR(chain_speed(5, 0.5), 0.949508, 5e-7);
  EXPECT_NEAR(chain_speed(5, 0.9), 0.985752, 5e-7);
  EXPECT_NEAR(chain_speed(10, 0.5), 0.987588, 5e-7);
  EXPECT_NEAR(chain_speed(20, 0.9), 0.999213, 5e-7);
  EXPECT_NEAR(chain_speed(40, 0.9), 0.999804, 5e-7);
}

/// One wave in a strip of n cells, one cell across, that moves along x only; nu = 0. Meshes whose
/// cells are all cut alike have the same springs and masses in every column.
template <int D>
void check_strip(int n, double r) {
  const double h = 1.0 / n, amplitude = 1e-7 * h;
  BlockScene scene;
  scene.dimension = D;
  scene.size = fmt::format("[1, {0}{1}]", h, D == 3 ? fmt::format(", {}", h) : "");
  scene.cells = fmt::format("[{}, 1{}]", n, D == 3 ? ", 1" : "");
  scene.pattern = D == 2 ? "right" : "kuhn";
  scene.poisson = 0;
  scene.more =
      fmt::format("[[boundary]]\nwhere = \"b\"\nfixed = [\"free\", 0{}]\n", D == 3 ? ", 0" : "");
  for (const char* end : {"left", "right"})
    scene.more += fmt::format("[[boundary]]\nwhere = \"b.{}\"\nfixed = [0, \"free\"{}]\n", end,
                              D == 3 ? ", \"free\"" : "");
  SceneWorld<D> world(scene.text());
  world.simulation.start();
  const double c = std::sqrt(scene.young / scene.density), k = 2 * kPi;
  put_field<NodePosition<D>, D>(world, [&](Vec<D> x) {
    x[0] += amplitude * std::sin(k * x[0]);
    return x;
  });
  Clock clock;
  clock.dt = r * h / c;
  const double omega = chain_speed(n, r) * c * k;
  double worst = 0;
  while (clock.time < 2 * 2 * kPi / omega) {  // two periods
    run_step(world, clock);
    const auto u = displacements(world);
    for (std::size_t i = 0; i < u.size(); ++i) {
      const double x = world.model().mesh.point[i][0];
      const double exact = amplitude * std::sin(k * x) * std::cos(omega * clock.time);
      worst = std::max(worst, std::abs(u[i][0] - exact));
    }
  }
  // 1e-5 of the amplitude after 4 pi of phase: the speed is that of the formula to 1e-6.
  EXPECT_LT(worst, 1e-5 * amplitude) << n << " elements to the wave, r = " << r;
}

TEST(OrderDispersion, StripsFollowTheClosedForm) {
  for (const int n : {5, 10, 20, 40})
    for (const double r : {0.5, 0.9}) {
      check_strip<2>(n, r);
      check_strip<3>(n, r);
    }
}

/// Speed of a standing wave over the exact one, from the ninth quarter of its period.
template <int D>
double relative_speed(const std::array<int, D>& mode, bool compression, int cells,
                      const std::string& pattern) {
  BlockScene scene;
  scene.dimension = D;
  scene.size = D == 2 ? "[1, 1]" : "[1, 1, 1]";
  scene.cells = D == 2 ? fmt::format("[{0}, {0}]", cells) : fmt::format("[{0}, {0}, {0}]", cells);
  scene.pattern = pattern;
  scene.more = sliding_sides(D);
  SceneWorld<D> world(scene.text());
  world.simulation.start();
  const Material& material = world.model().materials[0];
  StandingWave<D> wave;
  for (int d = 0; d < D; ++d) wave.k[d] = kPi * mode[static_cast<std::size_t>(d)];
  wave.a = wave.k;
  if (!compression) {
    wave.a = Vec<D>::zero();
    wave.a[0] = wave.k[1];
    wave.a[1] = -wave.k[0];
  }
  wave.a *= 1e-7 / norm(wave.a);
  const double modulus = compression ? material.p_wave_modulus(false) : material.mu();
  wave.omega = std::sqrt(modulus / material.density) * norm(wave.k);
  put_field<NodePosition<D>, D>(world, [&](const Vec<D>& x) { return x + wave.shape(x); });
  const auto mass = world.template host<NodeMass>();
  double before = 1, time_before = 0;
  for (int crossings = 0;;) {
    world.step();
    double now = 0;
    const auto u = displacements(world);
    for (std::size_t n = 0; n < u.size(); ++n)
      now += mass(n) * dot(u[n], wave.shape(vector_of<D>(world.model().mesh.point[n])));
    if ((now < 0) != (before < 0) && time_before > 0 && ++crossings == 5) {
      const double t = time_before + (world.time() - time_before) * before / (before - now);
      return 4.5 * kPi / (wave.omega * t);
    }
    before = now;
    time_before = world.time();
  }
}

/// Mean length of an element's edges in a cell of unit size.
double mean_edge(const std::string& pattern) {
  const double d = std::sqrt(2.0), s = std::sqrt(3.0);
  if (pattern == "cross") return (1 + d) / 3;           // 1, 1/sqrt 2 twice
  if (pattern == "kuhn") return (3 + 2 * d + s) / 6;    // an edge, a face and a body diagonal
  if (pattern == "five") return (2 * (1 + d) + d) / 5;  // four corners and the middle
  return (2 + d) / 3;                                   // half a square
}

/// Cells that make ten elements or a few more to the wave along the direction of a mode.
template <int D>
int ten_to_the_wave(const std::array<int, D>& mode, const std::string& pattern) {
  double sum = 0;
  for (const int m : mode) sum += m * m;
  return static_cast<int>(std::ceil(5 * std::sqrt(sum) * mean_edge(pattern)));
}

template <int D>
void check_direction(const std::array<int, D>& mode, bool compression, const std::string& pattern) {
  const int cells = ten_to_the_wave<D>(mode, pattern);
  const double coarse = relative_speed<D>(mode, compression, cells, pattern);
  const double fine = relative_speed<D>(mode, compression, 2 * cells, pattern);
  const double order = slope(std::abs(1 - coarse), std::abs(1 - fine), 2);
  std::string name;
  for (const int m : mode) name += std::to_string(m);
  std::printf("%s (%s) %s: %.4f %.4f order %.2f\n", pattern.c_str(), name.c_str(),
              compression ? "P" : "S", coarse, fine, order);
  EXPECT_GE(coarse, 0.985) << pattern << name;
  // Where all diagonals are alike, shear waves across them are stiffened and run ahead.
  EXPECT_LE(coarse, 1.02) << pattern << name;
  EXPECT_GT(order, 1.8) << pattern << name;
}

TEST(OrderDispersion, AllDirectionsOfThePlane) {
  using Mode = std::array<int, 2>;
  for (const char* pattern : {"cross", "union-jack", "right"}) {
    for (const Mode mode : {Mode{4, 0}, {4, 1}, {4, 2}, {3, 3}, {2, 4}})
      check_direction<2>(mode, true, pattern);
    for (const Mode mode : {Mode{4, 1}, {4, 2}, {3, 3}}) check_direction<2>(mode, false, pattern);
  }
}

TEST(OrderDispersion, AxisOfSpace) {
  check_direction<3>({1, 0, 0}, true, "kuhn");
}

TEST(OrderDispersionSlow, DirectionsOfSpace) {
  using Mode = std::array<int, 3>;
  for (const char* pattern : {"kuhn", "five"}) {
    for (const Mode mode : {Mode{1, 0, 0}, {1, 1, 0}, {1, 1, 1}})
      check_direction<3>(mode, true, pattern);
    for (const Mode mode : {Mode{1, 1, 0}, {1, 1, 1}}) check_direction<3>(mode, false, pattern);
  }
}

}  // namespace
}  // namespace breccia
