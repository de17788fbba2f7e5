// Every kind of element with every kind of material against what it must be the same as: single
// elements, the law at a point, the gradient of the energy.
#include "harness/scenes.hpp"
#include "harness/tensors.hpp"

#include <gtest/gtest.h>

#include <random>

namespace breccia {
namespace {

struct Kind {
  int dimension;
  const char* element;
};
constexpr Kind kKinds[] = {{2, "tri3"}, {2, "tri6c"}, {3, "tet4"}, {3, "tet10c"}, {3, "tet10c12"}};

/// The same isotropic elasticity, written in all ways that lead to loops of their own.
struct Way {
  const char* name;
  bool elastic;
  const char *material, *more;
};
constexpr Way kWays[] = {
    {"hyperelastic", true, "", ""},
    {"law that never yields", true, "j2 = { yield = 1e15 }", ""},
    {"stiffness", false,
     "orthotropic = { young = [1e9, 1e9, 1e9], poisson = [0.25, 0.25, 0.25], "
     "shear = [0.4e9, 0.4e9, 0.4e9] }",
     ""},
};

BlockScene block(const Kind& kind, const Way& way) {
  BlockScene scene;
  scene.dimension = kind.dimension;
  scene.element = kind.element;
  if (kind.dimension == 3) {
    scene.size = "[1, 1, 1]";
    scene.cells = "[2, 2, 2]";
  }
  scene.jitter = 0.2;
  scene.poisson = 0.25;
  scene.elastic = way.elastic;
  scene.material = way.material;
  scene.more = way.more;
  return scene;
}

template <int D>
Mat<D> stretch() {
  Mat<D> u = Mat<D>::identity();
  const double normal[3] = {1.2, 0.85, 1.1};
  for (int i = 0; i < D; ++i) u(i, i) = normal[i];
  u(0, 1) = 0.15;
  return u;
}

/// V-001 to V-003: affine maps, with any turn on top.
template <int D>
void expect_affine(const BlockScene& scene) {
  SceneWorld<D> world(scene.text());
  world.simulation.start();
  const HenckyElastic law{1e9 * 0.25 / (1.25 * 0.5), 0.4e9};
  for (const double angle : {0.0, 1.0, 2.5}) {
    Mat<D> turn;
    if constexpr (D == 2)
      turn = rotation_matrix(angle);
    else
      turn = rotation_matrix(Vec<3>{{1, 2, 3}}, angle);
    const Mat<D> f = turn * stretch<D>();
    put_field<NodePosition<D>, D>(world, [&f](const Vec<D>& x) { return f * x; });
    evaluate_forces(world, Clock{});
    for (const Sym<D>& sigma : element_stresses(world))
      ASSERT_LT(distance(sigma, stress_of(law, f)), 1e-12 * 1e9);
    const std::vector<bool> inner = inner_nodes(world.model());
    const auto force = nodal_forces<ElementForce<D>>(world);
    double most = 0;
    for (const Vec<D>& v : force) most = std::max(most, norm(v));
    for (std::size_t n = 0; n < force.size(); ++n) {
      if (inner[n]) {
        ASSERT_LT(norm(force[n]), 1e-12 * most);
      }
    }
  }
}

TEST(Responses, AffineMapsAreExact) {
  for (const Kind& kind : kKinds)
    for (const Way& way : kWays) {
      SCOPED_TRACE(std::string(kind.element) + ", " + way.name);
      if (kind.dimension == 2)
        expect_affine<2>(block(kind, way));
      else
        expect_affine<3>(block(kind, way));
    }
}

template <int D>
double stored_energy(SceneWorld<D>& world) {
  evaluate_forces(world, Clock{});
  Ledger ledger;
  world.simulation.book_before(ledger);
  return ledger.value("IE_elastic");
}

/// Forces of a deformed body against the difference quotient of its stored energy.
template <int D>
void expect_gradient(const BlockScene& scene) {
  SceneWorld<D> world(scene.text());
  world.simulation.start();
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto nodes = world.model().mesh.point.size();
  std::vector<Vec<D>> place(nodes), way(nodes);
  for (std::size_t n = 0; n < nodes; ++n)
    for (int d = 0; d < D; ++d) {
      place[n][d] =
          world.model().mesh.point[n][static_cast<std::size_t>(d)] + 0.02 * number(generator);
      way[n][d] = number(generator);
    }
  const auto put = [&](double at) {
    const auto x = world.template host<NodePosition<D>>();
    for (std::size_t n = 0; n < nodes; ++n)
      for (int d = 0; d < D; ++d) x(n, d) = place[n][d] + at * way[n][d];
    world.template put<NodePosition<D>>(x);
  };
  const double h = 1e-4;
  double quotient = 0;
  for (const auto& [at, weight] : {std::pair{-2, 1.0}, {-1, -8.0}, {1, 8.0}, {2, -1.0}}) {
    put(at * h);
    quotient += weight * stored_energy(world) / (12 * h);
  }
  put(0);
  evaluate_forces(world, Clock{});
  const auto force = nodal_forces<ElementForce<D>>(world);
  double power = 0, scale = 0;
  for (std::size_t n = 0; n < nodes; ++n) {
    power -= dot(force[n], way[n]);
    scale += norm(force[n]) * norm(way[n]);
  }
  // The quotient is of fourth order in h over the size of an element, a few 1e-2 squared.
  EXPECT_NEAR(power, quotient, 1e-7 * scale);
}

TEST(Responses, ForcesAreTheGradientOfTheEnergy) {
  const Way layered{"layered", false,
                    "transversely_isotropic = { young = 2e9, young_axis = 1e9, poisson = 0.2, "
                    "poisson_axis = 0.1, shear_axis = 0.3e9 }",
                    ""};
  for (const Kind& kind : kKinds) {
    const std::string turned = kind.dimension == 2
                                   ? "[[axes]]\nangle = \"35 deg\"\n"
                                   : "[[axes]]\nnormal = [1, 2, 3]\nfirst = [1, 0, 1]\n";
    const Way tilted{"tilted", false, layered.material, turned.c_str()};
    for (const Way& way : {kWays[0], kWays[1], layered, tilted}) {
      SCOPED_TRACE(std::string(kind.element) + ", " + way.name);
      if (kind.dimension == 2)
        expect_gradient<2>(block(kind, way));
      else
        expect_gradient<3>(block(kind, way));
    }
  }
}

/// A body under initial stress that nothing has moved.
template <int D>
void expect_initial_stress(const Kind& kind, const Way& way) {
  BlockScene scene = block(kind, way);
  const std::string axes =
      D == 2 ? "[[axes]]\nangle = \"35 deg\"\n" : "[[axes]]\nnormal = [1, 2, 3]\n";
  scene.more = (way.elastic ? "" : axes) + "[[initial_stress]]\nstress = " +
               (D == 2 ? "[-3e6, -5e6, -4e6, 1e6]" : "[-3e6, -5e6, -4e6, 1e6, 5e5, -2e5]");
  SceneWorld<D> world(scene.text());
  world.simulation.start();
  evaluate_forces(world, Clock{});
  const double given[6] = {-3e6, -5e6, -4e6, 5e5, -2e5, 1e6};
  for (const Sym<D>& sigma : element_stresses(world))
    for (int i = 0; i < Sym<D>::size; ++i)
      ASSERT_NEAR(sigma.s[i], given[D == 2 && i == 2 ? 5 : i], 1e-12 * 1e9);
}

TEST(Responses, InitialStressIsThereAtTheStart) {
  for (const Kind& kind : kKinds)
    for (const Way& way : kWays) {
      SCOPED_TRACE(std::string(kind.element) + ", " + way.name);
      if (kind.dimension == 2)
        expect_initial_stress<2>(kind, way);
      else
        expect_initial_stress<3>(kind, way);
    }
}

/// Pure shear into flow, turned on the way: principal strains e and -e, no change of volume, so
/// that von Mises' stress is the yield stress of what has flown.
template <int D>
void expect_flow(const Kind& kind) {
  BlockScene scene = block(kind, kWays[0]);
  scene.material = "j2 = { yield = 1e6, hardening = 5e6 }";
  SceneWorld<D> world(scene.text());
  world.simulation.start();
  const double shear = 0.4e9;
  for (int step = 1; step <= 40; ++step) {
    const double e = 0.01 * step;
    Mat<D> u = Mat<D>::identity();
    u(0, 0) = std::exp(e);
    u(1, 1) = std::exp(-e);
    Mat<D> turn;
    if constexpr (D == 2)
      turn = rotation_matrix(0.1 * step);
    else
      turn = rotation_matrix(Vec<3>{{1, 2, 3}}, 0.1 * step);
    const Mat<D> f = turn * u;
    put_field<NodePosition<D>, D>(world, [&f](const Vec<D>& x) { return f * x; });
    evaluate_forces(world, Clock{});
    // Along the path s = y + H ep with s = 2 sqrt(3) G (e - e_p) and ep = 2 e_p / sqrt(3).
    const double flown = (2 * std::sqrt(3.0) * shear * e - 1e6) / (3 * shear + 5e6);
    const double mises = 1e6 + 5e6 * flown;
    Sym<D> expected = Sym<D>::zero();
    expected.s[0] = mises / std::sqrt(3.0);
    expected.s[1] = -expected.s[0];
    expected = congruent(turn, expected);
    for (const Sym<D>& sigma : element_stresses(world))
      ASSERT_LT(distance(sigma, expected), 1e-11 * 1e9) << step;
  }
}

TEST(Responses, FlowFollowsTheLawWhateverTurns) {
  for (const Kind& kind : kKinds) {
    SCOPED_TRACE(kind.element);
    if (kind.dimension == 2)
      expect_flow<2>(kind);
    else
      expect_flow<3>(kind);
  }
}

}  // namespace
}  // namespace breccia
