// V-007: a bar at rest is hit by a rigid wall of 1 m/s that leaves with it: the wall follows f(t) +
// f(t - 2 L / c), f a smooth step, so that without contact the bar is free again after its time.
#include "harness/scenes.hpp"
#include "harness/temp_folder.hpp"
#include "scene/commands.hpp"

#include <gtest/gtest.h>

namespace breccia {
namespace {

const char* kMore = R"toml(
[[boundary]]
name = "wall"
where = "b.left"
velocity = ["1 m/s", "free"SPACE]
table = [[0, 0], ["0.05 ms", 0.15625], ["0.1 ms", 0.5], ["0.15 ms", 0.84375], ["0.2 ms", 1],
         ["2 ms", 1], ["2.05 ms", 1.15625], ["2.1 ms", 1.5], ["2.15 ms", 1.84375], ["2.2 ms", 2]]
[[sensor]]
name = "wall"
reaction = "wall"
[[sensor]]
name = "bar"
surface = "b"
[[sensor]]
name = "middle"
point = [0.5, 0.01POINT]
[output]
frames = 0
history = "2 us"
[[check]]
name = "speed of the front"
value = "0.5 m / (arrival(middle.vx, 0.5 m/s) - 0.1 ms)"
reference = "1000 m/s"
tolerance = "0.5 %"
[[check]]
name = "stress behind the front"
value = "at(middle.sxx, 0.9 ms)"
reference = "-1 MPa"
tolerance = "1 %"
[[check]]
name = "time of contact"
value = "integral(wall.x) / at(wall.x, 1 ms)"
reference = "2 ms"
tolerance = "0.5 %"
[[check]]
name = "push of the wall"
value = "at(wall.x, 1 ms)"
reference = "AREA * 1 MPa"
tolerance = "1 %"
[[check]]
name = "velocity of rebound"
value = "final(bar.vx)"
reference = "2 m/s"
tolerance = "0.5 %"
[[check]]
name = "the bar leaves without vibration"
value = "final(IE_elastic) / final(KE)"
reference = "0"
tolerance = "1e-3"
[[check]]
name = "balance of energy"
value = "res_2"
reference = "0"
tolerance = "1e-3"
[[check]]
name = "round-off of energy"
value = "res_1"
reference = "0"
tolerance = "1e-10"
)toml";

void replace(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at; (at = text.find(from)) != std::string::npos;)
    text.replace(at, from.size(), to);
}

void check_bar(BlockScene scene, const std::string& area) {
  const bool space = scene.dimension == 3;
  scene.poisson = 0;
  scene.run = "duration = \"2.6 ms\"";
  scene.more = kMore;
  replace(scene.more, "SPACE", space ? ", \"free\"" : "");
  replace(scene.more, "POINT", space ? ", 0.01" : "");
  replace(scene.more, "AREA", area);
  const TempFolder folder;
  put_text(folder / "bar.toml", scene.text());
  testing::internal::CaptureStdout();
  const int status = run_scene({folder / "bar.toml", {}, folder / "out", false, false, false});
  const std::string said = testing::internal::GetCapturedStdout();
  EXPECT_EQ(status, 0) << said;
}

TEST(BarOnWall, Plane) {
  check_bar({2, "[1, 0.02]", "[100, 2]"}, "0.02 m2");  // the thickness is 1 m
}

TEST(BarOnWall, Space) {
  check_bar({3, "[1, 0.02, 0.02]", "[100, 2, 2]"}, "(0.02 m)^2");
}

}  // namespace
}  // namespace breccia
