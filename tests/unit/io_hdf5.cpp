#include "harness/failures.hpp"
#include "harness/temp_folder.hpp"
#include "io/hdf5_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <limits>
#include <random>

namespace breccia {
namespace {

using testing::HasSubstr;

constexpr double kInf = std::numeric_limits<double>::infinity();

template <class T>
std::vector<T> random_bits(std::size_t count) {
  std::mt19937_64 random(7);
  std::vector<T> values(count);
  for (T& value : values) {
    const std::uint64_t bits = random();
    std::memcpy(&value, &bits, sizeof(T));
  }
  return values;
}

template <class T>
void expect_same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(T)), 0);
}

template <class T>
class IoHdf5Types : public testing::Test {};
using Types =
    testing::Types<double, float, std::int32_t, std::int64_t, std::uint8_t, std::uint64_t>;
TYPED_TEST_SUITE(IoHdf5Types, Types);

TYPED_TEST(IoHdf5Types, EveryBitComesBack) {
  TempFolder folder;
  const std::string path = folder / "a.h5";
  const auto values =
      random_bits<TypeParam>(3 * 1000);  // not-a-numbers with any payload among them
  H5Writer writer(path);
  writer.write("group/values", view_of(values, {1000, 3}));
  writer.write("group/packed", view_of(values, {1000, 3}), {.deflate = 4});
  writer.commit();

  const H5Reader reader(path);
  EXPECT_EQ(reader.info("group/values").shape, (std::vector<std::size_t>{1000, 3}));
  EXPECT_EQ(reader.info("group/values").type, data_type_of<TypeParam>());
  expect_same_bits(reader.template read<TypeParam>("group/values"), values);
  expect_same_bits(reader.template read<TypeParam>("group/packed"), values);
}

TEST(IoHdf5, TextsAttributesAndNames) {
  TempFolder folder;
  const std::string path = folder / "a.h5";
  H5Writer writer(path);
  writer.group("b");
  writer.write_text("b/text", "Kluft\n\"§\"");
  writer.write_text("b/nothing", "");
  writer.write("b/empty", view_of(std::vector<double>()));
  writer.attribute("b", "words", std::string_view("two words"));
  writer.attribute("b/empty", "numbers", std::array<std::int64_t, 2>{-1, 1});
  writer.attribute("", "limit", -kInf);
  writer.commit();

  const H5Reader reader(path);
  EXPECT_EQ(reader.names("b"), (std::vector<std::string>{"empty", "nothing", "text"}));
  EXPECT_EQ(reader.read_text("b/text"), "Kluft\n\"§\"");
  EXPECT_EQ(reader.read_text("b/nothing"), "");
  EXPECT_TRUE(reader.read<double>("b/empty").empty());
  EXPECT_EQ(reader.text_attribute("b", "words"), "two words");
  EXPECT_EQ(reader.integer_attribute("b/empty", "numbers"), (std::vector<std::int64_t>{-1, 1}));
  EXPECT_EQ(reader.real_attribute("", "limit"), -kInf);
  EXPECT_TRUE(reader.has("b/text"));
  EXPECT_FALSE(reader.has("b/none"));
  EXPECT_FALSE(reader.has("c/none/at/all"));
  EXPECT_TRUE(reader.has_attribute("b", "words"));
  EXPECT_FALSE(reader.has_attribute("b", "none"));
}

TEST(IoHdf5, CompressionIsOffUnlessAsked) {
  TempFolder folder;
  const std::vector<double> zeros(100000, 0.0);
  H5Writer plain(folder / "plain.h5"), packed(folder / "packed.h5");
  plain.write("zeros", view_of(zeros));
  packed.write("zeros", view_of(zeros), {.deflate = 1});
  plain.commit();
  packed.commit();
  EXPECT_GE(std::filesystem::file_size(folder / "plain.h5"), 800000u);
  EXPECT_LT(std::filesystem::file_size(folder / "packed.h5"), 20000u);
}

