#include "core/schema.hpp"
#include "harness/failures.hpp"
#include "io/scene_reader.hpp"

#include <sstream>

namespace breccia {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Schema sample() {
  Schema schema;
  schema.top().text("title");
  auto run = schema.section("run").always();
  run.number("duration", unit::time).by_default("1 ms");
  run.integer("seed").by_default(1);
  run.number("step", unit::time);
  auto material = schema.section("material.*");
  material.number("density", unit::density);
  schema.section("material.*.elastic").number("young", unit::pressure);
  auto body = schema.section("body[]");
  body.text("name");
  body.vector("at", unit::length);
  body.vector("velocity", unit::velocity).components_may_be("free");
  body.lines("holes", unit::length);
  body.texts("words");
  body.values("rungs");
  body.pairs("given");
  body.text("file").names_file();
  auto mesh = schema.section("body[].mesh").always();
  mesh.number("size", unit::length).by_default("2 mm");
  schema.section("body[].mesh.refine[]").number("size", unit::length);
  schema.section("contact").number("friction", unit::none).by_default(0.3);
  return schema;
}

const char* const scene = R"(title = "a \"quoted\" \\ title\nof two lines"
[run]
duration = "7 us"
[[body]]
name = "upper platen"
at = ["1 mm", 0.1]
velocity = ["free", "-0.1 m/s"]
holes = [[[0, 0], [0.3, 1e-7]]]
words = ["x", "y z"]
mesh = { size = "0.5 mm", refine = [{ size = "0.1 mm" }, { size = 3 }] }
[[body]]
rungs = ["2 mm", 3, [1, 2.5], true]
given = { length = "2 m", factor = 0.5 }
[material.granite]
density = "2650 kg/m3"
elastic = { young = "60 GPa" }
[material."Stanstead granite"]
)";

Settings resolved(const std::string& text, const std::vector<std::string>& options = {}) {
  return sample().resolve(read_scene_text(text, "folder/s.toml", options));
}

std::string written(const Settings& s) {
  std::ostringstream out;
  s.write_resolved(out);
  return out.str();
}

/// The written form without its remarks.
std::string without_remarks(const std::string& text) {
  std::string out;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) out += line.substr(0, line.find("  # ")) + "\n";
  return out;
}

TEST(CoreSettings, OrderAndNamesAreThoseOfTheScene) {
  const Settings s = resolved(scene);
  ASSERT_EQ(s.list("body").size(), 2U);
  EXPECT_EQ(s.list("body")[0].name(), "upper platen");
  EXPECT_EQ(s.list("body")[1].name(), "1");
  EXPECT_EQ(s.list("body")[1].path(), "body.1");
  EXPECT_EQ(s.children("material")[0].name(), "granite");
  EXPECT_EQ(s.children("material")[1].name(), "Stanstead granite");
  EXPECT_TRUE(s.children("nobody").empty());
  EXPECT_EQ(s.find("body", "nobody"), nullptr);
}

TEST(CoreSettings, PathsLeadIntoSections) {
  const Settings s = resolved(scene);
  EXPECT_DOUBLE_EQ(s.at("material.granite").number("elastic.young"), 60e9);
  EXPECT_DOUBLE_EQ(s.number("run.duration"), 7e-6);
  EXPECT_TRUE(s.has("run.seed"));
  EXPECT_FALSE(s.given("run.seed"));
  EXPECT_TRUE(s.given("run.duration"));
  EXPECT_TRUE(s.has("material.granite.elastic.young"));
  EXPECT_FALSE(s.has("run.step"));
  EXPECT_FALSE(s.has("contact"));
  EXPECT_EQ(s.at("run").maybe_number("step"), std::nullopt);
  const Settings& second = s.list("body")[1];
  EXPECT_TRUE(second.has("mesh.size"));
  EXPECT_FALSE(second.given("mesh"));
  EXPECT_TRUE(s.list("body")[0].given("mesh"));
}

TEST(CoreSettings, MisuseIsADefectOfTheCode) {
  const Settings s = resolved(scene);
  EXPECT_THROW((void)s.at("contact"), std::logic_error);
  EXPECT_THROW((void)s.at("run").number("nothing"), std::logic_error);
  EXPECT_THROW((void)s.at("run").text("duration"), std::logic_error);
}

TEST(CoreSettings, ErrorsAboutAKeyHaveItsPlace) {
  const Settings s = resolved(scene, {"run.seed=3"});
  EXPECT_STREQ(s.at("run").error("duration", "is short").what(),
               "folder/s.toml:3: run.duration: is short");
  EXPECT_EQ(s.at("run").place("seed"), "--set");
  EXPECT_EQ(s.list("body")[0].place(), "folder/s.toml:4");
  EXPECT_EQ(s.list("body")[0].place("mesh"), "folder/s.toml:10");
  EXPECT_EQ(s.list("body")[1].place("mesh"), s.list("body")[1].place());
  const Error e = s.at("material.granite").error("elastic.young", "is soft", "rock is stiff");
  EXPECT_STREQ(e.what(),
               "folder/s.toml:16: material.granite.elastic.young: is soft\n  rock is stiff");
}

TEST(CoreSettings, TheWrittenSceneGivesTheSameSettings) {
  const Settings first = resolved(scene, {"contact.friction=0.6"});
  const std::string text = written(first);
  const Settings again = resolved(text);
  EXPECT_EQ(without_remarks(written(again)), without_remarks(text));
  EXPECT_EQ(again.number("run.duration"), first.number("run.duration"));
  EXPECT_EQ(again.number("contact.friction"), 0.6);
  EXPECT_EQ(again.text("title"), "a \"quoted\" \\ title\nof two lines");
  EXPECT_THAT(again.list("body")[0].components("velocity"), ElementsAre(std::nullopt, -0.1));
  EXPECT_EQ(again.list("body")[0].at("mesh").list("refine")[1].number("size"), 3);
}

TEST(CoreSettings, ValuesAndPairsAreTextsAsSetTakesThem) {
  const Settings s = resolved(scene);
  const Settings& body = s.list("body").back();
  EXPECT_THAT(body.texts("rungs"), ElementsAre("2 mm", "3", "[1, 2.5]", "true"));
  EXPECT_THAT(body.texts("given"), ElementsAre("length = 2 m", "factor = 0.5"));
}

TEST(CoreSettings, RemarksTellUnitAndOrigin) {
  const std::string text = written(resolved(scene, {"contact.friction=0.6"}));
  EXPECT_THAT(text, HasSubstr("duration = 7e-06  # s, written \"7 us\"\n"));
  EXPECT_THAT(text, HasSubstr("seed = 1  # default\n"));
  EXPECT_THAT(text, HasSubstr("friction = 0.6  # --set\n"));
  EXPECT_THAT(text, HasSubstr("[material.\"Stanstead granite\"]\n"));
  EXPECT_THAT(text, HasSubstr("[[body.mesh.refine]]\n"));
}

TEST(CoreSettings, FilesAreFoundFromTheFolderOfTheScene) {
  const Settings s = resolved("[[body]]\nfile = \"../disc.msh\"\n");
  const std::string& path = s.list("body")[0].text("file");
  EXPECT_EQ(path, (std::filesystem::current_path() / "disc.msh").string());
}

}  // namespace
}  // namespace breccia
