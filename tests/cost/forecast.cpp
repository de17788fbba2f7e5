// What `breccia check` says of effects, against the report of a run.
#include "scene/forecast.hpp"

#include "core/log.hpp"
#include "cost/effect_scenes.hpp"
#include "cost/report_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace breccia {
namespace {

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
