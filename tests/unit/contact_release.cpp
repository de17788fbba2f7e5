// Released faces that the surface does not have yet: when they can wait.
#include "loops/contact_release.hpp"

#include "base/views.hpp"

#include <gtest/gtest.h>

namespace breccia {
namespace {

/// Two triangles left and right of x = 1 whose common face was released; nodes have split.
struct TwoSides {
  ReleasedFaces<2> faces;
  Vectors<2> x{"x", 6}, v{"v", 6};
  Array<std::uint8_t> known{"known", 1};
  Array<Index> list;

  TwoSides(double gap, const Vec<2>& velocity, std::uint8_t status = 2) {
    Connectivity<2> nodes("nodes", 2);
    Ranges elements("elements", 1);
    Kokkos::View<std::uint8_t*, Memory> state("status", 1), code("code", 1);
    for_each(
        "two_sides", 1, KOKKOS_CLASS_LAMBDA(Index) {
          const double at[6][2] = {{1, 0}, {1, 1}, {0, 0.5}, {1, 1}, {1, 0}, {2, 0.5}};
          for (int n = 0; n < 6; ++n) {
            nodes(n / 3, n % 3) = n;
            x(n, 0) = at[n][0] + (n < 3 ? 0 : gap);
            x(n, 1) = at[n][1];
            for (int d = 0; d < 2; ++d) v(n, d) = n < 3 ? 0 : velocity[d];
          }
          elements(0, 0) = 0;
          elements(0, 1) = 1;
          code(0) = 2 | 2 << 2 | 1 << 4;
          state(0) = status;
        });
    faces = {1, state, code, elements, nodes, 2};
  }
  bool meet(double time) {
    const Index n = list_new_releases(faces, known, list);
    return sides_meet<2>(faces, list, n, x, v, time);
  }
};

TEST(ContactRelease, OpenSidesMayWait) {
  EXPECT_FALSE(TwoSides(1e-3, {{0, 0}}).meet(1));
  EXPECT_FALSE(TwoSides(1e-3, {{-1, 0}}).meet(0.9e-3));
}

TEST(ContactRelease, SidesThatTouchOrSoonWillMayNot) {
  EXPECT_TRUE(TwoSides(0, {{0, 0}}).meet(0));
  EXPECT_TRUE(TwoSides(-1e-3, {{1, 0}}).meet(0));
  EXPECT_TRUE(TwoSides(1e-3, {{-1, 0}}).meet(1.1e-3));
  EXPECT_TRUE(TwoSides(1e-3, {{0, 1}}).meet(1.1e-3));
}

TEST(ContactRelease, OnlyNewlyReleasedFacesCount) {
  TwoSides bonded(0, {{0, 0}}, 1), sides(0, {{0, 0}});
  EXPECT_EQ(list_new_releases(bonded.faces, bonded.known, bonded.list), 0);
  EXPECT_EQ(list_new_releases(sides.faces, sides.known, sides.list), 1);
  ContactSurface<2> surface;
  mark_known_releases(sides.faces, surface, sides.known);
  EXPECT_EQ(list_new_releases(sides.faces, sides.known, sides.list), 1);
  surface.facets = 2;
  surface.facet = to_device<Index>("facet", {2, 5});
  mark_known_releases(sides.faces, surface, sides.known);
  EXPECT_EQ(list_new_releases(sides.faces, sides.known, sides.list), 0);
}

}  // namespace
}  // namespace breccia
