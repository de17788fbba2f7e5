#include "core/error.hpp"
#include "harness/failures.hpp"
#include "harness/temp_folder.hpp"
#include "io/json.hpp"
#include "io/json_reader.hpp"
#include "io/number_table.hpp"

#include <cmath>

namespace breccia {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

TEST(IoJsonReader, ReadsWhatTheWriterWrites) {
  JsonWriter json;
  json.begin_object().member("text", "a \"b\"\n\\ \x01 µ").member("number", -1.25e-3);
  json.member("flag", true).member("none", std::nan("")).key("list").begin_array();
  json.value(1).value(2).end_array().key("empty").begin_object().end_object().end_object();
  const Json read = parse_json(json.text(), "x");
  EXPECT_EQ(read["text"].text(), "a \"b\"\n\\ \x01 µ");
  EXPECT_EQ(read["number"].number(), -1.25e-3);
  EXPECT_TRUE(read["flag"].flag());
  EXPECT_TRUE(std::isnan(read["none"].number()));
  ASSERT_EQ(read["list"].array().size(), 2u);
  EXPECT_EQ(read["list"].array()[1].number(), 2);
  EXPECT_TRUE(read["empty"].object().empty());
  EXPECT_TRUE(std::isnan(read["not"]["there"].number()));
}

TEST(IoJsonReader, RefusesWhatIsNotJson) {
  for (const char* text :
       {"", "{", "[1,]", "{\"a\" 1}", "{\"a\": }", "\"x", "\"\\q\"", "1 2", "nil"})
    EXPECT_THROW(parse_json(text, "x"), Error) << text;
  EXPECT_THROW(parse_json(std::string(1000, '['), "x"), Error);
  EXPECT_EQ(parse_json("\"\\u00b5\"", "x").text(), "µ");
}

std::string trouble_with(const std::string& text) {
  const TempFolder folder;
  put_text(folder / "t.csv", text);
  try {
    read_number_table(folder / "t.csv");
  } catch (const Error& e) {
    return std::string(e.what()).substr(folder.path().size() + 1);
  }
  return "nothing";
}

TEST(IoNumberTable, NamesAreOptional) {
  const TempFolder folder;
  put_text(folder / "a.csv", "# made by hand\ntime, load.y\n0, 1\n\n0.5, -2e3\n");
  const NumberTable named = read_number_table(folder / "a.csv");
  EXPECT_THAT(named.columns, ElementsAre("time", "load.y"));
  EXPECT_THAT(named.rows, ElementsAre(ElementsAre(0, 1), ElementsAre(0.5, -2000)));
  put_text(folder / "b.csv", "+1,2\n");
  EXPECT_TRUE(read_number_table(folder / "b.csv").columns.empty());
}

TEST(IoNumberTable, RefusesWithTheLine) {
  EXPECT_THAT(trouble_with("x,y\n1,2\n1,2 mm\n"), StartsWith("t.csv:3: '2 mm' is not a number"));
  EXPECT_THAT(trouble_with("1,2\n1\n"),
              StartsWith("t.csv:2: the row has 1 numbers, the first has 2"));
  EXPECT_THAT(trouble_with("x,y\n"), HasSubstr("no rows"));
}

}  // namespace
}  // namespace breccia
