#include "harness/temp_folder.hpp"
#include "mesh/composite.hpp"
#include "mesh/geometry.hpp"
#include "mesh/gmsh_mesher.hpp"
#include "mesh/msh_reader.hpp"
#include "mesh/topology.hpp"
#include "unit/mesh_msh_samples.hpp"
#include "unit/mesh_samples.hpp"

#include <gmock/gmock.h>

namespace breccia {
namespace {

using testing::HasSubstr;

Mesh<2> mesh_files(const std::vector<std::pair<std::string, MeshFile>>& files,
                   const std::string& part_of = "") {
  std::vector<BodyShape> bodies;
  for (const auto& [name, file] : files) {
    bodies.push_back(body_of(name, file, 0));
    bodies.back().part_of = part_of;
  }
  return mesh_bodies<2>(bodies);
}

/// Two unit squares of two triangles each, "rock" and "steel", the line "loaded" on top of both.
void check_two_squares(const std::string& path) {
  const auto rock = mesh_files({{"slab", MeshFile{path, "rock"}}});
  EXPECT_EQ(rock.elements(), 2);
  EXPECT_EQ(rock.points(), 4);
  EXPECT_NEAR(total_volume(rock), 1, 1e-15);
  const Region* loaded = find_region(rock, "slab.loaded");
  ASSERT_TRUE(loaded);
  ASSERT_EQ(loaded->faces.size(), 1U);
  EXPECT_EQ(loaded->points.size(), 2U);
  const auto& face = loaded->faces[0];
  const auto normal = face_normal_area<2>(corners(rock, face.element), face.face);
  EXPECT_EQ(normal, (Point<2>{0, 1}));
  EXPECT_FALSE(find_region(rock, "slab.rock"));

  const auto both =
      mesh_files({{"slab", MeshFile{path, "rock"}}, {"plate", MeshFile{path, "steel"}}}, "press");
  EXPECT_EQ(both.points(), 6);  // the common side is shared
  EXPECT_EQ(build_topology(both).shared.size(), 3U);
  EXPECT_EQ(find_region(both, "plate.loaded")->faces.size(), 1U);

  const auto whole = mesh_files({{"all", MeshFile{path, ""}}});
  EXPECT_EQ(whole.elements(), 4);
  EXPECT_EQ(find_region(whole, "all.rock")->elements.size(), 2U);
  EXPECT_EQ(find_region(whole, "all.loaded")->faces.size(), 2U);
  EXPECT_EQ(find_region(whole, "all.corner")->points.size(), 1U);
}

TEST(MeshMsh, ReadsVersionTwo) {
  const TempFolder folder;
  put_text(folder / "two.msh", kTwoSquares22);
  EXPECT_TRUE(is_ascii_msh(folder / "two.msh"));
  check_two_squares(folder / "two.msh");
}

TEST(MeshMsh, ReadsVersionFour) {
  const TempFolder folder;
  put_text(folder / "four.msh", kTwoSquares41);
  EXPECT_TRUE(is_ascii_msh(folder / "four.msh"));
  check_two_squares(folder / "four.msh");
}

TEST(MeshMsh, DropsPointsOfTheGeometryOnly) {
  // Gmsh saves the centre of a circle as a node with a point element.
  const TempFolder folder;
  const std::string text = replaced(replaced(kTwoSquares22, "6\n1 0 0 0", "7\n77 9 9 0\n1 0 0 0"),
                                    "7\n1 15", "8\n99 15 2 0 9 77\n1 15");
  put_text(folder / "centre.msh", text);
  EXPECT_EQ(mesh_files({{"all", MeshFile{folder / "centre.msh", ""}}}).points(), 6);
}

TEST(MeshMsh, AnElementInTwoGroupsCountsOnce) {
  const TempFolder folder;
  // MSH 2 lists the element again for its second group.
  const std::string text = replaced(replaced(kTwoSquares22, "7\n1 15", "8\n88 2 2 4 1 1 2 5\n1 15"),
                                    "4\n0 3", "5\n2 4 \"soft\"\n0 3");
  put_text(folder / "groups.msh", text);
  const auto mesh = mesh_files({{"all", MeshFile{folder / "groups.msh", ""}}});
  EXPECT_EQ(mesh.elements(), 4);
  EXPECT_EQ(find_region(mesh, "all.soft")->elements.size(), 1U);
}

TEST(MeshMsh, SecondOrderFilesGiveCurvedEdges) {
  const TempFolder folder;
  put_text(folder / "curved.msh", kCurvedTriangle22);
  BodyShape body = body_of("slab", MeshFile{folder / "curved.msh", "rock"}, 0);
  EXPECT_TRUE(mesh_one<2>(body).curved.empty());  // simple elements stay straight
  body.curved = true;
  const auto mesh = mesh_one<2>(body);
  EXPECT_EQ(mesh.points(), 3);
  ASSERT_EQ(mesh.curved.size(), 1U);  // the other two edges are straight
  EXPECT_EQ(mesh.curved.begin()->first, edge_of(1, 2));
  EXPECT_EQ(mesh.curved.begin()->second, (Point<2>{0.6, 0.6}));
  const auto composite = refined_to_composites(mesh, std::vector<int>{4});
  EXPECT_NEAR(total_volume(composite), 0.6, 1e-15);
  EXPECT_EQ(find_region(composite, "slab.slope")->points.size(), 3U);
  put_text(folder / "space.msh", kTetrahedron22);
  body.shape = MeshFile{folder / "space.msh", ""};
  EXPECT_TRUE(mesh_one<3>(body).curved.empty());  // as only the right order of edges can tell
}

TEST(MeshMsh, ClockwiseFilesAreTurnedOver) {
  const TempFolder folder;
  std::string text = replaced(kTwoSquares22, " 1 2 5\n", " 2 1 5\n");
  text = replaced(text, " 1 5 4\n", " 5 1 4\n");
  text = replaced(text, " 2 3 6\n", " 3 2 6\n");
  put_text(folder / "mixed.msh", text);  // one triangle keeps its direction
  EXPECT_THAT(error_text([&] {
                mesh_files({{"all", MeshFile{folder / "mixed.msh", ""}}});
              }),
              HasSubstr("inverted"));
  put_text(folder / "clockwise.msh", replaced(text, " 2 6 5\n", " 6 2 5\n"));
  EXPECT_NO_THROW(mesh_files({{"all", MeshFile{folder / "clockwise.msh", ""}}}));
}

}  // namespace
}  // namespace breccia
