#include "harness/failures.hpp"
#include "harness/temp_folder.hpp"
#include "io/report.hpp"
#include "io/run_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace breccia {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;

Report sample() {
  Report report;
  report.title = "Brazilian disc";
  report.status = "stopped";
  report.reason = "element 7 inverted";
  report.steps = 1200;
  report.time = 1.2e-3;
  report.wall_seconds = 5;
  report.backend = "OpenMP";
  report.precision = "double";
  report.elements = 20000;
  report.element_steps_per_second = 35.2e6;
  report.time_step = {1e-9, 1.5e-9, 2e-9, 0.01, "element 12"};
  report.interfaces = {29000, 40, 12};
  report.fragments = 2;
  report.ledger = {{"KE", 1.5}, {"IE_elastic", 3}, {"CT_stored", 0}};
  report.res_1 = 1e-14;
  report.guard = {12, 0.031, 0.25};
  report.effects = {{"solid", 3, 5000000, 1200}, {"contact", 1, 1024, 2400}};
  report.effects_off = {"gravity", "rest"};
  report.checks = {{"strength", 8.1e6, 8e6, 0.1, true, true, "Pa", ""},
                   {"angle", Report::kNone, 0, 10, false, false, "deg", "no crack"}};
  report.peak_memory_bytes = 200 << 20;
  report.state_hash = "00ff";
  report.version = {"0.1.0", "abc", "gcc"};
  return report;
}

TEST(IoReport, JsonHasEveryKeyOfTheSpecification) {
  const std::string json = report_json(sample());
  for (const char* key : {"status",     "reason",       "steps",
                          "time",       "wall_seconds", "threads",
                          "ranks",      "backend",      "precision",
                          "elements",   "nodes",        "element_steps_per_second",
                          "time_step",  "min",          "mean",
                          "set_by",     "interfaces",   "bonded",
                          "inserted",   "released",     "fragments",
                          "guard",      "ledger",       "KE",
                          "res_1",      "res_2",        "effects",
                          "share",      "effects_off",  "seconds",
                          "bytes",      "launches",     "checks",
                          "name",       "value",        "reference",
                          "tolerance",  "pass",         "peak_memory_bytes",
                          "state_hash", "version",      "release",
                          "commit",     "build"}) {
    EXPECT_THAT(json, HasSubstr(std::string("\"").append(key).append("\": "))) << key;
  }
  EXPECT_THAT(json, HasSubstr("\"res_2\": null"));
  EXPECT_THAT(json, HasSubstr("\"IE_elastic\": 3"));
  EXPECT_THAT(json, HasSubstr("\"share\": 0.6"));
  EXPECT_THAT(json, ContainsRegex("\"effects_off\": \\[[^]]*\"gravity\",[^]]*\"rest\""));
}

TEST(IoReport, TableShowsRunCostsEnergiesAndChecks) {
  std::ostringstream out;
  print_report(sample(), out);
  const std::string text = out.str();
  EXPECT_THAT(text, HasSubstr("stopped: element 7 inverted"));
  EXPECT_THAT(text, HasSubstr("35.2 M element-steps/s, peak memory 200 MiB"));
  EXPECT_THAT(text, HasSubstr("29000 bonded, 40 inserted, 12 released; 2 fragments"));
  EXPECT_THAT(text, ContainsRegex("solid +3.000 +60.0%"));
  EXPECT_THAT(text, ContainsRegex("everything else +1.000 +20.0%"));
  EXPECT_THAT(text, HasSubstr("off: gravity rest"));
  EXPECT_THAT(text, HasSubstr("IE_elastic"));
  EXPECT_THAT(text,
              HasSubstr("3.1 % came from nowhere at most, bodies overlapped by 0.25 heights"));
  EXPECT_THAT(text, Not(HasSubstr("CT_stored"))) << "energies that are zero are noise";
  EXPECT_THAT(text, HasSubstr("pass  strength"));
  EXPECT_THAT(text, HasSubstr("FAIL  angle"));
  EXPECT_THAT(text, HasSubstr("no crack"));
  EXPECT_THAT(text, HasSubstr("tolerance 10 %"));
}

