#include "harness/failures.hpp"
#include "harness/temp_folder.hpp"
#include "io/checkpoint.hpp"
#include "io/frame_series.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace breccia {
namespace {

using testing::HasSubstr;

// Compiled only into builds without HDF5: what needs it says so, and leaves nothing behind.
TEST(IoWithoutHdf5, FramesAndCheckpointsSayWhatIsMissing) {
  TempFolder folder;
  const auto says = AllOf(HasSubstr("has no HDF5"), HasSubstr("install HDF5"));
  EXPECT_FALSE(hdf5_available());
  EXPECT_THAT(error_text([&] { FrameSeries series(folder.path()); }), says);
  EXPECT_THAT(error_text([&] { write_frame(folder / "a.vtkhdf", Frame{}); }), says);
  EXPECT_THAT(error_text([&] { CheckpointWriter writer(folder / "a.h5", {}); }), says);
  EXPECT_THAT(error_text([&] { CheckpointReader reader(folder / "a.h5", {}); }), says);
  EXPECT_EQ(folder.entries(), 0u);
}

}  // namespace
}  // namespace breccia