TEST(IoHdf5, ReaderNamesWhatIsWrong) {
  TempFolder folder;
  const std::string path = folder / "a.h5";
  EXPECT_THAT(error_text([&] { H5Reader reader(path); }),
              AllOf(HasSubstr(path), HasSubstr("No such file")));

  put_text(path, "not HDF5 at all, but long enough to look at: a text of some length");
  EXPECT_THAT(error_text([&] { H5Reader reader(path); }),
              AllOf(HasSubstr(path), HasSubstr("no HDF5 file")));

  H5Writer writer(path);
  writer.write("values", view_of(std::vector<double>(1000, 1.5)));
  writer.write_text("text", "word");
  writer.commit();
  const H5Reader reader(path);
  EXPECT_THAT(error_text([&] { (void)reader.read<double>("none"); }),
              HasSubstr("no data set 'none'"));
  EXPECT_THAT(error_text([&] { (void)reader.read<float>("values"); }),
              HasSubstr("'values' holds float64, not float32"));
  EXPECT_THAT(error_text([&] { (void)reader.info("text"); }), HasSubstr("does not hold numbers"));
  EXPECT_THAT(error_text([&] { (void)reader.read_text("values"); }), HasSubstr("not a text"));
  EXPECT_THAT(error_text([&] { (void)reader.real_attribute("values", "x"); }),
              HasSubstr("no attribute 'x'"));
}

TEST(IoHdf5, TruncatedFileIsCalledThat) {
  TempFolder folder;
  const std::string path = folder / "a.h5";
  H5Writer writer(path);
  writer.write("values", view_of(std::vector<double>(1000, 1.5)));
  writer.commit();
  std::filesystem::resize_file(path, 5000);
  EXPECT_THAT(error_text([&] { H5Reader reader(path); }),
              AllOf(HasSubstr(path), HasSubstr("truncated")));
}

TEST(IoHdf5, NothingAppearsBeforeCommit) {
  TempFolder folder;
  const std::string path = folder / "a.h5";
  put_text(path, "old");
  {
    H5Writer writer(path);
    writer.write("values", view_of(std::vector<double>(1000, 1.5)));
    writer.seal();
    EXPECT_EQ(file_text(path), "old");
  }
  EXPECT_EQ(file_text(path), "old");
  EXPECT_EQ(folder.entries(), 1u) << "the part of a dropped file stays behind";
}

void write_sample(const std::string& path) {
  H5Writer writer(path);
  for (int k = 0; k < 20; ++k) {
    const std::string name = "group/values" + std::to_string(k);
    writer.write(name, view_of(std::vector<double>(500, 1.5)));
    writer.attribute(name, "unit", std::string_view("m/s"));
  }
  writer.commit();
}

TEST(IoHdf5, FullDiskIsCalledThatAndKeepsTheOldFile) {
  TempFolder folder;
  const std::string path = folder / "a.h5";
  put_text(path, "old");
  std::filesystem::create_symlink("/dev/full", path + ".part");  // every write there finds no space
  EXPECT_THAT(error_text([&] { write_sample(path); }),
              AllOf(HasSubstr(path), HasSubstr("the disk is full")));
  EXPECT_EQ(file_text(path), "old");
  EXPECT_EQ(folder.entries(), 1u);
}

// The disk may fill up at any moment: in the middle of a data set, in the metadata, at the last
// flush.
TEST(IoHdf5, DiskThatFillsAtAnyMomentLeavesTheOldFileAndAUsableLibrary) {
  TempFolder folder;
  const std::string path = folder / "a.h5";
  write_sample(folder / "whole.h5");
  const auto size = std::filesystem::file_size(folder / "whole.h5");
  put_text(path, "old");
  for (std::uintmax_t limit = 0; limit < size; limit += 777) {
    {
      const FileSizeLimit full(limit);
      EXPECT_THAT(error_text([&] { write_sample(path); }), HasSubstr(path)) << limit;
    }
    ASSERT_EQ(file_text(path), "old") << limit;
    ASSERT_FALSE(std::filesystem::exists(path + ".part")) << limit;
  }
  write_sample(path);
  EXPECT_EQ(file_text(path), file_text(folder / "whole.h5"));
}

TEST(IoHdf5, FullDiskDoesNotHauntTheEndOfTheProgram) {
  TempFolder folder;
  const std::string path = folder / "a.h5";
  for (const rlim_t limit : {0, 100, 3000, 20000, 90000}) {
    const auto fail_and_leave = [&] {
      const FileSizeLimit full(limit);
      error_text([&] { write_sample(path); });
      std::exit(0);  // HDF5 tidies up here
    };
    EXPECT_EXIT(fail_and_leave(), testing::ExitedWithCode(0), "") << limit;
  }
}

TEST(IoHdf5, UnwritableFolderIsCalledThat) {
  TempFolder folder;
  const NoRights rights;
  EXPECT_THAT(error_text([&] { H5Writer writer("/proc/a.h5"); }), HasSubstr("/proc/a.h5"));
  EXPECT_THAT(error_text([&] { H5Writer writer("/usr/a.h5"); }),
              AllOf(HasSubstr("/usr/a.h5"), HasSubstr("Permission denied"), HasSubstr("--output")));
}

}  // namespace
}  // namespace breccia
