#include "unit/mesh_samples.hpp"

#include <gmock/gmock.h>

namespace breccia {
namespace {

using testing::HasSubstr;

TEST(MeshShapes, WithoutGmshSaysWhatToInstall) {
  EXPECT_THAT(error_text([] {
                mesh_one<2>(body_of("disc", Disc{{0, 0}, 1}, 0.1));
              }),
              HasSubstr("libgmsh-dev"));
}
}  // namespace
}  // namespace breccia
