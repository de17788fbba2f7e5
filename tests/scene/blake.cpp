// V-026: a spherical cavity under a step of pressure, against Blake's closed form.
#include "harness/scenes.hpp"
#include "harness/temp_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace breccia {
namespace {

constexpr double kRadius = 0.1, kPressure = 1e6, kDensity = 3000, kSpeed = 5000, kRatio = 0.25;

/// Radial displacement; F. G. Blake, J. Acoust. Soc. Am. 24 (1952) 211.
double blake(double r, double t) {
  const double s = t - (r - kRadius) / kSpeed;
  if (s <= 0) return 0;
  const double n = (1 - 2 * kRatio) / (1 - kRatio) * kSpeed / kRadius;
  const double b = std::sqrt(1 - 2 * kRatio) / (1 - kRatio) * kSpeed / kRadius;
  const double k = kRadius * kPressure / (kDensity * (b * b + n * n));
  return k / (r * r) *
         (1 -
          std::exp(-n * s) * (std::cos(b * s) -
                              n / b * ((b * b + n * n) * r / (n * kSpeed) - 1) * std::sin(b * s)));
}

// The table of the case.
TEST(Blake, ClosedFormHasItsTabulatedValues) {
  EXPECT_NEAR(blake(0.15, 1.6e-4), 4.45334e-7, 1e-12);
  EXPECT_NEAR(blake(0.3, 1.6e-4), 1.05245e-7, 1e-12);
  EXPECT_NEAR(blake(0.8, 1.6e-4), 7.97658e-8, 1e-12);
}

/// An eighth of a shell from the cavity to ten times its radius, elements growing with the radius.
std::string shell(double per_radius) {
  return fmt::format(
      "a = 0.1; b = 1.0; h = a / {};\n"
      "Point(1) = {{0,0,0,h}};\n"
      "Point(2) = {{a,0,0,h}}; Point(3) = {{0,a,0,h}}; Point(4) = {{0,0,a,h}};\n"
      "Point(5) = {{b,0,0,h*b/a}}; Point(6) = {{0,b,0,h*b/a}}; Point(7) = {{0,0,b,h*b/a}};\n"
      "Circle(1) = {{2,1,3}}; Circle(2) = {{3,1,4}}; Circle(3) = {{4,1,2}};\n"
      "Circle(4) = {{5,1,6}}; Circle(5) = {{6,1,7}}; Circle(6) = {{7,1,5}};\n"
      "Line(7) = {{2,5}}; Line(8) = {{3,6}}; Line(9) = {{4,7}};\n"
      "Curve Loop(1) = {{1,2,3}}; Surface(1) = {{1}};\n"
      "Curve Loop(2) = {{4,5,6}}; Surface(2) = {{2}};\n"
      "Curve Loop(3) = {{1,8,-4,-7}}; Plane Surface(3) = {{3}};\n"
      "Curve Loop(4) = {{2,9,-5,-8}}; Plane Surface(4) = {{4}};\n"
      "Curve Loop(5) = {{3,7,-6,-9}}; Plane Surface(5) = {{5}};\n"
      "Surface Loop(1) = {{1,2,3,4,5}}; Volume(1) = {{1}};\n"
      "Physical Volume(\"shell\") = {{1}}; Physical Surface(\"cavity\") = {{1}};\n",
      per_radius);
}

/// RMS error of the displacement of all nodes at 160 us over its RMS.
double error_of(const std::string& element, double per_radius, double damping) {
  const TempFolder folder;
  std::ofstream(folder / "shell.geo") << shell(per_radius);
  std::string text = fmt::format(
      "[run]\ndimension = 3\nduration = 160e-6\n"
      "[[body]]\nname = \"b\"\nmaterial = \"m\"\n"
      "shape = {{ file = \"{}\", region = \"shell\" }}\nmesh = {{ element = \"{}\" }}\n"
      "[material.m]\ndensity = 3000\nelastic = {{ young = 62.5e9, poisson = 0.25 }}\ndamping = {}\n"
      "[[boundary]]\nwhere = \"b.cavity\"\npressure = 1e6\n",
      std::string(folder / "shell.geo"), element, damping);
  for (const char* normal : {"[1, 0, 0]", "[0, 1, 0]", "[0, 0, 1]"})
    text += fmt::format(
        "[[boundary]]\nplane = {{ point = [0, 0, 0], normal = {} }}\nsymmetry = true\n", normal);
  SceneWorld<3> world(text);
  world.simulation.start();
  while (world.time() < 160e-6) world.step(160e-6);
  const auto x = world.host<NodePosition<3>>();
  double wrong = 0, whole = 0;
  for (Index n = 0; n < world.model().mesh.points(); ++n) {
    const Vec<3> at = vector_of<3>(world.model().mesh.point[static_cast<std::size_t>(n)]);
    const double r = norm(at), expected = blake(r, world.time());
    const double u = dot(row<3>(x, n) - at, at) / r;
    wrong += (u - expected) * (u - expected);
    whole += expected * expected;
  }
  return std::sqrt(wrong / whole);
}

// Nodes at a/10 and a/20 of the cavity. Measured 4.3 and 1.9 %, 5.3 and 3.0 %: the front is a jump
// of velocity, so the order is about one.
TEST(BlakeSlow, TetrahedraComeNear) {
  const double coarse = error_of("tet4", 10, 0), fine = error_of("tet4", 20, 0);
  EXPECT_LT(fine, 0.025);
  EXPECT_LT(fine, 0.6 * coarse);
}
TEST(BlakeSlow, CompositesComeNear) {
  const double coarse = error_of("tet10c", 5, 0), fine = error_of("tet10c", 10, 0);
  EXPECT_LT(fine, 0.035);
  EXPECT_LT(fine, 0.7 * coarse);
  EXPECT_LT(error_of("tet10c", 10, 0.1), 0.025);
}

}  // namespace
}  // namespace breccia
