// V-020: a column, 1 m by 1 m by 6 m, held at its foot, swings and twists as far as rubber goes
// (J. Bonet, A. J. Gil, C. H. Lee, M. Aguirre, R. Ortigosa 2015).
#include "harness/waves.hpp"
#include "step/ledger.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace breccia {
namespace {

constexpr double kPi = std::numbers::pi;

struct Column {
  Column(const std::string& element, int cells, double poisson, const VectorField<3>& velocity)
      : world(text(element, cells, poisson)) {
    world.simulation.start();
    put_field<NodeVelocity<3>, 3>(world, velocity);
    for (Index n = 0; n < world.model().mesh.points(); ++n) {
      const auto& x = world.model().mesh.point[static_cast<std::size_t>(n)];
      if (x[2] > 6 - 1e-9 && std::abs(std::abs(x[0]) - 0.5) < 1e-9 &&
          std::abs(std::abs(x[1]) - 0.5) < 1e-9)
        corner.push_back(n);
    }
  }

  static std::string text(const std::string& element, int cells, double poisson) {
    BlockScene scene;
    scene.dimension = 3;
    scene.element = element;
    scene.pattern = "five";
    scene.density = 1100;
    scene.young = 17e6;
    scene.poisson = poisson;
    scene.more = "[[boundary]]\nwhere = \"b.front\"\nfixed = [0, 0, 0]\n";
    std::string made = scene.text();
    const auto put = [&](const std::string& old, const std::string& by) {
      made.replace(made.find(old), old.size(), by);
    };
    put("corner = [0, 0, 0], size = [1, 1]", "corner = [-0.5, -0.5, 0], size = [1, 1, 6]");
    put("cells = [4, 4]", fmt::format("cells = [{0}, {0}, {1}]", cells, 6 * cells));
    return made;
  }

  /// Steps to `end`; largest error of the energy over the energy it began with.
  void run(double end) {
    const double start = kinetic();
    double next = 0;
    while (world.time() < end) {
      if (world.time() < next) {
        world.step(end);
        continue;
      }
      next += end / 200;
      const Ledger ledger = world.step_and_book(end);
      worst = std::max(worst, std::abs(ledger.kinetic + ledger.stored() - start) / start);
      sway.push_back(centre());
    }
    EXPECT_FALSE(world.model().stop.raised) << world.model().stop.cause;
  }

  double kinetic() {
    const auto v = world.host<NodeVelocity<3>>();
    const auto mass = world.host<NodeMass>();
    double sum = 0;
    for (Index n = 0; n < world.model().nodes(); ++n) sum += 0.5 * mass(n) * norm2(row<3>(v, n));
    return sum;
  }

  Vec<3> place(Index n) { return row<3>(world.host<NodePosition<3>>(), n); }

  /// Displacement of the middle of the top along x, m.
  double centre() {
    double sum = 0;
    for (const Index n : corner) sum += place(n)[0] / 4;
    return sum;
  }

  SceneWorld<3> world;
  std::vector<Index> corner;
  std::vector<double> sway;
  double worst = 0;
};

/// Largest difference of two histories over the largest value.
double apart(const std::vector<double>& a, const std::vector<double>& b) {
  double worst = 0, most = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    worst = std::max(worst, std::abs(a[i] - b[i]));
    most = std::max(most, std::abs(b[i]));
  }
  return worst / most;
}

std::vector<double> swing(const std::string& element, int cells) {
  Column column(element, cells, 0.3, [](const Vec<3>& x) { return Vec<3>{{10 * x[2] / 6, 0, 0}}; });
  column.run(1.5);
  const auto most = std::max_element(column.sway.begin(), column.sway.end());
  std::printf("%s, %d cells: sways %.3f m at %.3f s; energy to %.2e\n", element.c_str(), cells,
              *most, 1.5 / 200 * static_cast<double>(most - column.sway.begin()), column.worst);
  EXPECT_LT(column.worst, 0.01) << element;
  return column.sway;
}

// Composites of four cells have parts of the size of the tetrahedra of eight: the two swing together.
// From one mesh to one of half the size the first swing grows by 3.5 %.
TEST(ColumnSlow, Swings) {
  const auto coarse = swing("tet10c", 2), fine = swing("tet10c", 4), simple = swing("tet4", 8);
  std::printf("apart: composites and simple %.4f, halved size %.4f\n", apart(simple, fine),
              apart(coarse, fine));
  EXPECT_LT(apart(simple, fine), 0.03);
  const auto highest = [](const std::vector<double>& v) {
    return *std::max_element(v.begin(), v.end());
  };
  EXPECT_NEAR(highest(coarse), highest(fine), 0.04 * highest(fine));
}

/// How far the corners of the top are apart after a turn to and fro, m.
double twist(const std::string& element, int cells) {
  Column column(element, cells, 0.495, [](const Vec<3>& x) {
    const double rate = 105 * std::sin(kPi * x[2] / 12);
    return Vec<3>{{-rate * x[1], rate * x[0], 0}};
  });
  column.run(0.1);
  EXPECT_EQ(column.corner.size(), 4U);
  double worst = 0;
  const Vec<3> a = column.place(column.corner[0]);
  for (const Index n : column.corner) {
    const Vec<3> b = column.place(n);
    worst = std::max(
        {worst, std::abs(std::hypot(a[0], a[1]) - std::hypot(b[0], b[1])), std::abs(a[2] - b[2])});
  }
  std::printf("%s, %d cells: corners apart %.2e m, radius %.4f, height %.4f; energy to %.2e\n",
              element.c_str(), cells, worst, std::hypot(a[0], a[1]), a[2], column.worst);
  EXPECT_LT(column.worst, 0.01) << element;
  return worst;
}

// The grid and its tetrahedra are the same after a quarter of a turn. Composites of twelve keep that;
// those of eight cut an octahedron along one of its diagonals, and four corners see it from four
// sides: they come apart by as much as the sides of their elements would let them.
TEST(ColumnSlow, Twists) {
  EXPECT_LT(twist("tet4", 4), 1e-6);
  EXPECT_LT(twist("tet10c12", 2), 1e-6);
  EXPECT_LT(twist("tet10c", 2), 0.02);
}

}  // namespace
}  // namespace breccia
