#include "mesh/shapes.hpp"
#include "mesh/validate.hpp"
#include "unit/mesh_samples.hpp"

#include <gmock/gmock.h>

namespace breccia {
namespace {

using testing::HasSubstr;

TEST(MeshShapes, StructuredBodiesNeedNoGmsh) {
  std::vector<BodyShape> bodies = {body_of("a", Rectangle{{0, 0}, {1, 1}}, 0.25),
                                   body_of("b", Rectangle{{1, 0}, {2, 1}}, 0.5)};
  bodies[0].pattern = Pattern::cross;
  bodies[1].pattern = Pattern::right;
  const auto mesh = mesh_bodies<2>(bodies);
  EXPECT_EQ(mesh.body_names, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(mesh.elements(), 64 + 8);
  EXPECT_NEAR(total_volume(mesh, 1), 1, 1e-14);
  EXPECT_NEAR(face_area(mesh, "b.left"), 1, 1e-14);
  EXPECT_NO_THROW(validate(mesh, "two bodies"));  // coincident points of two bodies are no fault
}
}  // namespace
}  // namespace breccia
