// Single precision against double: the same body in the same place, force by force. What may differ
// is a share of round-off (2^-24) of the displacement gradient, not of one: a body that is hardly
// deformed and hardly turned has forces that are hardly wrong, wherever it is.
#include "harness/scenes.hpp"
#include "harness/tensors.hpp"

#include <gtest/gtest.h>

#include <random>

namespace breccia {
namespace {

/// Round-off of a float; a force is made of some dozens of such operations one after the other, on
/// elements whose edges differ by a factor of some two.
constexpr double kRoundOff = 1.0 / (1 << 24), kOperations = 32;

struct Kind {
  int dimension;
  const char* element;
};
constexpr Kind kKinds[] = {{2, "tri3"}, {2, "tri6c"}, {3, "tet4"}, {3, "tet10c"}, {3, "tet10c12"}};

struct Way {
  const char* name;
  const char* plane;
  bool elastic;
  const char* material;
  double damping;
  const char* more;
};
constexpr Way kWays[] = {
    {"isotropic", "strain", true, "", 0, ""},
    {"plane stress", "stress", true, "", 0, ""},
    {"damped", "strain", true, "", 0.5, ""},
    {"bulk viscosity", "strain", true, "bulk_viscosity = [1.5, 0.06]", 0, ""},
    {"layers", "strain", false,
     "transversely_isotropic = { young = 1e9, young_axis = 0.5e9, poisson = 0.25, "
     "poisson_axis = 0.2, shear_axis = 0.3e9 }",
     0, "axes"},
    {"yields, so in double", "strain", true, "j2 = { yield = 1e15 }", 0, ""},
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
  scene.plane = way.plane;
  scene.poisson = 0.25;
  scene.elastic = way.elastic;
  scene.material = way.material;
  scene.damping = way.damping;
  if (std::string(way.more) == "axes")
    scene.more = kind.dimension == 2 ? "[[axes]]\nangle = 0.5" : "[[axes]]\nnormal = [1, 2, 3]";
  return scene;
}

template <int D>
Mat<D> turn(double angle) {
  if constexpr (D == 2)
    return rotation_matrix(angle);
  else
    return rotation_matrix(Vec<3>{{1, 2, 3}}, angle);
}

/// Nodes turned, stretched by about `strain`, moved and shaken; velocities in proportion.
template <int D>
void place(SceneWorld<D>& world, double strain, double angle, double away) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> number(-1, 1);
  const Mat<D> q = turn<D>(angle);
  const auto x = world.template host<NodePosition<D>>();
  const auto v = world.template host<NodeVelocity<D>>();
  for (Index n = 0; n < world.model().mesh.points(); ++n) {
    const Vec<D> start = vector_of<D>(world.model().mesh.point[static_cast<std::size_t>(n)]);
    Vec<D> shaken = start;
    for (int d = 0; d < D; ++d) shaken[d] += strain * (0.1 * number(generator) + 0.5 * start[d]);
    const Vec<D> at = q * shaken;
    for (int d = 0; d < D; ++d) {
      x(n, d) = at[d] + away;
      v(n, d) = strain * 1e3 * number(generator) - 100 * strain * start[d];
    }
  }
  world.template put<NodePosition<D>>(x);
  world.template put<NodeVelocity<D>>(v);
}

struct Difference {
  double largest = 0, force = 0;  ///< N
};

template <int D>
Difference difference(const BlockScene& scene, double strain, double angle, double away) {
  SceneWorld<D> exact(scene.text()), single(scene.text(), {"run.precision=\"mixed\""});
  for (SceneWorld<D>* world : {&exact, &single}) {
    world->simulation.start();
    place(*world, strain, angle, away);
    evaluate_forces(*world, Clock{1, 0, 1e-5, 1e-5});
  }
  const auto a = exact.template host<ElementForce<D>>();
  const auto b = single.template host<ElementForceSingle<D>>();
  Difference result;
  for (Index e = 0; e < exact.model().elements(); ++e)
    for (int c = 0; c <= D; ++c)
      for (int d = 0; d < D; ++d) {
        result.largest = std::max(result.largest, std::abs(a(e, c, d) - b(e, c, d)));
        result.force = std::max(result.force, std::abs(a(e, c, d)));
      }
  return result;
}

Difference difference(const Kind& kind, const Way& way, double strain, double angle, double away) {
  const BlockScene scene = block(kind, way);
  return kind.dimension == 2 ? difference<2>(scene, strain, angle, away)
                             : difference<3>(scene, strain, angle, away);
}

template <class Check>
void for_all(const Check& check) {
  for (const Kind& kind : kKinds)
    for (const Way& way : kWays) {
      if (kind.dimension == 3 && std::string(way.plane) == "stress") continue;
      SCOPED_TRACE(std::string(kind.element) + ", " + way.name);
      check(kind, way);
    }
}

TEST(Precision, ErrorsOfForcesAreAShareOfTheForces) {
  for_all([](const Kind& kind, const Way& way) {
    for (const double strain : {1e-6, 1e-3, 0.1}) {
      const Difference d = difference(kind, way, strain, 0, 0);
      EXPECT_GT(d.force, 1e-3 * strain * 1e9);
      EXPECT_LT(d.largest, kOperations * kRoundOff * d.force) << strain << ' ' << d.force;
    }
  });
}

// V-146: a hundred thousand sizes of the body away. Positions are doubles: 2^-53 of that, over edges
// of some 0.1 m and strains of 1e-4.
TEST(Precision, FarFromTheOriginToo) {
  for_all([](const Kind& kind, const Way& way) {
    const Difference near = difference(kind, way, 1e-4, 0, 1000);
    EXPECT_LT(near.largest, (kOperations * kRoundOff + 1e-8) * near.force);
    const Difference far = difference(kind, way, 1e-4, 0, 1e5);
    EXPECT_LT(far.largest, 1e-5 * far.force);
  });
}

/// Net force of each element, and of all.
template <int D>
void expect_no_push(const BlockScene& scene) {
  SceneWorld<D> world(scene.text(), {"run.precision=\"mixed\""});
  world.simulation.start();
  place(world, 0.01, 0.3, 0);
  evaluate_forces(world, Clock{1, 0, 1e-5, 1e-5});
  const auto f = world.template host<ElementForceSingle<D>>();
  double most = 0;
  for (Index e = 0; e < world.model().elements(); ++e)
    for (int d = 0; d < D; ++d) {
      double net = 0;
      for (int a = 0; a <= D; ++a) {
        net += f(e, a, d);
        most = std::max(most, std::abs(double(f(e, a, d))));
      }
      ASSERT_EQ(net, 0) << e;
    }
  EXPECT_GT(most, 0);
}

// So that momentum is kept to the round-off of doubles.
TEST(Precision, NoElementPushesItself) {
  for_all([](const Kind& kind, const Way& way) {
    if (kind.dimension == 2)
      expect_no_push<2>(block(kind, way));
    else
      expect_no_push<3>(block(kind, way));
  });
}

// However far it has turned. The body knows where it is to 2^-53 of its size, so here to 1e-8 of
// the strain.
TEST(Precision, NoMoreWhereABodyHasTurned) {
  for_all([](const Kind& kind, const Way& way) {
    for (const double angle : {1e-3, 0.1, 3.0}) {
      const Difference d = difference(kind, way, 1e-6, angle, 0);
      EXPECT_LT(d.largest, (kOperations * kRoundOff + 1e-8) * d.force) << angle;
    }
  });
}

// The bounds above can be broken: strains taken from F - 1 in single precision would have this.
TEST(Precision, RoundOffItselfWouldBeSeen) {
  const Difference d = difference(kKinds[0], kWays[0], 1e-6, 0, 0);
  EXPECT_GT(kRoundOff * 1e9 * 0.25, kOperations * kRoundOff * d.force);
}

}  // namespace
}  // namespace breccia
