#include "harness/failures.hpp"
#include "harness/temp_folder.hpp"
#include "io/aside_file.hpp"
#include "io/digest.hpp"
#include "io/json.hpp"
#include "io/number.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>

namespace breccia {
namespace {

using testing::HasSubstr;

std::string shown(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

TEST(IoNumber, ShortestTextThatReadsBack) {
  EXPECT_EQ(shown(0.1), "0.1");
  EXPECT_EQ(shown(1e6), "1000000");
  EXPECT_EQ(shown(-3), "-3");
  EXPECT_EQ(shown(1e-6), "1e-06");
  EXPECT_EQ(shown(1e300), "1e+300");
  EXPECT_EQ(shown(-0.0), "-0");
  EXPECT_EQ(shown(-std::nan("")), "nan");
  EXPECT_EQ(shown(-std::numeric_limits<double>::infinity()), "-inf");
}

TEST(IoNumber, AnyDoubleReadsBackExactly) {
  std::mt19937_64 random(3);
  for (int k = 0; k < 20000; ++k) {
    const auto value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    EXPECT_EQ(std::bit_cast<std::uint64_t>(std::strtod(shown(value).c_str(), nullptr)),
              std::bit_cast<std::uint64_t>(value));
  }
}

TEST(IoDigest, DependsOnEveryBitAndNotOnThePieces) {
  std::string text(1000, 'a');
  for (std::size_t k = 0; k < text.size(); ++k) text[k] = static_cast<char>(k * 37);
  std::set<std::uint64_t> seen;
  const auto digest_of = [](std::string_view all, std::size_t piece) {
    Digest digest;
    for (std::size_t at = 0; at < all.size(); at += piece) digest.update(all.substr(at, piece));
    return digest.value();
  };
  const std::uint64_t whole = digest_of(text, 1000);
  for (const std::size_t piece : {1u, 7u, 32u, 33u, 999u}) EXPECT_EQ(digest_of(text, piece), whole);
  seen.insert(whole);
  for (std::size_t bit = 0; bit < 8 * text.size(); ++bit) {
    std::string changed = text;
    changed[bit / 8] = static_cast<char>(changed[bit / 8] ^ (1 << bit % 8));
    EXPECT_TRUE(seen.insert(digest_of(changed, 1000)).second) << bit;
  }
  // Zeros at the end count, although blocks are filled up with zeros.
  EXPECT_NE(fingerprint(std::string(8, '\0')), fingerprint(std::string(9, '\0')));
  EXPECT_EQ(fingerprint("granite").size(), 16u);
}

TEST(IoJson, OrderNestingAndNumbers) {
  JsonWriter json;
  json.begin_object().member("b", 1).member("a", 0.5).key("list").begin_array();
  json.value(true).null().value("x\"\\\n\x01").end_array();
  json.key("empty").begin_object().end_object().member("bad", std::nan("")).end_object();
  EXPECT_EQ(json.text(),
            "{\n  \"b\": 1,\n  \"a\": 0.5,\n  \"list\": [\n    true,\n    null,\n"
            "    \"x\\\"\\\\\\n\\u0001\"\n  ],\n  \"empty\": {},\n  \"bad\": null\n}\n");
}

TEST(IoJson, WrongNestingIsRefused) {
  JsonWriter open;
  open.begin_object();
  EXPECT_THROW((void)open.text(), std::logic_error);
  EXPECT_THROW(open.value(1), std::logic_error);
  EXPECT_THROW(open.end_array(), std::logic_error);
  JsonWriter list;
  list.begin_array();
  EXPECT_THROW(list.key("a"), std::logic_error);
}

TEST(IoAside, ReplacesWholeFilesOnly) {
  TempFolder folder;
  const std::string path = folder / "a.txt";
  write_whole(path, "old");
  EXPECT_TRUE(killed_after([&] {
    AsideFile aside(path);
    aside.write("new and longer");
    aside.sync();
    kill(getpid(), SIGKILL);
  }));
  EXPECT_EQ(file_text(path), "old");
  EXPECT_EQ(file_text(path + ".part"), "new and longer");
  write_whole(path, "newer");
  EXPECT_EQ(file_text(path), "newer");
  EXPECT_EQ(folder.entries(), 1u);
}

TEST(IoAside, FailuresNameFileCauseAndRemedy) {
  TempFolder folder;
  const std::string path = folder / "a.txt";
  put_text(path, "old");
  std::filesystem::create_symlink("/dev/full", path + ".part");
  EXPECT_THAT(error_text([&] { write_whole(path, "new"); }),
              AllOf(HasSubstr(path), HasSubstr("the disk is full"), HasSubstr("--output")));
  EXPECT_EQ(file_text(path), "old");
  EXPECT_EQ(folder.entries(), 1u);
  EXPECT_THAT(error_text([&] { write_whole(folder / "none/a.txt", "new"); }),
              HasSubstr("No such file or directory"));
  EXPECT_THAT(error_text([&] { write_whole(path + "/b.txt", "new"); }),
              HasSubstr("is a file, not a folder"));
}

}  // namespace
}  // namespace breccia
