// Seconds that `breccia check` foretells, against runs: run alone (RUN_SERIAL).
#include "core/log.hpp"
#include "cost/effect_scenes.hpp"
#include "cost/paired.hpp"
#include "cost/report_of.hpp"
#include "scene/forecast.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace breccia {
namespace {

constexpr int kTurns = 5;

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

}  // namespace
}  // namespace breccia
