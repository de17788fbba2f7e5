// What `breccia check` foretells, against runs. Times: run alone (RUN_SERIAL).
#include "scene/forecast.hpp"

#include "core/log.hpp"
#include "cost/effect_scenes.hpp"
#include "cost/paired.hpp"
#include "harness/temp_folder.hpp"
#include "io/json_reader.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>

namespace breccia {
namespace {

constexpr int kTurns = 5;

/// The report of a run of the scene.
Json report_of(const std::string& scene) {
  const TempFolder folder;
  std::ofstream(folder / "scene.toml") << scene;
  RunRequest request;
  request.scene = folder / "scene.toml";
  request.output = folder / "out";
  request.quiet = true;
  EXPECT_EQ(run_scene(request), 0);
  return read_json(folder / "out/report.json");
}

struct Comparison {
  double foretold;   ///< seconds of the run over those of the forecast
  double accounted;  ///< share of the seconds that effects account for
};

template <int D>
Comparison run_and_compare(const BlockScene& scene) {
  log::set_quiet(true);
  // Other work only adds to either: the least of each is what they are by themselves.
  double foretold = 1e300, taken = 1e300;
  std::vector<double> accounted;
  for (int turn = 0; turn < kTurns; ++turn) {
    SceneWorld<D> world(scene.text());
    world.simulation.start();
    const Forecast sheet = forecast(world.simulation, 0.1);
    const Json report = report_of(scene.text());
    const double wall = report["wall_seconds"].number();
    double sum = 0;
    for (const auto& [name, effect] : report["effects"].object()) sum += effect["seconds"].number();
    foretold = std::min(foretold, sheet.seconds());
    taken = std::min(taken, wall);
    accounted.push_back(sum / wall);
  }
  return {taken / foretold, median(accounted)};
}

BlockScene short_run(int dimension, const std::string& more) {
  BlockScene scene = turning_block(dimension, more);
  scene.run = dimension == 2 ? "duration = 0.008" : "duration = 0.04";  // a thousand steps or two
  return scene;
}

TEST(SlowForecast, AnIntactSceneTakesWhatWasForetold) {
  for (const bool plane : {true, false}) {
    const int dimension = plane ? 2 : 3;
    std::string sections = "[output]\nframes = 0\nhistory = 1e-3\n";
    for (const EffectCase& effect : effect_cases(dimension))
      if (effect.name == "fracture" || effect.name == "contact" || effect.name == "boundary")
        sections += effect.section;
    const BlockScene scene = short_run(dimension, sections);
    const Comparison outcome = plane ? run_and_compare<2>(scene) : run_and_compare<3>(scene);
    RecordProperty(fmt::format("foretold_{}d", dimension), fmt::format("{:.3f}", outcome.foretold));
    RecordProperty(fmt::format("accounted_{}d", dimension),
                   fmt::format("{:.4f}", outcome.accounted));
    EXPECT_NEAR(outcome.foretold, 1, 0.25) << dimension << "D";
    EXPECT_GT(outcome.accounted, 0.95) << dimension << "D";
    EXPECT_LT(outcome.accounted, 1.001) << dimension << "D";
  }
}

// Frames: what making them takes is foretold, what the disk takes is not.
TEST(SlowForecast, FramesAreForetoldWithinAFactorOfThree) {
  const Comparison outcome = run_and_compare<2>(short_run(2, "[output]\nframes = 20\n"));
  RecordProperty("foretold", fmt::format("{:.3f}", outcome.foretold));
  EXPECT_GT(outcome.foretold, 0.75);
  EXPECT_LT(outcome.foretold, 3);
  EXPECT_GT(outcome.accounted, 0.95);
}

// The sheet has the names of the report.
TEST(Forecast, NamesEffectsAsTheReportDoes) {
  std::string sections;
  for (const EffectCase& effect : effect_cases(2))
    if (effect.name != "rest" && effect.name != "rigid") sections += effect.section;
  BlockScene scene = cost_block(2, sections);
  scene.run = "duration = 0.01";
  log::set_quiet(true);
  SceneWorld<2> world(scene.text());
  world.simulation.start();
  const Forecast sheet = forecast(world.simulation, 0.0);
  const Json report = report_of(scene.text());
  std::vector<std::string> on, off, in_report, off_report;
  for (const Forecast::Effect& effect : sheet.effects)
    (effect.on ? on : off).push_back(effect.name);
  for (const auto& [name, effect] : report["effects"].object()) in_report.push_back(name);
  for (const Json& name : report["effects_off"].array()) off_report.push_back(name.text());
  std::sort(on.begin(), on.end());  // as the reader of JSON sorts them
  EXPECT_EQ(on, in_report);
  EXPECT_EQ(off, off_report);
  EXPECT_EQ(off, (std::vector<std::string>{"rigid", "rest"}));
}

// What is foretold of an effect says which line of the scene called for it.
TEST(Forecast, SaysWhyEachEffectIsThere) {
  BlockScene scene = cost_block(2, "[contact]\nfriction = 0.3\n");
  scene.material = "j2 = { yield = \"100 MPa\" }";
  scene.damping = 0.02;
  SceneWorld<2> world(scene.text());
  world.simulation.start();
  const Forecast sheet = forecast(world.simulation, 0.0);
  EXPECT_EQ(sheet.measured, 1);
  std::map<std::string, Forecast::Effect> of;
  for (const Forecast::Effect& effect : sheet.effects) of[effect.name] = effect;
  EXPECT_EQ(of.at("gravity").why, "no [gravity]");
  EXPECT_FALSE(of.at("gravity").on);
  const std::string text = scene.text();
  const auto line =
      1 + std::count(text.begin(),
                     text.begin() + static_cast<std::ptrdiff_t>(text.find("[contact]")), '\n');
  EXPECT_EQ(of.at("contact").why, fmt::format("contact, line {}", line));
  EXPECT_GT(of.at("contact").bytes, 0u);
  std::vector<std::string> parts;
  for (const EffectPart& part : of.at("solid").parts) parts.push_back(part.name);
  EXPECT_EQ(parts, (std::vector<std::string>{"damping", "yielding"}));
  EXPECT_GT(of.at("solid").parts[1].bytes, 0u);
  EXPECT_EQ(unforeseen(world.simulation.scene(), of.at("solid").parts).back(), "the disk");
}

}  // namespace
}  // namespace breccia
