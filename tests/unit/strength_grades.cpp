// Strengths that scatter from face to face: Weibull's moments, even grades, and what faces get.
#include "modules/fracture/strength_grades.hpp"

#include "harness/scenes.hpp"
#include "modules/fracture/correlated_field.hpp"
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

// Mean, variance and correlation over a square of 100 lengths; standard errors are a hundredth.
TEST(CorrelatedField, HasItsMomentsAndItsCorrelation) {
  const CorrelatedField field(1, 2.0), other(2, 2.0);
  double sum = 0, squares = 0, foreign = 0;
  constexpr int kSide = 100;
  const double distances[] = {0.5, 1, 2, 4};
  double product[4] = {};
  std::vector<int> count(16, 0);
  for (int i = 0; i < kSide; ++i)
    for (int j = 0; j < kSide; ++j) {
      const std::array<double, 3> place{2.0 * i, 2.0 * j, 0.3 * i};
      const double value = field.value(place);
      sum += value;
      squares += value * value;
      foreign += value * other.value(place);
      for (int k = 0; k < 4; ++k)
        product[k] += value * field.value({place[0], place[1] + distances[k], place[2]});
      ++count[static_cast<std::size_t>(grade_at(field.share(place), 16))];
    }
  constexpr double kPlaces = kSide * kSide;
  EXPECT_NEAR(sum / kPlaces, 0, 0.06);
  EXPECT_NEAR(squares / kPlaces, 1, 0.06);
  EXPECT_NEAR(foreign / kPlaces, 0, 0.06);
  for (int k = 0; k < 4; ++k)
    EXPECT_NEAR(product[k] / kPlaces, std::exp(-distances[k] * distances[k] / 4), 0.06);
  for (const int c : count) EXPECT_NEAR(c, kPlaces / 16, 0.25 * kPlaces / 16);
}

TEST(CorrelatedField, GradesOfNeighboursAreAlike) {
  BlockScene scene;
  scene.cells = "[20, 20]";
  scene.more =
      "[fracture.m]\ntensile_strength = \"8 MPa\"\ncohesion = \"24 MPa\"\nenergy_tension = 1e5\n"
      "energy_shear = 1e6\nscatter = 5\ncorrelation = 0.2\n";
  SceneWorld<2> world(scene.text());
  const Model<2>& model = world.model();
  const std::vector<Index> law =
      law_of_faces(read_interface_laws(*model.scene, model.materials), model);
  // Faces of one element are 0.25 cells apart, 0.0125; by chance two grades differ by 5.3.
  std::vector<std::vector<Index>> of_element(model.mesh.element.size());
  for (std::size_t f = 0; f < law.size(); ++f)
    for (const Index e : {model.topology.shared[f].left, model.topology.shared[f].right})
      of_element[static_cast<std::size_t>(e)].push_back(law[f]);
  double apart = 0, pairs = 0;
  Index least = 99, most = 0;
  for (const auto& faces : of_element)
    for (std::size_t i = 1; i < faces.size(); ++i) {
      apart += std::abs(faces[i] - faces[0]);
      pairs += 1;
      least = std::min(least, faces[i]);
      most = std::max(most, faces[i]);
    }
  EXPECT_LT(apart / pairs, 1.5);
  EXPECT_EQ(least, 0);
  EXPECT_EQ(most, 15);
}

}  // namespace
