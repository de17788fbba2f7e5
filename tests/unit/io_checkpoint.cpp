#include "harness/failures.hpp"
#include "harness/temp_folder.hpp"
#include "io/checkpoint.hpp"
#include "io/digest.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <thread>

namespace breccia {
namespace {

using testing::HasSubstr;

const CheckpointIdentity kIdentity = {"scene-1", "build-1"};

std::vector<double> positions(double shift) {
  std::vector<double> x(300);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = shift + std::sin(static_cast<double>(i));
  x[7] = -0.0;
  x[8] = std::numeric_limits<double>::denorm_min();
  return x;
}

void fill(CheckpointWriter& writer, double shift) {
  writer.put("position", positions(shift), {100, 3});
  writer.put("label", std::vector<std::int32_t>{3, -1, 2});
  writer.put("flag", std::vector<std::uint8_t>{0, 1, 255});
  writer.put("seed", std::array<std::uint64_t, 1>{~std::uint64_t{0}});
  writer.put("empty", std::vector<float>());
  writer.put_number("time", shift / 3);
  writer.put_number("step", std::int64_t{1} << 60);
  writer.put_text("note", "first\nsecond");
}

std::string write_sample(const std::string& path, double shift = 1) {
  CheckpointWriter writer(path, kIdentity);
  fill(writer, shift);
  writer.commit();
  return file_text(path);
}

std::string refusal(const std::string& path, const CheckpointIdentity& expected = kIdentity) {
  const std::string text = error_text([&] { CheckpointReader reader(path, expected); });
  EXPECT_THAT(text, HasSubstr(path));
  EXPECT_THAT(text, HasSubstr("--overwrite")) << "a refusal without a remedy";
  return text;
}

TEST(IoCheckpoint, EveryBitComesBack) {
  TempFolder folder;
  const std::string path = folder / "checkpoint.h5";
  write_sample(path);
  const CheckpointReader reader(path, kIdentity);
  const auto x = reader.array<double>("position"), expected = positions(1);
  ASSERT_EQ(x.size(), expected.size());
  EXPECT_EQ(std::memcmp(x.data(), expected.data(), x.size() * sizeof(double)), 0);
  EXPECT_EQ(reader.info("position").shape, (std::vector<std::size_t>{100, 3}));
  EXPECT_EQ(reader.array<std::int32_t>("label"), (std::vector<std::int32_t>{3, -1, 2}));
  EXPECT_EQ(reader.array<std::uint8_t>("flag"), (std::vector<std::uint8_t>{0, 1, 255}));
  EXPECT_EQ(reader.array<std::uint64_t>("seed").front(), ~std::uint64_t{0});
  EXPECT_TRUE(reader.array<float>("empty").empty());
  EXPECT_EQ(reader.real("time"), 1.0 / 3);
  EXPECT_EQ(reader.integer("step"), std::int64_t{1} << 60);
  EXPECT_EQ(reader.text("note"), "first\nsecond");
  EXPECT_TRUE(reader.has("note"));
  EXPECT_FALSE(reader.has("absent"));
  EXPECT_EQ(reader.names().size(), 8u);
}

TEST(IoCheckpoint, SameStateGivesTheSameFile) {
  TempFolder folder;
  const std::string first = write_sample(folder / "a.h5");
  // HDF5 would note the second in which a data set was made.
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  EXPECT_TRUE(write_sample(folder / "b.h5") == first);
}

TEST(IoCheckpoint, TruncatedAtAnyLength) {
  TempFolder folder;
  const std::string path = folder / "checkpoint.h5", whole = write_sample(path);
  for (std::size_t length = 0; length < whole.size(); length += length < 600 ? 37 : 211) {
    put_text(path, whole.substr(0, length));
    EXPECT_THAT(refusal(path), HasSubstr("truncated")) << length;
  }
  put_text(path, whole.substr(0, whole.size() - 1));
  EXPECT_THAT(refusal(path), HasSubstr("truncated"));
}

TEST(IoCheckpoint, AnyFlippedByteIsFound) {
  TempFolder folder;
  const std::string path = folder / "checkpoint.h5", whole = write_sample(path);
  for (std::size_t at = 0; at < whole.size(); at += at < 512 ? 1 : 13) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x20);
    put_text(path, damaged);
    EXPECT_THAT(refusal(path), testing::AnyOf(HasSubstr("damaged"), HasSubstr("not a checkpoint")))
        << at;
  }
  put_text(path, whole + "x");
  EXPECT_THAT(refusal(path), HasSubstr("longer than it was written"));
}

