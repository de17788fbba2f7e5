// V-009: the bound of an element's rate against its exact largest rate, on shapes with known
// ratios and on ten thousand random ones.
#include "core/random.hpp"
#include "loops/stable_step.hpp"
#include "mesh/geometry.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <algorithm>

namespace breccia {
namespace {

/// Plane strain or space, P-wave speed 1, density 1.
struct Elastic {
  double lambda, mu;
  explicit Elastic(double poisson)
      : lambda(poisson / (1 - poisson)), mu(0.5 * (1 - 2 * poisson) / (1 - poisson)) {}
};

/// Largest rate of a free linear simplex with lumped mass, exactly.
template <int D>
double exact_rate(const Simplex<D>& x, const Elastic& elastic) {
  Eigen::Matrix<double, D, D> edges;
  for (int j = 0; j < D; ++j)
    for (int i = 0; i < D; ++i) edges(i, j) = x[j + 1][i] - x[0][i];
  const Eigen::Matrix<double, D, D> rows = edges.inverse();
  Eigen::Matrix<double, D + 1, D> g;
  g.template bottomRows<D>() = rows;
  g.row(0) = -rows.colwise().sum();
  // K / V = lambda g_a g_b^T + mu (g_b g_a^T + g_a.g_b 1); every corner has the mass V / (D + 1).
  Eigen::Matrix<double, D*(D + 1), D*(D + 1)> k;
  for (int a = 0; a <= D; ++a)
    for (int b = 0; b <= D; ++b)
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j)
          k(a * D + i, b * D + j) =
              elastic.lambda * g(a, i) * g(b, j) +
              elastic.mu * (g(a, j) * g(b, i) + (i == j ? g.row(a).dot(g.row(b)) : 0.0));
  const Eigen::SelfAdjointEigenSolver<decltype(k)> solver(k, Eigen::EigenvaluesOnly);
  return std::sqrt((D + 1) * solver.eigenvalues().maxCoeff());
}

/// Rates that the kernel of the stable step gives to elements that share no node.
template <int D>
std::vector<double> bounds(const std::vector<Simplex<D>>& all, const Elastic& elastic) {
  const auto n = all.size();
  Connectivity<D> nodes("test::nodes", n);
  Vectors<D> x("test::x", n * (D + 1));
  Matrices<D> reference("test::reference", n);
  Ranges corners("test::corners", n * (D + 1));
  const Array<Index> list("test::list", n * (D + 1)), material("test::material", n);
  const Array<double> mass("test::mass", n * (D + 1));
  const auto host_nodes = Kokkos::create_mirror_view(nodes);
  const auto host_x = Kokkos::create_mirror_view(x);
  const auto host_reference = Kokkos::create_mirror_view(reference);
  const auto host_corners = Kokkos::create_mirror_view(corners);
  const auto host_list = Kokkos::create_mirror_view(list);
  const auto host_mass = Kokkos::create_mirror_view(mass);
  for (std::size_t e = 0; e < n; ++e) {
    Eigen::Matrix<double, D, D> edges;
    for (std::size_t a = 0; a <= D; ++a) {
      const std::size_t c = e * (D + 1) + a;
      host_nodes(e, a) = host_list(c) = host_corners(c, 0) = static_cast<Index>(c);
      host_corners(c, 1) = static_cast<Index>(c) + 1;
      host_mass(c) = signed_volume<D>(all[e]) / (D + 1);
      for (std::size_t i = 0; i < D; ++i) {
        host_x(c, i) = all[e][a][i];
        if (a > 0)
          edges(static_cast<int>(i), static_cast<int>(a) - 1) = all[e][a][i] - all[e][0][i];
      }
    }
    const Eigen::Matrix<double, D, D> inverse = edges.inverse();
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) host_reference(e, i, j) = inverse(i, j);
  }
  Kokkos::deep_copy(nodes, host_nodes);
  Kokkos::deep_copy(x, host_x);
  Kokkos::deep_copy(reference, host_reference);
  Kokkos::deep_copy(corners, host_corners);
  Kokkos::deep_copy(list, host_list);
  Kokkos::deep_copy(mass, host_mass);
  StableStepIn<D> in{};
  in.elements = static_cast<Index>(n);
  in.nodes = static_cast<Index>(n * (D + 1));
  in.element_nodes = nodes;
  in.x = x;
  in.v = x;
  in.reference = reference;
  in.material = material;
  in.damping = to_device("test::damping", std::vector<double>{0});
  Vectors<2> lame("test::lame", 1);
  const auto host_lame = Kokkos::create_mirror_view(lame);
  host_lame(0, 0) = elastic.lambda;
  host_lame(0, 1) = elastic.mu;
  Kokkos::deep_copy(lame, host_lame);
  in.lame = lame;
  in.corners = corners;
  in.corner_list = list;
  in.mass = mass;
  in.thickness = 1;
  in.factor_bulk = in.factor_springs = 1;
  in.rate = Array<double>("test::rate", n);
  in.renew_rates = true;
  const StableStep step = stable_step(in);
  const auto rate = to_host(in.rate, n);
  std::vector<double> result;
  for (std::size_t e = 0; e < n; ++e)
    result.push_back(std::sqrt(rate[e] * (D + 1) / signed_volume<D>(all[e])));
  EXPECT_DOUBLE_EQ(step.dt, 2 / *std::max_element(result.begin(), result.end()));
  return result;
}

