// Strengths that scatter from face to face: Weibull's moments, even grades, and what faces get.
#include "modules/fracture/strength_grades.hpp"

#include "harness/scenes.hpp"
#include "modules/fracture/fracture_fields.hpp"
#include "modules/fracture/interface_laws.hpp"

#include <gtest/gtest.h>

namespace {

using namespace breccia;

TEST(StrengthGrades, HaveWeibullsMoments) {
  for (const double modulus : {2.0, 5.0, 10.0, 30.0}) {
    const std::vector<double> share = strength_grades(modulus);
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < share.size(); ++i) {
      if (i > 0) {
        EXPECT_GT(share[i], share[i - 1]);
      }
      sum += share[i];
      squares += (share[i] - 1) * (share[i] - 1);
    }
    const auto count = static_cast<double>(share.size());
    EXPECT_NEAR(sum / count, 1, 1e-14);
    // Ends of the distribution are left out: the deviation is up to a tenth smaller.
    const double mean = std::tgamma(1 + 1 / modulus);
    const double exact = std::sqrt(std::tgamma(1 + 2 / modulus) / (mean * mean) - 1);
    EXPECT_LT(std::sqrt(squares / count), exact);
    EXPECT_GT(std::sqrt(squares / count), 0.9 * exact) << modulus;
  }
}

TEST(StrengthGrades, AreEvenAndDependOnTheSeed) {
  constexpr int kFaces = 16000;
  std::vector<int> count(16, 0);
  int same = 0;
  for (std::uint64_t face = 0; face < kFaces; ++face) {
    const Index grade = grade_of_face(1, face, 16);
    ASSERT_TRUE(grade >= 0 && grade < 16);
    ++count[static_cast<std::size_t>(grade)];
    EXPECT_EQ(grade, grade_of_face(1, face, 16));
    if (grade == grade_of_face(2, face, 16)) ++same;
  }
  for (const int c : count) EXPECT_NEAR(c, 1000, 5 * 31);  // five deviations of 16000 draws
  EXPECT_NEAR(same, 1000, 5 * 31);
}

TEST(StrengthGrades, FacesGetThem) {
  BlockScene scene;
  scene.cells = "[20, 20]";
  scene.more =
      "[fracture.m]\ntensile_strength = \"8 MPa\"\ncohesion = \"24 MPa\"\nenergy_tension = 1e5\n"
      "energy_shear = 1e6\nalpha = 0\nscatter = 5\n";
  SceneWorld<2> world(scene.text());
  world.simulation.start();
  Model<2>& model = world.model();
  const InterfaceLaws laws = read_interface_laws(*model.scene, model.materials);
  const std::vector<Index> of_face = law_of_faces(laws, model);
  const auto record = world.host<InterfaceRecords>();
  const auto faces = static_cast<std::size_t>(model.store.count(Entity::interface));
  ASSERT_EQ(faces, of_face.size());
  double sum = 0;
  for (std::size_t i = 0; i < faces; ++i) {
    const Index law = record(i).law;
    EXPECT_EQ(law, of_face[static_cast<std::size_t>(record(i).face)]);
    const CohesiveStrength& strength = laws.laws[static_cast<std::size_t>(law)].strength;
    EXPECT_DOUBLE_EQ(strength.cohesion, 3 * strength.tension);
    sum += strength.tension;
  }
  // 2360 faces and a deviation of 0.23: five standard errors.
  EXPECT_NEAR(sum / static_cast<double>(faces), 8e6, 0.024 * 8e6);
}

}  // namespace
