#include "harness/failures.hpp"
#include "harness/temp_folder.hpp"
#include "io/frame_series.hpp"
#include "io/hdf5_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

namespace breccia {
namespace {

using testing::HasSubstr;

// Two triangles of a unit square, moved by `shift`; what a Frame borrows.
struct Square {
  explicit Square(double shift) : points{0, 0, 1 + shift, 0, 1 + shift, 1, 0, 1} {}

  Frame frame(double time) const {
    Frame frame;
    frame.dimension = 2;
    frame.points = points;
    frame.cell = CellType::triangle;
    frame.connectivity = connectivity;
    frame.point_arrays = {{"velocity", "m/s", 2, std::span<const double>(velocity)}};
    frame.cell_arrays = {{"body", "1", 1, std::span<const std::int32_t>(body)},
                         {"stress", "Pa", 6, std::span<const float>(stress)}};
    frame.time = time;
    frame.step = 3;
    return frame;
  }
  CrackFrame cracks() const { return {2, points, crack, one, one, one, one, status, one, one}; }
  std::vector<SideFrame> sides() const { return {{SideKind::cracks, as_frame(cracks(), 0, 0)}}; }

  std::vector<double> points;
  std::vector<std::int32_t> connectivity = {0, 1, 2, 0, 2, 3};
  std::vector<double> velocity = {1, 2, 3, 4, 5, 6, 7, 8};
  std::vector<std::int32_t> body = {0, 1};
  std::vector<float> stress = std::vector<float>(12, 2.5f);
  std::vector<std::int32_t> crack = {0, 2}, status = {2};
  std::vector<double> one = {1};
};

TEST(IoFrames, LayoutIsTheOneOfVtkHdf) {
  TempFolder folder;
  const Square square(0);
  write_frame(folder / "a.vtkhdf", square.frame(0.5));
  const H5Reader file(folder / "a.vtkhdf");
  EXPECT_EQ(file.text_attribute("VTKHDF", "Type"), "UnstructuredGrid");
  EXPECT_EQ(file.integer_attribute("VTKHDF", "Version"), (std::vector<std::int64_t>{1, 0}));
  EXPECT_EQ(file.read<std::int64_t>("VTKHDF/NumberOfPoints"), (std::vector<std::int64_t>{4}));
  EXPECT_EQ(file.read<std::int64_t>("VTKHDF/NumberOfCells"), (std::vector<std::int64_t>{2}));
  EXPECT_EQ(file.read<std::int64_t>("VTKHDF/NumberOfConnectivityIds"),
            (std::vector<std::int64_t>{6}));
  EXPECT_EQ(file.read<double>("VTKHDF/Points"),
            (std::vector<double>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}));
  EXPECT_EQ(file.info("VTKHDF/Points").shape, (std::vector<std::size_t>{4, 3}));
  EXPECT_EQ(file.read<std::int64_t>("VTKHDF/Connectivity"),
            (std::vector<std::int64_t>{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(file.read<std::int64_t>("VTKHDF/Offsets"), (std::vector<std::int64_t>{0, 3, 6}));
  EXPECT_EQ(file.read<std::uint8_t>("VTKHDF/Types"), (std::vector<std::uint8_t>{5, 5}));
  EXPECT_EQ(file.read<double>("VTKHDF/PointData/velocity"),
            (std::vector<double>{1, 2, 0, 3, 4, 0, 5, 6, 0, 7, 8, 0}));
  EXPECT_EQ(file.text_attribute("VTKHDF/PointData/velocity", "unit"), "m/s");
  EXPECT_EQ(file.info("VTKHDF/CellData/stress").shape, (std::vector<std::size_t>{2, 6}));
  EXPECT_EQ(file.read<double>("VTKHDF/FieldData/time"), (std::vector<double>{0.5}));
  EXPECT_EQ(file.read<std::int64_t>("VTKHDF/FieldData/step"), (std::vector<std::int64_t>{3}));
}

TEST(IoFrames, SizesThatDoNotFitAreRefused) {
  TempFolder folder;
  Square square(0);
  square.connectivity[5] = 4;
  EXPECT_THROW(write_frame(folder / "a.vtkhdf", square.frame(0)), std::logic_error);
  square.connectivity[5] = 3;
  square.velocity.pop_back();
  EXPECT_THROW(write_frame(folder / "a.vtkhdf", square.frame(0)), std::logic_error);
  EXPECT_EQ(folder.entries(), 0u);
}

TEST(IoFrames, SeriesListsWhatIsThere) {
  TempFolder folder;
  const Square square(0);
  FrameSeries series(folder.path());
  EXPECT_THAT(file_text(folder / "frames.vtkhdf.series"), HasSubstr("\"files\": [\n  ]"));
  series.write(square.frame(0));
  series.write(square.frame(0.25), square.sides());
  EXPECT_EQ(file_text(folder / "frames.vtkhdf.series"),
            "{\n  \"file-series-version\": \"1.0\",\n  \"files\": [\n"
            "    {\"name\": \"frames/000000.vtkhdf\", \"time\": 0},\n"
            "    {\"name\": \"frames/000001.vtkhdf\", \"time\": 0.25}\n  ]\n}\n");
  EXPECT_THAT(file_text(folder / "cracks.vtkhdf.series"), HasSubstr("frames/cracks_000001.vtkhdf"));
  EXPECT_THAT(file_text(folder / "cracks.vtkhdf.series"), Not(HasSubstr("cracks_000000")));
  const H5Reader cracks(folder / "frames/cracks_000001.vtkhdf");
  EXPECT_EQ(
      cracks.names("VTKHDF/CellData"),
      (std::vector<std::string>{"damage", "energy", "mode", "opening", "slip", "status", "time"}));
  EXPECT_EQ(cracks.read<std::uint8_t>("VTKHDF/Types"), (std::vector<std::uint8_t>{3}));
}

std::vector<std::string> contents(const TempFolder& folder) {
  std::vector<std::string> texts;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path())) {
    if (entry.is_regular_file())
      texts.push_back(entry.path().filename().string() + file_text(entry.path()));
  }
  std::sort(texts.begin(), texts.end());
  return texts;
}

TEST(IoFrames, RestartedSeriesEqualsTheUninterruptedOne) {
  TempFolder whole, part;
  const auto run = [](FrameSeries& series, int from, int to) {
    for (int k = from; k < to; ++k) {
      const Square square(0.1 * k);
      if (k < 2) {
        series.write(square.frame(k));
      } else {
        series.write(square.frame(k), square.sides());
      }
    }
  };
  FrameSeries uninterrupted(whole.path());
  run(uninterrupted, 0, 6);
  for (const int kept : {0, 1, 3, 5}) {
    FrameSeries first(part.path());
    run(first, 0, 3);
    const auto times = first.times();
    run(first, 3, 5);
    std::vector<double> known = first.times();
    known.resize(static_cast<std::size_t>(kept));
    FrameSeries second(part.path(), known);
    EXPECT_EQ(part.entries("frames"), static_cast<std::size_t>(kept + std::max(0, kept - 2)));
    run(second, kept, 6);
    EXPECT_TRUE(contents(part) == contents(whole)) << kept;
  }
}

TEST(IoFrames, FullDiskLeavesTheListAsItWas) {
  TempFolder folder;
  const Square square(0);
  FrameSeries series(folder.path());
  series.write(square.frame(0));
  const auto before = contents(folder);
  // The disk fills up in the cracks, and in the mesh (by way of a file that finds no space).
  {
    const FileSizeLimit full(3000);
    EXPECT_THAT(error_text([&] { series.write(square.frame(1), square.sides()); }),
                HasSubstr("cracks_000001.vtkhdf"));
  }
  std::filesystem::create_symlink("/dev/full", folder / "frames/000001.vtkhdf.part");
  EXPECT_THAT(error_text([&] { series.write(square.frame(1), square.sides()); }),
              HasSubstr("frames/000001.vtkhdf"));
  EXPECT_EQ(contents(folder), before);
  EXPECT_EQ(series.times().size(), 1u);
}

}  // namespace
}  // namespace breccia
