// What a run tells about cracks, fragments and sounds.
#include "harness/scenes.hpp"
#include "point/seismic_moment.hpp"
#include "scene/emissions.hpp"
#include "scene/force_chains.hpp"
#include "scene/fragments.hpp"
#include "scene/main_crack.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace breccia;

CrackEvent break_at(double time, double x, double energy, double moment) {
  CrackEvent event;
  event.time = time;
  event.place = {x, 0, 0};
  event.area = 1e-6;
  event.energy_tension = 0.75 * energy;
  event.energy_shear = 0.25 * energy;
  event.moment = moment;
  return event;
}

// Two grains on a floor: touches of both passes add up to one contact for each two fragments, with
// the force on each leg's own fragment; the two sides of a crack in one fragment have none.
TEST(ForceChains, JoinTheFragmentsThatTouch) {
  Fragments fragments;
  fragments.of_element = {0, 0, 1, 2};
  fragments.pieces.resize(3);
  fragments.pieces[0].length = 10;
  for (int i = 1; i < 3; ++i) {
    fragments.pieces[static_cast<std::size_t>(i)].place[0] = 2.0 * i;
    fragments.pieces[static_cast<std::size_t>(i)].place[1] = 1;
    fragments.pieces[static_cast<std::size_t>(i)].length = 1;
  }
  const std::vector<Touch> touches = {
      {{2, 0, 0}, {0, -3, 0}, 0, 2},   // floor against the first grain
      {{2.5, 0, 0}, {0, 1, 0}, 2, 1},  // the grain against the floor
      {{3, 1, 0}, {-2, 0, 0}, 2, 3},   // grain against grain
      {{0, 0, 0}, {0, 9, 0}, 0, 1},    // within the floor
  };
  const ForceChains chains(2, touches, fragments);
  const Frame frame = chains.frame(0, 0);
  ASSERT_EQ(frame.connectivity.size(), 8u);
  const auto force = std::get<std::span<const double>>(frame.cell_arrays[0].values);
  const auto fragment = std::get<std::span<const std::int32_t>>(frame.cell_arrays[1].values);
  const auto partner_size = std::get<std::span<const double>>(frame.cell_arrays[4].values);
  EXPECT_THAT(force, testing::ElementsAre(0, -4, 0, 4, -2, 0, 2, 0));
  EXPECT_THAT(fragment, testing::ElementsAre(0, 1, 1, 2));
  EXPECT_THAT(partner_size, testing::ElementsAre(1, 10, 1, 1));
  // Where they press: the mean by force.
  EXPECT_DOUBLE_EQ(frame.points[2], 2.125);
  EXPECT_DOUBLE_EQ(frame.points[4], 2);
}

TEST(Emissions, GatherWhatIsNearInSpaceAndTime) {
  // A row of breaks a millimetre and a microsecond apart; one far off; one there much later.
  std::vector<CrackEvent> events;
  for (int i = 0; i < 5; ++i) events.push_back(break_at(1e-6 * i, 1e-3 * i, 2, 10));
  events.push_back(break_at(4.5e-6, 1, 7, 1000));
  events.push_back(break_at(1e-3, 0, 2, 10));
  const auto rows = find_emissions(events, {1.5e-3, 1.5e-6});
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].breaks, 5);
  EXPECT_DOUBLE_EQ(rows[0].time, 0);
  EXPECT_DOUBLE_EQ(rows[0].duration, 4e-6);
  EXPECT_DOUBLE_EQ(rows[0].energy, 10);
  EXPECT_DOUBLE_EQ(rows[0].moment, 50);
  EXPECT_DOUBLE_EQ(rows[0].mode, 1.25);
  EXPECT_NEAR(rows[0].place[0], 2e-3, 1e-18);
  EXPECT_DOUBLE_EQ(rows[0].area, 5e-6);
  EXPECT_EQ(rows[1].breaks, 1);
  // Hanks and Kanamori (1979): 1000 N m are a magnitude of 2 - 6.03.
  EXPECT_NEAR(rows[1].magnitude, -4.03, 1e-12);
  EXPECT_DOUBLE_EQ(rows[2].time, 1e-3);
  EXPECT_EQ(find_emissions(events, {0.5e-3, 1.5e-6}).size(), 7u);
  EXPECT_EQ(find_emissions(events, {1.5e-3, 0.5e-6}).size(), 7u);
  EXPECT_TRUE(find_emissions({}, {1, 1}).empty());
}

