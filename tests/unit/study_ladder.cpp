#include "core/error.hpp"
#include "harness/failures.hpp"
#include "io/scene_reader.hpp"
#include "jobs/knobs.hpp"
#include "study/ladder.hpp"

#include <cmath>

namespace breccia {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Config sample() {
  return read_scene_text(R"(
[[body]]
name = "a"
mesh = { size = 1 }
[[body]]
name = "b"
mesh = { cells = [1, 2] }
[material."old rock"]
density = 1
)",
                         "sample");
}

std::string refusal(const std::string& key) {
  try {
    knob_paths(key, sample());
  } catch (const Error& e) {
    return e.what();
  }
  return "nothing";
}

TEST(StudyKnobs, StarsStandForThoseThatWriteTheKey) {
  EXPECT_THAT(knob_paths("mesh size", sample()), ElementsAre("body.0.mesh.size"));
  EXPECT_THAT(knob_paths("cells", sample()), ElementsAre("body.1.mesh.cells"));
}

TEST(StudyKnobs, OrElseForAllThatHaveTheSection) {
  EXPECT_THAT(knob_paths("element", sample()),
              ElementsAre("body.0.mesh.element", "body.1.mesh.element"));
  EXPECT_THAT(knob_paths("damping", sample()), ElementsAre("material.\"old rock\".damping"));
}

TEST(StudyKnobs, APathIsTakenAsItIs) {
  EXPECT_THAT(knob_paths("body.a.mesh.size", sample()), ElementsAre("body.a.mesh.size"));
  EXPECT_THAT(knob_paths("step factor", sample()), ElementsAre("run.step_factor"));
}

TEST(StudyKnobs, AreRefusedWithTheNearestName) {
  EXPECT_THAT(refusal("mesh sise"), HasSubstr("no knob 'mesh sise'. Did you mean 'mesh size'?"));
  // an effect that the scene does not have is not switched on by a study of it
  EXPECT_THAT(refusal("contact stiffness"), HasSubstr("fits nothing in this scene"));
  EXPECT_THAT(refusal("fracture.*.alpha"), HasSubstr("fits nothing in this scene"));
}

TEST(StudyKnobs, RungsAsNumbers) {
  EXPECT_DOUBLE_EQ(rung_number("2 mm"), 2e-3);
  EXPECT_DOUBLE_EQ(rung_number("0.5"), 0.5);
  EXPECT_DOUBLE_EQ(rung_number("[40, 2]"), 1.0 / 40);
  EXPECT_TRUE(std::isnan(rung_number("tri6c")));
  EXPECT_TRUE(std::isnan(rung_number("[]")));
}

std::vector<Knob> two_knobs() {
  return {{"size", {"x.size"}, {"2 mm", "1 mm"}, {"2 mm", "1 mm"}, {2e-3, 1e-3}},
          {"element",
           {"x.element", "y.element"},
           {"tri3", "tri6c", "tet"},
           {"tri3", "tri6c", "tet"},
           {}}};
}

TEST(StudyLadder, ProductHasEveryCombination) {
  const auto jobs = climb(two_knobs(), true);
  ASSERT_EQ(jobs.size(), 6u);
  EXPECT_EQ(jobs[0].label, "size 2 mm, element tri3");
  EXPECT_THAT(jobs[3].options, ElementsAre("x.size=1 mm", "x.element=tri6c", "y.element=tri6c"));
}

TEST(StudyLadder, OneAtATimeLeavesTheOthersAlone) {
  const auto jobs = climb(two_knobs(), false);
  ASSERT_EQ(jobs.size(), 5u);
  EXPECT_THAT(jobs[1].options, ElementsAre("x.size=1 mm"));
  EXPECT_THAT(jobs[1].rung, ElementsAre(1, -1));
  EXPECT_EQ(jobs[2].label, "element tri3");
}

TEST(StudyLadder, EqualScenesRunOnce) {
  auto jobs = climb(two_knobs(), false);
  for (std::size_t i = 0; i < jobs.size(); ++i) jobs[i].identity = i == 4 ? "3" : std::to_string(i);
  number_jobs(jobs);
  EXPECT_EQ(jobs[4].same_as, 3u);
  EXPECT_EQ(jobs[4].folder, jobs[3].folder);
  EXPECT_EQ(jobs[1].folder, "002_size_1_mm");
}

TEST(StudyLadder, LinesFollowOneKnob) {
  const auto knobs = two_knobs();
  const auto jobs = climb(knobs, true);
  EXPECT_THAT(lines_along(0, jobs),
              ElementsAre(ElementsAre(0, 1), ElementsAre(2, 3), ElementsAre(4, 5)));
  EXPECT_THAT(lines_along(1, jobs), ElementsAre(ElementsAre(0, 2, 4), ElementsAre(1, 3, 5)));
  EXPECT_EQ(other_rungs(jobs[3], 0, knobs), "element tri6c");
}

}  // namespace
}  // namespace breccia