template <int D>
double smallest_height(const Simplex<D>& x) {
  const auto h = heights<D>(x);
  return *std::min_element(h.begin(), h.end());
}

/// The table of V-009: 2 / omega times c over the smallest height.
TEST(StepOfElements, KnownShapes) {
  const double s = std::sqrt(3.0);
  const Simplex<2> equilateral{{{0, 0}, {1, 0}, {0.5, 0.5 * s}}};
  const Simplex<2> right{{{0, 0}, {1, 0}, {0, 1}}};
  const Simplex<3> regular{{{1, 1, 1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, 1}}};
  const Simplex<3> corner{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const double table[5][5] = {{0, .94281, .94281, .86603, .86603},
                              {.25, .81650, .91940, .67082, .83530},
                              {.30, .78881, .90646, .63549, .81820},
                              {.45, .69921, .84503, .53337, .74074},
                              {.4999, .66673, .81656, .50007, .70718}};
  for (const auto& line : table) {
    const Elastic elastic(line[0]);
    const double exact[4] = {
        2 / exact_rate<2>(equilateral, elastic) / smallest_height<2>(equilateral),
        2 / exact_rate<2>(right, elastic) / smallest_height<2>(right),
        2 / exact_rate<3>(regular, elastic) / smallest_height<3>(regular),
        2 / exact_rate<3>(corner, elastic) / smallest_height<3>(corner)};
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(exact[i], line[i + 1], 6e-6) << line[0] << ' ' << i;
  }
}

/// Longest edge over smallest height.
template <int D>
double aspect(const Simplex<D>& x) {
  double longest = 0;
  for (std::size_t a = 0; a <= D; ++a)
    for (std::size_t b = 0; b < a; ++b) longest = std::max(longest, length(minus(x[a], x[b])));
  return longest / smallest_height<D>(x);
}

template <int D>
std::vector<Simplex<D>> random_simplices(std::size_t number) {
  const Random random{17, D};
  std::vector<Simplex<D>> all;
  for (std::uint64_t id = 0; all.size() < number; ++id) {
    Simplex<D> x;
    for (std::size_t a = 0; a <= D; ++a)
      for (std::size_t i = 0; i < D; ++i)
        x[a][i] = random.normal(id, static_cast<std::uint32_t>(a * D + i));
    if (signed_volume<D>(x) < 0) std::swap(x[0], x[1]);
    if (aspect<D>(x) <= 50) all.push_back(x);
  }
  return all;
}

template <int D>
void check_random() {
  const auto all = random_simplices<D>(2500);
  for (const double poisson : {0.0, 0.25, 0.4, 0.4999}) {
    const Elastic elastic(poisson);
    const auto bound = bounds<D>(all, elastic);
    double nearest = 0, farthest = 1;
    for (std::size_t e = 0; e < all.size(); ++e) {
      const double share = exact_rate<D>(all[e], elastic) / bound[e];
      nearest = std::max(nearest, share);
      farthest = std::min(farthest, share);
    }
    std::printf("%dD nu = %.4f: estimated step between %.3f and %.3f of the exact one\n", D,
                poisson, farthest, nearest);
    EXPECT_LE(nearest, 1 + 1e-10);
    EXPECT_GE(farthest, 0.6);
  }
}

TEST(StepOfElements, RandomTrianglesAreBelowTheirLimit) {
  check_random<2>();
}
TEST(StepOfElements, RandomTetrahedraAreBelowTheirLimit) {
  check_random<3>();
}

}  // namespace
}  // namespace breccia
