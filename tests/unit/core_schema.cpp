#include "core/schema.hpp"
#include "harness/failures.hpp"
#include "io/scene_reader.hpp"

#include <sstream>

namespace breccia {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// A table of keys with one of each kind.
Schema sample() {
  Schema schema;
  schema.top().text("title");
  auto run = schema.section("run").required().doc("How long.");
  run.integer("dimension").between(2, 3).required().example("2");
  run.number("duration", unit::time).above(0).required().doc("Time to simulate.").example("1 ms");
  run.choice("plane", {"strain", "stress"}).by_default("strain").only_in(2);
  run.flag("fast").by_default(false);
  auto material = schema.section("material.*").effect("solid").doc("A material.");
  material.number("density", unit::density)
      .above(0)
      .required()
      .doc("Mass per volume.")
      .example("2650 kg/m3");
  material.number("angle", unit::angle).between(0, 1.5).by_default("30 deg");
  material.number("share", unit::none).between(0, 1);
  auto body = schema.section("body[]");
  body.text("name").required().unique();
  body.text("material").names_one_of("material");
  body.vector("velocity", unit::velocity).components_may_be("free");
  body.vector("corner", unit::length);
  body.rotation("spin", unit::angular_velocity);
  body.numbers("sizes", unit::length).above(0);
  body.integers("cells").at_least(1);
  body.texts("words");
  body.texts("between").names_one_of("material");
  body.table("history", unit::time, unit::none);
  body.points("outline", unit::length);
  body.lines("holes", unit::length);
  body.formula("value");
  body.text("short").identifier();
  body.at_most_one_of({"corner", "cells"});
  auto shape = schema.section("body[].shape");
  shape.text("file").names_file();
  shape.exactly_one_of({"disc", "box", "file"});
  schema.section("body[].shape.disc").only_in(2).number("diameter", unit::length).above(0);
  schema.section("body[].shape.box").only_in(3).vector("size", unit::length).above(0);
  schema.section("output").always().integer("frames").by_default(20);
  schema.section("interface.*").names_refer_to("material").number("G", unit::surface_energy);
  return schema;
}

const std::string head = "[run]\ndimension = 2\nduration = \"1 ms\"\n";
const std::string granite = "[material.granite]\ndensity = 2650\n";

Settings resolved(const std::string& text) {
  return sample().resolve(read_scene_text(text, "s.toml"));
}

std::string refusal(const std::string& text) {
  return error_text([&] { resolved(text); });
}

/// What is said about one more key of a body.
std::string in_body(const std::string& line) {
  return refusal(head + granite + "[[body]]\nname = \"a\"\n" + line + "\n");
}

TEST(CoreSchema, ValuesArriveInSi) {
  const Settings s = resolved(head + granite + R"(
[[body]]
name = "a"
velocity = ["free", "-2 mm/s"]
spin = "3 rad/s"
sizes = ["1 mm", 2]
cells = [3, 4]
words = ["u", "v"]
history = [[0, 0], ["1 ms", "50 %"]]
outline = [[0, 0], ["1 mm", 0]]
holes = [[[0, 0], [1, 1]]]
value = 3
short = "load_1"
)");
  EXPECT_DOUBLE_EQ(s.at("run").number("duration"), 1e-3);
  EXPECT_EQ(s.at("run").text("plane"), "strain");
  EXPECT_FALSE(s.at("run").flag("fast"));
  const Settings& body = *s.find("body", "a");
  EXPECT_THAT(body.components("velocity"), ElementsAre(std::nullopt, -2e-3));
  EXPECT_THAT(body.vector("spin"), ElementsAre(3));
  EXPECT_THAT(body.vector("sizes"), ElementsAre(1e-3, 2));
  EXPECT_THAT(body.integers("cells"), ElementsAre(3, 4));
  EXPECT_THAT(body.texts("words"), ElementsAre("u", "v"));
  EXPECT_THAT(body.points("history"), ElementsAre(ElementsAre(0, 0), ElementsAre(1e-3, 0.5)));
  EXPECT_THAT(body.points("outline"), ElementsAre(ElementsAre(0, 0), ElementsAre(1e-3, 0)));
  EXPECT_EQ(body.lines("holes").at(0).at(1).at(1), 1);
  EXPECT_EQ(body.text("value"), "3");
  EXPECT_EQ(s.at("output").integer("frames"), 20);
  EXPECT_DOUBLE_EQ(s.find("material", "granite")->number("angle"), 30 * M_PI / 180);
}

TEST(CoreSchema, TheWantedMessage) {
  EXPECT_EQ(refusal(head + "[material.granite]\ndensty = 2650\n"),
            "s.toml:5: material.granite.densty: no such key. Did you mean 'density' [kg/m3]?\n"
            "  keys here: angle [rad], density [kg/m3], share\n"
            "  docs/input.md#materialname  (or: breccia help material)\n"
            "s.toml:4: material.granite.density: is missing (density)\n"
            "  for example: density = \"2650 kg/m3\"\n"
            "  docs/input.md#materialname  (or: breccia help material.density)");
}

TEST(CoreSchema, AllErrorsOfASceneAreToldAtOnce) {
  EXPECT_THAT(refusal("[run]\ndimension = 5\nduration = \"1 mm\"\nx = 1\n[nonsense]\n"),
              AllOf(HasSubstr("s.toml:2: run.dimension: 5 is out of range; allowed: from 2 to 3"),
                    HasSubstr("s.toml:3: run.duration: \"1 mm\" is a length; a time"),
                    HasSubstr("s.toml:4: run.x: no such key"),
                    HasSubstr("s.toml:5: nonsense: no such key")));
}

TEST(CoreSchema, UnitsAndRanges) {
  const auto density = [](const std::string& value) {
    return refusal(head + "[material.granite]\ndensity = " + value + "\n");
  };
  EXPECT_THAT(density("\"2650\""),
              AllOf(HasSubstr("\"2650\" has no unit; a density"), HasSubstr("taken in kg/m3")));
  EXPECT_THAT(density("\"3 GPa\""), HasSubstr("is a pressure; a density, e.g. \"2650 kg/m3\""));
  EXPECT_THAT(density("\"3 kg/mm\""), HasSubstr("is a quantity in kg.m^-1; a density"));
  EXPECT_THAT(density("\"3 kg/x\""), HasSubstr("no unit 'x'"));
  EXPECT_THAT(density("0"), HasSubstr("0 kg/m3 is out of range; allowed: above 0 kg/m3"));
  EXPECT_THAT(density("\"-1 g/cm3\""), HasSubstr("\"-1 g/cm3\" (-1000 kg/m3) is out of range"));
  EXPECT_THAT(density("nan"), HasSubstr("nan is not finite"));
  EXPECT_THAT(density("-inf"), HasSubstr("-inf is not finite"));
  EXPECT_THAT(density("true"), HasSubstr("expects a density, e.g. \"2650 kg/m3\", not the flag"));
  EXPECT_THAT(density("[1]"), HasSubstr("not a list"));
  const std::string text = refusal(head + granite + "angle = \"200 deg\"\nshare = \"5 deg\"\n");
  EXPECT_THAT(text, HasSubstr("allowed: from 0 deg to 85.9"));
  EXPECT_THAT(text, HasSubstr("\"5 deg\" is an angle; a pure number, e.g. 0.5, is wanted"));
}

TEST(CoreSchema, WrongKinds) {
  EXPECT_THAT(in_body("name2 = 3"), HasSubstr("Did you mean 'name'?"));
  EXPECT_THAT(in_body("material = 3"), HasSubstr("expects a text in quotes, not the number 3"));
  EXPECT_THAT(in_body("velocity = 3"), HasSubstr("expects a list, not the number 3"));
  EXPECT_THAT(in_body("corner = [1, 2, 3]"), HasSubstr("has 3 components; 2 are wanted"));
  EXPECT_THAT(in_body("velocity = [\"free\", \"free\"]"), HasSubstr("nothing is prescribed"));
  EXPECT_THAT(in_body("velocity = [\"fre\", 0]"), HasSubstr("does not begin with a number"));
  EXPECT_THAT(in_body("spin = [0, 0, 1]"), HasSubstr("expects an angular velocity"));
  EXPECT_THAT(in_body("sizes = []"), HasSubstr("0 elements; at least 1"));
  EXPECT_THAT(in_body("sizes = [1, -1]"), HasSubstr("-1 m is out of range"));
  EXPECT_THAT(in_body("cells = [1.5, 2]"), HasSubstr("expects an integer, not the number 1.5"));
  EXPECT_THAT(in_body("words = [\"u\", \"u\"]"), HasSubstr("\"u\" is named twice"));
  EXPECT_THAT(in_body("history = [[0, 1]]"), HasSubstr("1 elements; at least 2"));
  EXPECT_THAT(in_body("history = [[0, 1], [0, 2]]"), HasSubstr("row 2 begins with 0, not after 0"));
  EXPECT_THAT(in_body("history = [[0, 1], 3]"),
              HasSubstr("row 2 is not a pair [time, pure number]"));
  EXPECT_THAT(in_body("outline = [[0, 1], [2]]"), HasSubstr("has 1 components"));
  EXPECT_THAT(in_body("value = \"1 +\""), HasSubstr("column 4"));
  EXPECT_THAT(in_body("short = \"a b\""), HasSubstr("cannot be used in expressions"));
  EXPECT_THAT(in_body("short = \"1a\""), HasSubstr("a letter first"));
  EXPECT_THAT(in_body("short = \"\""), HasSubstr("the text is empty"));
  EXPECT_THAT(refusal(head + "plane = \"stres\"\n"),
              AllOf(HasSubstr("Did you mean 'stress'?"), HasSubstr("choices: strain, stress")));
  EXPECT_THAT(refusal(head + "fast = 1\n"), HasSubstr("expects true or false, not the number 1"));
}

TEST(CoreSchema, WrongSections) {
  EXPECT_THAT(refusal("title = \"x\"\n"), HasSubstr("run: the scene has no [run]"));
  EXPECT_THAT(refusal("run = 3\n"), HasSubstr("run: is a section, not the number 3"));
  EXPECT_THAT(refusal(head + "[body]\nname = \"a\"\n"), HasSubstr("write [[body]]"));
  EXPECT_THAT(refusal(head + "[material]\ndensity = 3\n"),
              AllOf(HasSubstr("material.density: stands outside a named section"),
                    HasSubstr("write [material.NAME]")));
  EXPECT_THAT(in_body("density = 3"), HasSubstr("'density' belongs in [material.NAME]"));
  EXPECT_THAT(in_body("material = \"granit\""),
              AllOf(HasSubstr("no material 'granit' in this scene. Did you mean 'granite'?"),
                    HasSubstr("material names: granite")));
  EXPECT_THAT(in_body("between = [\"granite\", \"lime\"]"), HasSubstr("no material 'lime'"));
  EXPECT_THAT(refusal(head + "[[body]]\nname = \"a\"\n[[body]]\nname = \"a\"\n"),
              HasSubstr("s.toml:7: body.name: \"a\" is used twice"));
  EXPECT_THAT(refusal(head + granite + "[interface.steel]\nG = 1\n"),
              HasSubstr("no material 'steel'"));
}

TEST(CoreSchema, Alternatives) {
  EXPECT_THAT(in_body("shape = {}"), HasSubstr("body.a.shape: needs one of disc, box, file"));
  EXPECT_THAT(in_body("shape = { file = \"x\", disc = { diameter = 1 } }"),
              HasSubstr("disc and file exclude each other"));
  EXPECT_THAT(in_body("corner = [0, 0]\ncells = [1, 2]"),
              HasSubstr("corner and cells exclude each other"));
  EXPECT_THAT(in_body("shape = { box = { size = [1, 1, 1] } }"),
              HasSubstr("body.a.shape.box: is for three dimensions; this scene has"));
}

TEST(CoreSchema, KeysOfTheOtherDimensionDoNotExist) {
  const std::string space = "[run]\ndimension = 3\nduration = 1\n";
  EXPECT_FALSE(resolved(space).at("run").has("plane"));
  EXPECT_THAT(refusal(space + "plane = \"strain\"\n"), HasSubstr("is for two dimensions"));
}

TEST(CoreSchema, RulesRunOnlyOnSoundScenes) {
  Schema schema = sample();
  schema.check([](const Settings& scene, Problems& problems) {
    problems.add(scene.at("run").error("duration", "is odd", "make it even"));
  });
  const auto text = [&](const std::string& scene) {
    return error_text([&] { (void)schema.resolve(read_scene_text(scene, "s.toml")); });
  };
  EXPECT_EQ(text(head), "s.toml:3: run.duration: is odd\n  make it even");
  EXPECT_THAT(text(head + "x = 1\n"), Not(HasSubstr("is odd")));
}

TEST(CoreSchema, HelpFindsKeysHoweverTheyAreWritten) {
  const Schema s = sample();
  for (const char* query : {"material.density", "material.granite.density", "material.*.density"}) {
    EXPECT_THAT(s.help(query), AllOf(HasSubstr("material.density\n"), HasSubstr("unit     kg/m3"),
                                     HasSubstr("range    above 0 kg/m3"),
                                     HasSubstr("example  density = \"2650 kg/m3\"")));
  }
  EXPECT_THAT(s.help("density"), HasSubstr("in [material.NAME]"));
  EXPECT_THAT(s.help("body[].shape.disc.diameter"), HasSubstr("body.shape.disc.diameter"));
  EXPECT_THAT(s.help("body.0.shape.disc"), HasSubstr("diameter"));
  EXPECT_THAT(s.help("material"), HasSubstr("switches on: solid"));
  EXPECT_THAT(s.help("[[body]]"), HasSubstr("at most one of: corner, cells"));
  EXPECT_THAT(s.help("title"), HasSubstr("kind     text"));
  EXPECT_THAT(error_text([&] { (void)s.help("material.densty"); }),
              HasSubstr("Did you mean 'material.density'?"));
  EXPECT_THAT(s.overview(), AllOf(HasSubstr("[run]"), HasSubstr("[[body]]")));
}

TEST(CoreSchema, MarkdownNamesEveryKeyAndEveryLinkHasAHeading) {
  const Schema s = sample();
  std::ostringstream out;
  s.markdown(out);
  for (const auto& section : s.sections()) {
    for (const auto& key : section.keys) EXPECT_THAT(out.str(), HasSubstr("`" + key.name + "`"));
    if (!section.pattern.empty()) {
      EXPECT_THAT(out.str(), HasSubstr("## `" + section.title() + "`\n"));
    }
  }
  EXPECT_EQ(s.find("body[].shape.disc")->anchor(), "bodyshapedisc");
}

TEST(CoreSchema, AKeyIsDeclaredOnce) {
  Schema s = sample();
  EXPECT_THROW(s.section("run").flag("fast"), std::logic_error);
  EXPECT_NO_THROW(s.section("run").flag("slow"));
}

}  // namespace
}  // namespace breccia
