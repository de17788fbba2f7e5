// [[norm]]: root mean squares over volume, against closed forms.
#include "scene/field_norms.hpp"

#include "harness/scenes.hpp"

#include <gtest/gtest.h>

namespace breccia {
namespace {

double number(const Numbers& numbers, const std::string& name) {
  for (const auto& [known, value] : numbers)
    if (known == name) return value;
  ADD_FAILURE() << "no " << name;
  return 0;
}

template <int D>
Numbers norms_of(const std::string& sections, const VectorField<D>& velocity) {
  BlockScene scene;
  scene.dimension = D;
  if (D == 3) {
    scene.size = "[1, 1, 1]";
    scene.cells = "[2, 2, 2]";
  }
  scene.jitter = 0.1;
  scene.more = sections;
  SceneWorld<D> world(scene.text());
  world.simulation.start();
  put_field<NodeVelocity<D>, D>(world, velocity);
  return field_norms(world.simulation);
}

// The mean of x^2 over the unit square or cube is 1/3; what is linear in the elements is squared
// and integrated exactly, on any mesh.
template <int D>
void check_linear() {
  const Numbers n = norms_of<D>(
      "[[norm]]\nname = \"plain\"\nfields = [\"velocity.x\"]\n"
      "[[norm]]\nname = \"right\"\nfields = [\"velocity.x\", \"velocity.y\"]\nexact = [\"3 * x\", "
      "\"0\"]\n"
      "[[norm]]\nname = \"off\"\nfields = [\"velocity.x\"]\nexact = [\"2 * x + time\"]\nbody = "
      "\"b\"\n",
      [](const Vec<D>& x) {
        Vec<D> v = Vec<D>::zero();
        v[0] = 3 * x[0];
        return v;
      });
  EXPECT_NEAR(number(n, "norm.plain"), 3 / std::sqrt(3.0), 1e-14);
  EXPECT_NEAR(number(n, "norm.right"), 0, 1e-14);
  EXPECT_NEAR(number(n, "norm.right.share"), 0, 1e-14);
  EXPECT_NEAR(number(n, "norm.off"), 1 / std::sqrt(3.0), 1e-14);
  EXPECT_NEAR(number(n, "norm.off.share"), 0.5, 1e-14);
  EXPECT_EQ(n.size(), 5U);
}

TEST(FieldNorms, LinearFieldsInThePlane) {
  check_linear<2>();
}

TEST(FieldNorms, LinearFieldsInSpace) {
  check_linear<3>();
}

// |v|^2 of two components adds up: mean of x^2 + y^2.
TEST(FieldNorms, ComponentsAddUp) {
  const Numbers n =
      norms_of<2>("[[norm]]\nname = \"n\"\nfields = [\"velocity.x\", \"velocity.y\"]\n",
                  [](const Vec<2>& x) { return x; });
  EXPECT_NEAR(number(n, "norm.n"), std::sqrt(2.0 / 3), 1e-14);
}

// A constant stress in every element is exact too: (lambda + 2 mu) eps and lambda eps, to first
// order in the strain.
TEST(FieldNorms, StressOfAStretchedBlock) {
  const double eps = 1e-6;
  BlockScene scene;
  const double lambda =
      scene.young * scene.poisson / ((1 + scene.poisson) * (1 - 2 * scene.poisson));
  const double mu = 0.5 * scene.young / (1 + scene.poisson);
  scene.more = fmt::format(
      "[[norm]]\nname = \"n\"\nfields = [\"stress.xx\", \"stress.yy\"]\n"
      "exact = [\"{:.17g}\", \"{:.17g}\"]\n",
      (lambda + 2 * mu) * eps, lambda * eps);
  SceneWorld<2> world(scene.text());
  world.simulation.start();
  put_field<NodePosition<2>, 2>(world, [&](const Vec<2>& x) {
    return Vec<2>{{x[0] * (1 + eps), x[1]}};
  });
  EXPECT_NEAR(number(field_norms(world.simulation), "norm.n.share"), 0, 3 * eps);
}

TEST(FieldNorms, NoSectionNoNumbers) {
  EXPECT_TRUE(norms_of<2>("", [](const Vec<2>& x) { return x; }).empty());
}

}  // namespace
}  // namespace breccia
