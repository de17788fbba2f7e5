#include "harness/failures.hpp"
#include "harness/temp_folder.hpp"
#include "io/scene_reader.hpp"

namespace breccia {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

std::vector<std::string> keys(const Config& table) {
  std::vector<std::string> names;
  for (const auto& entry : table.table()) names.push_back(entry.first);
  return names;
}

const std::string scene = R"(title = "x"
[zebra]
b = 1
a = { c = 2.5, d = [true,
  3] }
[[body]]
name = "disc"
[[body]]
name = "upper platen"
mesh.size = 3
[alpha]
)";

TEST(IoSceneReader, KeepsOrderKindsAndLines) {
  const Config c = read_scene_text(scene, "s.toml");
  EXPECT_THAT(keys(c), ElementsAre("title", "zebra", "body", "alpha"));
  const Config* zebra = c.find("zebra");
  EXPECT_THAT(keys(*zebra), ElementsAre("b", "a"));
  EXPECT_EQ(zebra->find("b")->integer(), 1);
  EXPECT_EQ(zebra->find("a")->find("c")->real(), 2.5);
  const auto& list = zebra->find("a")->find("d")->array();
  EXPECT_TRUE(list[0].boolean());
  EXPECT_EQ(list[1].place().text(), "s.toml:5");
  EXPECT_EQ(c.find("body")->array()[1].place().text(), "s.toml:8");
  EXPECT_EQ(c.find("body")->array()[1].find("mesh")->find("size")->place().line, 10);
  EXPECT_TRUE(c.find("alpha")->table().empty());
}

TEST(IoSceneReader, OptionsReplaceAndAdd) {
  const Config c = read_scene_text(
      scene, "s.toml",
      {"zebra.b=2 ms", "zebra.new.deep=[1, 2]", "body.disc.mesh.size=0.5", "body.1.x=true",
       "body.\"upper platen\".mesh.size='a b'", "zebra.a.d.0=strain"});
  EXPECT_EQ(c.find("zebra")->find("b")->text(), "2 ms");
  EXPECT_EQ(c.find("zebra")->find("b")->place().text(), "--set");
  EXPECT_EQ(c.find("zebra")->find("new")->find("deep")->array()[1].integer(), 2);
  const auto& bodies = c.find("body")->array();
  EXPECT_EQ(bodies[0].find("mesh")->find("size")->real(), 0.5);
  EXPECT_TRUE(bodies[1].find("x")->boolean());
  EXPECT_EQ(bodies[1].find("mesh")->find("size")->text(), "a b");
  EXPECT_EQ(c.find("zebra")->find("a")->find("d")->array()[0].text(), "strain");
}

TEST(IoSceneReader, WrongOptionsAreNamed) {
  const auto text = [](const char* o) {
    return error_text([o] { read_scene_text(scene, "s.toml", {o}); });
  };
  EXPECT_THAT(text("zebra"), AllOf(StartsWith("--set: "), HasSubstr("is not key=value")));
  EXPECT_THAT(text("=3"), HasSubstr("is not key=value"));
  EXPECT_THAT(text("a="), HasSubstr("is not key=value"));
  EXPECT_THAT(text("a..b=3"), HasSubstr("is not a path of keys"));
  EXPECT_THAT(text("body.disk.x=3"), AllOf(HasSubstr("no element 'disk'. Did you mean 'disc'?"),
                                           HasSubstr("elements: disc, upper platen")));
  EXPECT_THAT(text("body.2.x=3"), HasSubstr("no element '2'"));
  EXPECT_THAT(text("title.x=3"), HasSubstr("there is the text \"x\" above it"));
}

TEST(IoSceneReader, BrokenFilesAreShown) {
  const auto text = [](const std::string& t) {
    return error_text([&t] { read_scene_text(t, "s.toml"); });
  };
  EXPECT_THAT(text("a = 1\nb = = 2\n"), StartsWith("s.toml:2: this is not TOML"));
  EXPECT_THAT(text("a = 1\na = 2\n"), HasSubstr("already exists"));
  EXPECT_THAT(text("a = 3 mm\n"), HasSubstr("in quotes: \"3 mm\""));
  EXPECT_THAT(text("[run\n"), StartsWith("s.toml:1: this is not TOML"));
  EXPECT_THAT(text("a = 2020-01-01\n"), HasSubstr("dates and times have no meaning"));
  EXPECT_THAT(text("a = 1e400\n"), StartsWith("s.toml:1: the number is too large"));
  EXPECT_THAT(text("a = 99999999999999999999\n"), HasSubstr("the number is too large"));
  EXPECT_THAT(text(std::string("a = 1\n\0", 7)), HasSubstr("not a text file"));
  EXPECT_THAT(text("a = \"\xff\"\n"), StartsWith("s.toml:1: this is not TOML"));
  EXPECT_TRUE(read_scene_text("", "s.toml").table().empty());
  EXPECT_TRUE(read_scene_text("# only a remark\n", "s.toml").table().empty());
}

TEST(IoSceneReader, FindsTheSceneInAFolder) {
  TempFolder folder;
  EXPECT_THAT(error_text([&] { find_scene_file(folder.path()); }),
              HasSubstr("the folder holds no scene.toml"));
  put_text(folder / "scene.toml", "a = 1\n");
  EXPECT_EQ(find_scene_file(folder.path()), folder / "scene.toml");
  EXPECT_EQ(find_scene_file(folder / "scene.toml"), folder / "scene.toml");
  EXPECT_THAT(error_text([&] { find_scene_file(folder / "scene"); }),
              HasSubstr("Did you mean '" + (folder / "scene.toml") + "'?"));
  EXPECT_THAT(error_text([&] { find_scene_file(folder / "other"); }), HasSubstr("no such scene"));
}

TEST(IoSceneReader, UnreadableFileIsRefused) {
  TempFolder folder;
  put_text(folder / "scene.toml", "a = 1\n");
  std::filesystem::permissions(folder / "scene.toml", std::filesystem::perms::none);
  std::filesystem::permissions(folder.path(), std::filesystem::perms::all);
  const NoRights nobody;
  EXPECT_THAT(error_text([&] { read_scene(folder / "scene.toml"); }), HasSubstr("cannot be read"));
}

}  // namespace
}  // namespace breccia
