// Where the plan puts what ranks tell one another.
#include "step/plan.hpp"

#include <gtest/gtest.h>

namespace breccia {
namespace {

Task& add(Plan& plan, Stage stage, const std::string& name, std::string& order) {
  return plan.add(stage, name, "effect", [&order, name](const Clock&) { order += name + " "; });
}

std::string run(Plan& plan, std::string& order) {
  plan.finish({"x"});
  plan.run(Stage::search, Stage::observe, Clock{});
  return order;
}

TEST(Plan, BringsAFieldBehindItsLastWriter) {
  Plan plan;
  std::string order;
  add(plan, Stage::advance, "move", order).writes = {"x"};
  add(plan, Stage::observe, "look", order);
  Task& force = add(plan, Stage::element_force, "force", order);
  force.reads = force.ghosts = {"x"};
  plan.exchange_by({"x", "v"}, [&order](const Clock&) { order += "exchange "; });
  EXPECT_EQ(run(plan, order), "force move exchange look ");
}

TEST(Plan, BringsNothingThatNobodyReadsWithGhosts) {
  Plan plan;
  std::string order;
  add(plan, Stage::advance, "move", order).writes = {"x"};
  add(plan, Stage::element_force, "force", order).reads = {"x"};
  plan.exchange_by({"x"}, [&order](const Clock&) { order += "exchange "; });
  EXPECT_EQ(run(plan, order), "force move ");
}

}  // namespace
}  // namespace breccia
