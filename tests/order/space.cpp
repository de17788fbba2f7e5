// Order in the size of the elements (with steps in proportion): standing waves of linear elasticity
// in boxes of distorted triangles and tetrahedra, compression and shear at once (V-011).
#include "harness/tensors.hpp"
#include "harness/waves.hpp"

#include <gtest/gtest.h>

namespace breccia {
namespace {

/// Far below any nonlinearity and far above round-off.
constexpr double kAmplitude = 1e-7;

struct Errors {
  double displacement, stress;  ///< relative, L2 over the body; displacement over the time, too
};

template <int D>
std::vector<StandingWave<D>> waves(const Material& material) {
  const double pi = 3.14159265358979323846;
  const double cp = std::sqrt(material.p_wave_modulus(false) / material.density);
  const double cs = std::sqrt(material.mu() / material.density);
  StandingWave<D> p, s;
  for (int d = 0; d < D; ++d) p.k[d] = s.k[d] = pi;
  p.a = p.k * (kAmplitude / pi);
  s.a = Vec<D>::zero();
  s.a[0] = kAmplitude;
  s.a[1] = -kAmplitude;
  p.omega = cp * norm(p.k);
  s.omega = cs * norm(s.k);
  return {p, s};
}

template <int D>
double stress_error(SceneWorld<D>& world, const std::vector<StandingWave<D>>& all, double time) {
  const HenckyElastic law = law_of(world);
  const Mesh<D>& mesh = world.model().mesh;
  const auto sigma = element_stresses(world);
  double error = 0, size = 0;
  for (std::size_t e = 0; e < mesh.element.size(); ++e) {
    Vec<D> centre = Vec<D>::zero();
    for (const Index n : mesh.element[e])
      centre += vector_of<D>(mesh.point[static_cast<std::size_t>(n)]) * (1.0 / (D + 1));
    Sym<D> exact = Sym<D>::zero();
    for (const auto& w : all)
      exact += law.kirchhoff(symmetric_part(w.gradient(centre))) * std::cos(w.omega * time);
    const Sym<D> off = sigma[e] + exact * -1.0;
    error += contract(off, off);
    size += contract(exact, exact);
  }
  return std::sqrt(error / size);
}

template <int D>
Errors run(const std::string& cells, const std::string& pattern, const std::string& element) {
  BlockScene scene;
  scene.dimension = D;
  scene.size = D == 2 ? "[1, 1]" : "[1, 1, 1]";
  scene.cells = cells;
  scene.pattern = pattern;
  scene.element = element;
  scene.jitter = 0.2;
  scene.more = sliding_sides(D);
  SceneWorld<D> world(scene.text());
  world.simulation.start();
  const auto all = waves<D>(world.model().materials[0]);
  put_field<NodePosition<D>, D>(world, [&](const Vec<D>& x) {
    Vec<D> y = x;
    for (const auto& w : all) y += w.shape(x);
    return y;
  });
  const auto mass = world.template host<NodeMass>();
  const double end = 2 * 3.14159265358979323846 / all[0].omega;
  double error = 0, size = 0;
  while (world.time() < end) {
    world.step(end);
    const auto u = displacements(world);
    for (std::size_t n = 0; n < u.size(); ++n) {
      Vec<D> exact = Vec<D>::zero();
      const Vec<D> x = vector_of<D>(world.model().mesh.point[n]);
      for (const auto& w : all) exact += w.shape(x) * std::cos(w.omega * world.time());
      error += mass(n) * norm2(u[n] - exact);
      size += mass(n) * norm2(exact);
    }
  }
  return {std::sqrt(error / size), stress_error(world, all, world.time())};
}

template <int D>
void check_order(const std::vector<std::string>& cells, const std::string& pattern,
                 const std::string& element = "", double most = 0.03) {
  std::vector<Errors> errors;
  for (const std::string& c : cells) errors.push_back(run<D>(c, pattern, element));
  for (std::size_t i = 1; i < errors.size(); ++i) {
    const double u = slope(errors[i - 1].displacement, errors[i].displacement, 2);
    const double sigma = slope(errors[i - 1].stress, errors[i].stress, 2);
    std::printf("%s %s %s: displacement %.3e, order %.2f; stress %.3e, order %.2f\n",
                element.c_str(), pattern.c_str(), cells[i].c_str(), errors[i].displacement, u,
                errors[i].stress, sigma);
    if (i + 1 < errors.size()) continue;
    EXPECT_NEAR(u, 2, 0.15) << pattern;
    EXPECT_GE(sigma, 0.9) << pattern;
  }
  EXPECT_LT(errors.back().displacement, most);
}

TEST(OrderSpace, Triangles) {
  for (const char* pattern : {"cross", "right", "union-jack"})
    check_order<2>({"[8, 8]", "[16, 16]", "[32, 32]"}, pattern);
}

TEST(OrderSpace, Tetrahedra) {
  for (const char* pattern : {"kuhn", "five"})
    check_order<3>({"[4, 4, 4]", "[8, 8, 8]", "[16, 16, 16]"}, pattern);
}

// Composites of as many sub-elements.
TEST(OrderSpace, CompositesInThePlane) {
  for (const char* pattern : {"cross", "right"})
    check_order<2>({"[4, 4]", "[8, 8]", "[16, 16]"}, pattern, "tri6c");
}

TEST(OrderSpace, CompositesInSpace) {
  for (const char* element : {"tet10c", "tet10c12"})
    check_order<3>({"[2, 2, 2]", "[4, 4, 4]", "[8, 8, 8]"}, "kuhn", element, 0.08);
}

}  // namespace
}  // namespace breccia
