// [[axes]] from a field of the elements in a mesh file.
#include "harness/scenes.hpp"
#include "harness/temp_folder.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace breccia {
namespace {

constexpr const char* kShale =
    "transversely_isotropic = { young = 4e10, young_axis = 2e10, poisson = 0.2, poisson_axis = "
    "0.1, "
    "shear_axis = 1e10 }";

constexpr const char* kSquare =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 1 \"lower\"\n2 2 \"upper\"\n"
    "$EndPhysicalNames\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$EndNodes\n"
    "$Elements\n2\n7 2 2 1 1 1 2 3\n9 2 2 2 2 1 3 4\n$EndElements\n";

constexpr const char* kCorner =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 "
    "1\n$EndNodes\n"
    "$Elements\n1\n7 4 2 1 1 1 2 3 4\n$EndElements\n";

std::string field(int components, const std::vector<std::string>& rows) {
  std::string text =
      fmt::format("$ElementData\n2\n\"bedding\"\n\"by hand\"\n1\n0\n4\n0\n{}\n{}\n0\n", components,
                  rows.size());
  for (const auto& row : rows) text += row + "\n";
  return text + "$EndElementData\n";
}

/// Material axes of all elements of a body from such a file, and where the elements are.
template <int D>
struct Seeded {
  Seeded(const std::string& mesh, const std::string& element, const std::string& more = "") {
    const TempFolder folder;
    put_text(folder / "b.msh", mesh);
    BlockScene scene;
    scene.dimension = D;
    scene.file = folder / "b.msh";
    scene.elastic = false;
    scene.material = kShale;
    if (!element.empty()) scene.body = "mesh = { element = \"" + element + "\" }";
    scene.more = "[[axes]]\nfield = \"bedding\"\n" + more;
    SceneWorld<D> world(scene.text());
    axes = world.model().axes;
    for (const auto& nodes : world.model().mesh.element) {
      centre.push_back(Vec<D>::zero());
      for (const Index n : nodes)
        centre.back() += vector_of<D>(world.model().mesh.point[n]) * (1.0 / (D + 1));
    }
  }
  std::vector<Mat<D>> axes;
  std::vector<Vec<D>> centre;
};

template <int D>
void expect_axis(const Mat<D>& axes, int k, const Vec<D>& direction) {
  for (int d = 0; d < D; ++d) EXPECT_NEAR(axes(d, k), direction[d], 1e-15) << k;
}

// An angle or a direction for each triangle; the parts of a composite have those of the whole.
TEST(SeededAxes, InThePlane) {
  const double angle = 30 * std::numbers::pi / 180;
  for (const std::string element : {"", "tri6c"})
    for (const std::string& values :
         {field(1, {"7 30", "9 90"}), field(3, {"9 0 2 5", "7 3 1.7320508075688772 0"})}) {
      const Seeded<2> seeded(kSquare + values, element);
      ASSERT_EQ(seeded.axes.size(), element.empty() ? 2U : 8U);
      for (std::size_t e = 0; e < seeded.axes.size(); ++e) {
        const bool lower = seeded.centre[e][1] < seeded.centre[e][0];
        const double a = lower ? angle : std::numbers::pi / 2;
        expect_axis<2>(seeded.axes[e], 0, {{std::cos(a), std::sin(a)}});
        expect_axis<2>(seeded.axes[e], 1, {{-std::sin(a), std::cos(a)}});
      }
    }
}

// Only the elements of `where` need values.
TEST(SeededAxes, OfARegion) {
  const Seeded<2> seeded(kSquare + field(1, {"7 90"}), "", "where = \"b.lower\"\n");
  int turned = 0;
  for (const auto& axes : seeded.axes) turned += std::abs(axes(1, 0)) > 0.5 ? 1 : 0;
  EXPECT_EQ(turned, 1);
}

TEST(SeededAxes, InSpace) {
  for (const std::string element : {"", "tet10c"}) {
    const Seeded<3> normals(kCorner + field(3, {"7 0 3 4"}), element);
    const Seeded<3> all(kCorner + field(9, {"7 0 0 2 2 0 0 0 5 0"}), element);
    ASSERT_EQ(normals.axes.size(), element.empty() ? 1U : 8U);
    for (std::size_t e = 0; e < all.axes.size(); ++e) {
      expect_axis<3>(normals.axes[e], 0, {{1, 0, 0}});  // as near to x as the third allows
      expect_axis<3>(normals.axes[e], 2, {{0, 0.6, 0.8}});
      expect_axis<3>(all.axes[e], 0, {{0, 0, 1}});
      expect_axis<3>(all.axes[e], 1, {{1, 0, 0}});
      expect_axis<3>(all.axes[e], 2, {{0, 1, 0}});
    }
  }
}

}  // namespace
}  // namespace breccia
