// The runner with a shell script in the place of breccia: `program run SCENE --set CASE ...`.
#include "batch/runner.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <string>

namespace breccia {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using Stage = VariantState::Stage;

// Counts its calls and how many of it run at once; does then what its case says.
constexpr const char* kProgram = R"SH(#!/bin/sh
for out; do :; done
echo "$*" >> "$out/calls"
mkdir "$out/../running.$$"
ls -d "$out"/../running.* | wc -l >> "$out/../at_once"
sleep 0.05
rmdir "$out/../running.$$"
complete() { echo '{ "status": "complete" }' > "$out/report.json"; exit "${1:-0}"; }
case "$4 $(wc -l < "$out/calls")" in
  "right "* | "second_time 2" | "killed_once 2") complete ;;
  "check "*) complete 3 ;;
  "killed_once 1") touch "$out/checkpoint.h5"; kill -9 $$ ;;
  "stopped "*) touch "$out/checkpoint.h5"; echo '{ "status": "stopped" }' > "$out/report.json" ;;
esac
echo "error: $4 has failed"
exit 1
)SH";

class BatchRunner : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    sweep_.output = fs::temp_directory_path() / (std::string("breccia_batch_") + test->name());
    fs::remove_all(sweep_.output);
    fs::create_directories(sweep_.output);
    sweep_.program = (sweep_.output / "program").string();
    std::ofstream(sweep_.program) << kProgram;
    fs::permissions(sweep_.program, fs::perms::owner_all);
    sweep_.scene = "scene.toml";
  }
  void TearDown() override { fs::remove_all(sweep_.output); }

  void add(const std::string& what) {
    Variant variant;
    variant.number = sweep_.variants.size();
    variant.folder = std::to_string(variant.number);
    variant.label = what;
    variant.identity = "identity of " + what;
    variant.options = {what};
    sweep_.variants.push_back(variant);
    states_.emplace_back();
  }

  void run(int attempts = 2) {
    std::vector<std::size_t> open;
    for (std::size_t v = 0; v < states_.size(); ++v)
      if (states_[v].stage != Stage::complete) open.push_back(v);
    run_variants(sweep_, open, attempts, states_, {});
  }

  /// What the program was called with, one line a call.
  std::vector<std::string> calls(std::size_t variant) const {
    std::ifstream file(sweep_.folder(variant) / "calls");
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);) lines.push_back(line);
    return lines;
  }

  Sweep sweep_;
  std::vector<VariantState> states_;
};

TEST_F(BatchRunner, FailedOnesAreRetriedOnce) {
  for (const char* what : {"right", "wrong", "second_time", "check"}) add(what);
  sweep_.side_by_side = 4;
  run();
  EXPECT_EQ(states_[0].stage, Stage::complete);
  EXPECT_EQ(states_[1].stage, Stage::failed);
  EXPECT_EQ(states_[1].reason, "wrong has failed");
  EXPECT_EQ(states_[2].stage, Stage::complete);
  EXPECT_TRUE(states_[2].reason.empty());
  EXPECT_EQ(states_[3].stage, Stage::complete);  // a failed check is a result
  EXPECT_EQ(calls(0).size(), 1U);
  EXPECT_EQ(calls(1).size(), 2U);
  EXPECT_EQ(calls(2).size(), 2U);
  for (std::size_t v = 0; v < 4; ++v)
    EXPECT_EQ(static_cast<std::size_t>(states_[v].attempts), calls(v).size()) << v;
}

TEST_F(BatchRunner, OnlyWhatWasCutOffGoesOnFromItsCheckpoint) {
  for (const char* what : {"killed_once", "stopped", "second_time"}) add(what);
  run();
  EXPECT_EQ(states_[0].stage, Stage::complete);
  for (const std::size_t v : {0U, 1U}) {
    EXPECT_THAT(calls(v)[0], testing::HasSubstr("--overwrite"));
    EXPECT_THAT(calls(v)[1], testing::HasSubstr("--restart"));
  }
  EXPECT_THAT(calls(2)[1], testing::HasSubstr("--overwrite"));
}

TEST_F(BatchRunner, NeverMoreAtATimeThanAllowed) {
  for (int i = 0; i < 12; ++i) add("right");
  sweep_.side_by_side = 3;
  run();
  std::ifstream file(sweep_.output / "at_once");
  int most = 0, count = 0;
  for (int at_once = 0; file >> at_once; ++count) most = std::max(most, at_once);
  EXPECT_EQ(count, 12);
  EXPECT_LE(most, 3);
  EXPECT_GE(most, 2);
}

TEST_F(BatchRunner, StatesAreThereForTheNextCall) {
  for (const char* what : {"right", "wrong", "right"}) add(what);
  run(1);
  std::vector<VariantState> kept = load_states(sweep_, false);
  EXPECT_EQ(kept[0].stage, Stage::complete);
  EXPECT_EQ(kept[1].stage, Stage::failed);
  EXPECT_EQ(kept[1].reason, "wrong has failed");
  EXPECT_EQ(kept[1].attempts, 1);
  states_ = kept;
  run(2);
  EXPECT_EQ(calls(0).size(), 1U);
  EXPECT_EQ(calls(1).size(), 2U);
  // A damaged file is no result.
  std::ofstream(sweep_.folder(2) / "variant.json") << "{";
  EXPECT_EQ(load_states(sweep_, false)[2].stage, Stage::waiting);
}

TEST_F(BatchRunner, SeveralRanksNeedALauncher) {
  add("right");
  sweep_.program = "breccia";
  sweep_.output = "out";
  sweep_.threads = 2;
  const auto alone = run_command(sweep_, 0, false, true);
  EXPECT_THAT(alone, ElementsAre("breccia", "run", "scene.toml", "--set", "right", "--quiet",
                                 "--overwrite", "--threads", "2", "--output", "out/0"));
  sweep_.ranks = 4;
  auto here = run_command(sweep_, 0, true, false), there = run_command(sweep_, 0, true, true);
  const std::vector<std::string> mpirun{"mpirun", "-n", "4", "--bind-to", "none", "breccia"};
  const std::vector<std::string> srun{"srun", "--ntasks=4", "--cpus-per-task=2", "breccia"};
  EXPECT_EQ(std::vector(here.begin(), here.begin() + 6), mpirun);
  EXPECT_EQ(std::vector(there.begin(), there.begin() + 4), srun);
  EXPECT_THAT(here, testing::Contains("--restart"));
}

}  // namespace
}  // namespace breccia