TEST(IoReport, WrittenWholeOrNotAtAll) {
  TempFolder folder;
  const std::string path = folder / "report.json";
  write_report(sample(), path);
  EXPECT_EQ(file_text(path), report_json(sample()));
  const FileSizeLimit full(100);
  Report other = sample();
  other.title = "other";
  EXPECT_THAT(error_text([&] { write_report(other, path); }), HasSubstr(path));
  EXPECT_EQ(file_text(path), report_json(sample()));
}

TEST(IoRunFolder, FreshFolderIsMadeAndHoldsTheScene) {
  TempFolder folder;
  const RunFolder run(folder / "a/b.out/", ExistingFolder::refuse);
  EXPECT_EQ(run.path(), folder / "a/b.out");
  EXPECT_EQ(folder.entries("a/b.out"), 0u) << "the probe stays behind";
  run.write_scene("title = \"x\"\n");
  EXPECT_EQ(file_text(run.scene()), "title = \"x\"\n");
  EXPECT_EQ(run.checkpoint(), folder / "a/b.out/checkpoint.h5");
}

TEST(IoRunFolder, ExistingFolderNeedsAWord) {
  TempFolder folder;
  const std::string path = folder / "run.out";
  std::filesystem::create_directory(path);
  EXPECT_NO_THROW(RunFolder(path, ExistingFolder::refuse)) << "an empty folder is as good as none";
  put_text(path + "/history.csv", "old");
  put_text(path + "/my notes.txt", "mine");
  std::filesystem::create_directory(path + "/frames");
  EXPECT_THAT(error_text([&] { RunFolder run(path, ExistingFolder::refuse); }),
              AllOf(HasSubstr("exists already"), HasSubstr("--overwrite"), HasSubstr("--restart")));
  EXPECT_EQ(file_text(path + "/history.csv"), "old");
  const RunFolder run(path, ExistingFolder::overwrite);
  EXPECT_EQ(folder.entries("run.out"), 1u);
  EXPECT_EQ(file_text(path + "/my notes.txt"), "mine") << "overwrite took a file that is not ours";
}

TEST(IoRunFolder, RestartNeedsACheckpoint) {
  TempFolder folder;
  const std::string path = folder / "run.out";
  EXPECT_THAT(error_text([&] { RunFolder run(path, ExistingFolder::restart); }),
              HasSubstr("no checkpoint"));
  EXPECT_FALSE(std::filesystem::exists(path));
  std::filesystem::create_directory(path);
  put_text(path + "/checkpoint.h5", "x");
  put_text(path + "/history.csv", "old");
  const RunFolder run(path, ExistingFolder::restart);
  EXPECT_EQ(file_text(run.history()), "old");
}

TEST(IoRunFolder, BadPlacesAreNamed) {
  TempFolder folder;
  put_text(folder / "file", "x");
  EXPECT_THAT(error_text([&] { RunFolder run(folder / "file", ExistingFolder::overwrite); }),
              HasSubstr("is a file"));
  EXPECT_THAT(error_text([&] { RunFolder run(folder / "file/x", ExistingFolder::refuse); }),
              HasSubstr(folder / "file/x"));
  const NoRights rights;
  EXPECT_THAT(
      error_text([] { RunFolder run("/usr/run.out", ExistingFolder::refuse); }),
      AllOf(HasSubstr("/usr/run.out"), HasSubstr("Permission denied"), HasSubstr("--output")));
  EXPECT_THAT(error_text([] { RunFolder run("/usr/lib", ExistingFolder::overwrite); }),
              AllOf(HasSubstr("/usr/lib"), HasSubstr("Permission denied")));
}

TEST(IoRunFolder, FullDiskIsFoundAtTheStart) {
  TempFolder folder;
  const FileSizeLimit full(10);
  EXPECT_THAT(error_text([&] { RunFolder run(folder / "run.out", ExistingFolder::refuse); }),
              HasSubstr("File too large"));
}

}  // namespace
}  // namespace breccia