TEST(IoCheckpoint, ForeignFilesAreRefused) {
  TempFolder folder;
  const std::string path = folder / "checkpoint.h5";
  write_sample(path);
  EXPECT_THAT(refusal(path, {"scene-2", "build-1"}),
              AllOf(HasSubstr("another scene"), HasSubstr("scene-2")));
  EXPECT_THAT(refusal(path, {"scene-1", "build-2"}),
              AllOf(HasSubstr("another build"), HasSubstr("build-2")));
  put_text(path, std::string(2000, 'x'));
  EXPECT_THAT(refusal(path), HasSubstr("not a checkpoint of Breccia"));
  EXPECT_THAT(error_text([&] { CheckpointReader reader(folder / "none", kIdentity); }),
              HasSubstr("No such file"));
}

TEST(IoCheckpoint, NewerFormatIsRefused) {
  TempFolder folder;
  const std::string path = folder / "checkpoint.h5";
  std::string content = write_sample(path);
  std::string header = content.substr(0, content.find("header "));
  header.replace(header.find("format 1"), 8, "format 2");
  header += "header " + fingerprint(header) + "\n";
  header.resize(512, '\0');
  put_text(path, header + content.substr(512));
  EXPECT_THAT(refusal(path), AllOf(HasSubstr("newer version"), HasSubstr("format 2")));
}

TEST(IoCheckpoint, WrongNamesTypesAndSizesAreErrors) {
  TempFolder folder;
  const std::string path = folder / "checkpoint.h5";
  write_sample(path);
  const CheckpointReader reader(path, kIdentity);
  std::array<double, 5> five;
  EXPECT_THAT(error_text([&] { reader.array("position", std::span<double>(five)); }),
              HasSubstr("'position' has 300 values, 5 are expected"));
  EXPECT_THAT(error_text([&] { (void)reader.array<double>("label"); }),
              HasSubstr("int32, not float64"));
  EXPECT_THAT(error_text([&] { (void)reader.real("absent"); }), HasSubstr("absent"));
}

TEST(IoCheckpoint, KillBetweenWritingAndRenamingLeavesTheOldOne) {
  TempFolder folder;
  const std::string path = folder / "checkpoint.h5", old = write_sample(path, 1);
  EXPECT_TRUE(killed_after([&] {
    auto* writer = new CheckpointWriter(path, kIdentity);  // the kill must not meet a destructor
    fill(*writer, 2);
    writer->seal();
  }));
  EXPECT_TRUE(std::filesystem::exists(path + ".part"))
      << "the child did not get as far as it should";
  EXPECT_EQ(file_text(path), old);
  EXPECT_EQ(CheckpointReader(path, kIdentity).real("time"), 1.0 / 3);
  write_sample(path, 3);  // the part that stayed behind is in nobody's way
  EXPECT_EQ(CheckpointReader(path, kIdentity).real("time"), 1.0);
  EXPECT_EQ(folder.entries(), 1u);
}

TEST(IoCheckpoint, FullDiskKeepsTheOldOne) {
  TempFolder folder;
  const std::string path = folder / "checkpoint.h5", old = write_sample(path, 1);
  for (std::size_t limit = 100; limit < old.size(); limit += 500) {
    const FileSizeLimit full(limit);
    EXPECT_THAT(error_text([&] { write_sample(path, 2); }), HasSubstr(path)) << limit;
  }
  EXPECT_EQ(file_text(path), old);
  EXPECT_EQ(folder.entries(), 1u);
}

}  // namespace
}  // namespace breccia
