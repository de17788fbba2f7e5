#include "harness/failures.hpp"
#include "harness/temp_folder.hpp"
#include "io/csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>

namespace breccia {
namespace {

using testing::HasSubstr;

const std::vector<std::string> kColumns = {"time", "step", "load.y"};

void write_rows(HistoryWriter& history, int from, int to) {
  for (int k = from; k < to; ++k) {
    history.write(std::array{k * 1e-6, 10.0 * k, std::sin(static_cast<double>(k))});
  }
}

TEST(IoCsv, RowsReadBackExactlyAndAreSeenAtOnce) {
  TempFolder folder;
  const std::string path = folder / "history.csv";
  HistoryWriter history(path, kColumns);
  EXPECT_EQ(file_text(path), "time,step,load.y\n");
  history.write(std::array{0.1, 1000000.0, std::nan("")});
  EXPECT_EQ(file_text(path), "time,step,load.y\n0.1,1000000,nan\n");
  EXPECT_EQ(history.rows(), 1);
  EXPECT_THROW(history.write(std::array{1.0}), std::logic_error);
}

TEST(IoCsv, ColumnNamesThatNeedQuotesGetThem) {
  TempFolder folder;
  CsvTable table(folder / "a.csv", {"plain", "a,b", "a \"b\""});
  EXPECT_EQ(file_text(folder / "a.csv"), "plain,\"a,b\",\"a \"\"b\"\"\"\n");
}

// The run is killed after row `end`, its checkpoint is from row `kept`.
TEST(IoCsv, RestartedFileEqualsTheUninterruptedOne) {
  TempFolder folder;
  {
    HistoryWriter whole(folder / "whole.csv", kColumns);
    write_rows(whole, 0, 50);
  }
  for (const int kept : {0, 1, 20}) {
    for (const int end : {20, 35}) {
      const std::string path = folder / "part.csv";
      {
        HistoryWriter history(path, kColumns);
        write_rows(history, 0, end);
      }
      {
        HistoryWriter history(path, kColumns, kept);
        EXPECT_EQ(history.rows(), kept);
        write_rows(history, kept, 50);
      }
      EXPECT_EQ(file_text(path), file_text(folder / "whole.csv")) << kept << " " << end;
    }
  }
}

TEST(IoCsv, HalfALastLineIsCutOff) {
  TempFolder folder;
  const std::string path = folder / "history.csv";
  put_text(path, "time,step,load.y\n1,2,3\n4,5");
  HistoryWriter history(path, kColumns, 1);
  EXPECT_EQ(file_text(path), "time,step,load.y\n1,2,3\n");
}

TEST(IoCsv, FilesThatDoNotFitAreRefused) {
  TempFolder folder;
  const std::string path = folder / "history.csv";
  EXPECT_THAT(error_text([&] { HistoryWriter history(path, kColumns, 1); }),
              HasSubstr("No such file"));
  put_text(path, "time,step,load.y\n1,2,3\n");
  EXPECT_THAT(error_text([&] { HistoryWriter history(path, kColumns, 2); }),
              HasSubstr("fewer rows"));
  EXPECT_THAT(error_text([&] {
                HistoryWriter history(path, {"time", "step"}, 1);
              }),
              AllOf(HasSubstr("columns"), HasSubstr("--overwrite")));
  EXPECT_EQ(file_text(path), "time,step,load.y\n1,2,3\n") << "a refused file was changed";
}

TEST(IoCsv, FullDiskIsCalledThat) {
  TempFolder folder;
  EXPECT_THAT(error_text([] { HistoryWriter history("/dev/full", kColumns); }),
              AllOf(HasSubstr("/dev/full"), HasSubstr("the disk is full")));
  const std::string path = folder / "history.csv";
  HistoryWriter history(path, kColumns);
  write_rows(history, 0, 3);
  const FileSizeLimit full(std::filesystem::file_size(path) + 2);
  EXPECT_THAT(error_text([&] { write_rows(history, 3, 4); }), HasSubstr(path));
}

TEST(IoCsv, UnwritableFolderIsCalledThat) {
  const NoRights rights;
  EXPECT_THAT(
      error_text([] { HistoryWriter history("/usr/history.csv", kColumns); }),
      AllOf(HasSubstr("/usr/history.csv"), HasSubstr("Permission denied"), HasSubstr("--output")));
}

TEST(IoCsv, EventsAndFragmentsInPlaneAndSpace) {
  TempFolder folder;
  const CrackEvent event = {1e-3, {1, 2, 3}, {0, 1, 0}, 0.5, 1.25, 4, 5, 6, 7, 8};
  {
    EventWriter plane(folder / "e2.csv", 2), space(folder / "e3.csv", 3);
    plane.write(std::span(&event, 1));
    space.write(std::span(&event, 1));
    EXPECT_EQ(plane.rows(), 1);
  }
  EXPECT_EQ(file_text(folder / "e2.csv"),
            "time,x,y,normal_x,normal_y,area,mode,energy_tension,energy_shear,opening,slip,"
            "moment\n"
            "0.001,1,2,0,1,0.5,1.25,4,5,6,7,8\n");
  EXPECT_THAT(file_text(folder / "e3.csv"), HasSubstr("\n0.001,1,2,3,0,1,0,0.5,1.25,4,5,6,7,8\n"));
  for (const int dimension : {2, 3}) {
    const auto read =
        read_events(folder / ("e" + std::to_string(dimension) + ".csv"), dimension, 1);
    ASSERT_EQ(read.size(), 1u);
    EXPECT_EQ(read[0].place[2], dimension == 3 ? 3 : 0);
    EXPECT_EQ(read[0].normal[1], 1);
    EXPECT_EQ(read[0].moment, 8);
  }
  EXPECT_TRUE(read_events(folder / "e2.csv", 2, 0).empty());
  EXPECT_THAT(error_text([&] { read_events(folder / "e2.csv", 3, 1); }),
              HasSubstr("row 1 is damaged"));
  { EventWriter again(folder / "e2.csv", 2, 0); }
  EXPECT_EQ(file_text(folder / "e2.csv"),
            "time,x,y,normal_x,normal_y,area,mode,energy_tension,energy_shear,opening,slip,"
            "moment\n");

  const FragmentRow piece = {0, 12, 2.5, 0.1, {1, 2, 3}, {4, 5, 6}, {7, 8, 9}, 0.2, 0.05};
  {
    FragmentWriter plane(folder / "f.csv", 2);
    plane.write(0.25, 7, std::vector{piece, piece});
    EXPECT_EQ(plane.rows(), 2);
  }
  EXPECT_EQ(file_text(folder / "f.csv"),
            "time,frame,fragment,elements,mass,size,x,y,velocity_x,velocity_y,"
            "spin,length,width\n"
            "0.25,7,0,12,2.5,0.1,1,2,4,5,9,0.2,0.05\n0.25,7,0,12,2.5,0.1,1,2,4,5,9,0.2,0.05\n");
}

}  // namespace
}  // namespace breccia
