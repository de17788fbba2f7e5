#include "core/key_value.hpp"
#include "core/schema.hpp"
#include "harness/failures.hpp"
#include "harness/temp_folder.hpp"
#include "io/scene_reader.hpp"
#include "scene/commands.hpp"

#include <sstream>

namespace breccia {
namespace {

using testing::HasSubstr;

/// The table of keys of this build.
const Schema& keys() {
  static const Schema schema = [] {
    Schema s;
    declare_schema(s);
    return s;
  }();
  return schema;
}

/// Whether the text after "key = " is a right value of the key in `dimensions` dimensions.
bool reads(const Key& key, const std::string& line, int dimensions) {
  const Config written = read_scene_text(line + "\n", "example");
  try {
    read_key_value(key, *written.find(key.name), dimensions);
    return true;
  } catch (const Error&) {
    return false;
  }
}

template <class Action>
void for_each_key(const Action& action) {
  for (const Section& section : keys().sections()) {
    for (const Key& key : section.keys) action(section, key);
  }
}

TEST(SceneKeys, EveryDefaultIsARightValue) {
  for_each_key([](const Section& section, const Key& key) {
    if (!key.default_value) return;
    EXPECT_NO_THROW(read_key_value(key, *key.default_value, 2))
        << section.pattern << " " << key.name;
  });
}

TEST(SceneKeys, EveryExampleIsARightValue) {
  for_each_key([](const Section& section, const Key& key) {
    const std::string line = key.example_text();
    if (line.empty()) return;
    EXPECT_TRUE(reads(key, line, 2) || reads(key, line, 3)) << section.pattern << ": " << line;
  });
}

TEST(SceneKeys, EveryKeyAndSectionIsExplained) {
  for_each_key([](const Section& section, const Key& key) {
    EXPECT_FALSE(key.doc.empty()) << section.pattern << " " << key.name;
    EXPECT_FALSE(key.required && key.default_value) << section.pattern << " " << key.name;
    EXPECT_FALSE(key.required && key.example.empty()) << section.pattern << " " << key.name;
  });
  for (const Section& section : keys().sections()) {
    EXPECT_FALSE(section.doc.empty()) << section.pattern;
  }
}

TEST(SceneKeys, NamesInRulesExist) {
  for (const Section& section : keys().sections()) {
    std::vector<std::vector<std::string>> groups = section.exactly_one;
    groups.insert(groups.end(), section.at_most_one.begin(), section.at_most_one.end());
    for (const auto& group : groups) {
      for (const std::string& word : group) {
        bool found = section.key(word) != nullptr;
        for (const Section* inner : keys().inside(section)) found = found || inner->local == word;
        EXPECT_TRUE(found) << section.pattern << " " << word;
      }
    }
  }
}

TEST(SceneKeys, HelpKnowsEveryKey) {
  for_each_key([](const Section& section, const Key& key) {
    const std::string path = section.path() + (section.pattern.empty() ? "" : ".") + key.name;
    EXPECT_THAT(keys().help(path), HasSubstr(path + "\n")) << path;
  });
}

TEST(SceneKeys, TheManualIsUpToDate) {
  std::stringstream page;
  keys().markdown(page);
  std::istringstream written(file_text(BRECCIA_SOURCE_DIR "/docs/input.md"));
  std::string is, should;
  for (int line = 1; std::getline(page, should); ++line) {
    std::getline(written, is);
    ASSERT_EQ(is, should) << "docs/input.md:" << line
                          << ": write it anew by breccia help --markdown > docs/input.md";
  }
  EXPECT_FALSE(std::getline(written, is)) << "docs/input.md is too long";
}

}  // namespace
}  // namespace breccia