// Against the moment tensor written out.
TEST(SeismicMoment, IsThatOfTheTensor) {
  const HenckyElastic law{20e9, 30e9};
  const double u[3] = {2e-6, 5e-6, 0}, n[3] = {1, 0, 0};
  double squares = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const double m = (i == j ? law.lambda * u[0] : 0) + law.mu * (u[i] * n[j] + u[j] * n[i]);
      squares += m * m;
    }
  EXPECT_NEAR(moment_per_area(law, u[0], u[1]) / std::sqrt(squares / 2), 1, 1e-14);
  EXPECT_NEAR(moment_per_area(law, 0, 5e-6) / (30e9 * 5e-6), 1, 1e-14);
}

TEST(MainCrack, TellsWhenItBeganAndHowFastItRan) {
  // Along x from 1 to 3 at 500 m/s, in faces of 0.05; a second, smaller crack somewhere else.
  constexpr int kFaces = 40;
  std::vector<Point<2>> point;
  std::vector<CrackFace> faces;
  const auto add = [&](double x, double y, double time) {
    CrackFace face{};
    for (int c = 0; c < 2; ++c) {
      face.family[c] = static_cast<Index>(point.size()) - (c == 0 ? 1 : 0);
      if (c == 1) point.push_back({x + 0.05, y});
    }
    face.area = 0.05;
    face.status = 2;
    face.time = time;
    faces.push_back(face);
  };
  point.push_back({1, 0});
  for (int i = 0; i < kFaces; ++i) add(1 + 0.05 * i, 0, 1e-3 + 0.05 * i / 500);
  point.push_back({9, 5});
  for (int i = 0; i < 5; ++i) add(9 + 0.05 * i, 5, 1e-4);
  const MainCrack crack = find_main_crack<2>(faces, point);
  EXPECT_NEAR(crack.length, 2, 1e-12);
  EXPECT_DOUBLE_EQ(crack.start, 1e-3);
  EXPECT_NEAR(crack.speed / 500, 1, 0.02);  // the first face breaks as a whole: 0.025 of 2
  EXPECT_EQ(find_main_crack<2>({}, point).speed, 0);
}

template <int D>
Fragments::Piece whole(const std::string& size, const std::string& cells,
                       const std::string& motion) {
  BlockScene scene;
  scene.dimension = D;
  scene.size = size;
  scene.cells = cells;
  scene.body = motion;
  SceneWorld<D> world(scene.text());
  world.simulation.start();
  const Fragments found = find_fragments(world.model());
  EXPECT_EQ(found.pieces.size(), 1u);
  return found.pieces[0];
}

TEST(Fragments, HaveTheSpinAndTheEdgesOfABrick) {
  const auto plate = whole<2>("[2, 0.5]", "[4, 3]", "spin = 7\nvelocity = [3, 4]");
  EXPECT_NEAR(plate.spin[2], 7, 1e-12);
  EXPECT_NEAR(plate.length, 2, 1e-12);
  EXPECT_NEAR(plate.width, 0.5, 1e-12);
  EXPECT_NEAR(plate.velocity[1], 4, 1e-12);
  const auto brick = whole<3>("[2, 1, 0.5]", "[3, 2, 2]", "spin = [1, 2, 3]");
  EXPECT_NEAR(brick.length, 2, 1e-12);
  EXPECT_NEAR(brick.width, 0.5, 1e-12);
  for (int d = 0; d < 3; ++d) EXPECT_NEAR(brick.spin[d], d + 1, 1e-11);
}

TEST(Fragments, ExpansionStretchesAlikeInAllDirections) {
  BlockScene scene;
  scene.size = "[2, 1]";
  scene.body = "expansion = 5\nvelocity = [1, 0]";
  SceneWorld<2> world(scene.text());
  world.simulation.start();
  const auto v = world.host<NodeVelocity<2>>();
  const auto x = world.host<NodePosition<2>>();
  for (Index n = 0; n < world.model().nodes(); ++n) {
    EXPECT_NEAR(v(n, 0), 1 + 5 * (x(n, 0) - 1), 1e-12);
    EXPECT_NEAR(v(n, 1), 5 * (x(n, 1) - 0.5), 1e-12);
  }
}

}  // namespace
