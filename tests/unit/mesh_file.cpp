#include "io/mesh_file.hpp"

#include "harness/temp_folder.hpp"
#include "io/hdf5_file.hpp"
#include "unit/mesh_samples.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace breccia {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(MeshFile, ComesBackBitForBit) {
  const TempFolder folder;
  const auto plane = grid_mesh<2>(5, Pattern::cross, 0.2);
  write_mesh(plane, folder / "plane.h5");
  expect_same_mesh(plane, read_mesh<2>(folder / "plane.h5"));
  const auto space = grid_mesh<3>(3, Pattern::five, 0.1);
  write_mesh(space, folder / "space.h5");
  expect_same_mesh(space, read_mesh<3>(folder / "space.h5"));
  EXPECT_EQ(folder.entries(), 2U);  // no part files stay
}

TEST(MeshFile, CurvedEdgesComeBack) {
  const TempFolder folder;
  auto mesh = two_triangles();
  write_mesh(mesh, folder / "straight.h5");
  mesh.curved = {{edge_of(0, 1), {0.5, -0.1}}, {edge_of(2, 0), {0.4, 0.6}}};
  write_mesh(mesh, folder / "m.h5");
  expect_same_mesh(mesh, read_mesh<2>(folder / "m.h5"));
  const auto version = [&](const std::string& name) {
    return H5Reader(folder / name).integer_attribute("", "version")[0];
  };
  EXPECT_EQ(version("straight.h5"), 1);  // older builds read it
  EXPECT_EQ(version("m.h5"), 2);         // and refuse this one
}

TEST(MeshFile, MeshWithoutRegionsComesBack) {
  const TempFolder folder;
  const auto mesh = two_triangles();
  write_mesh(mesh, folder / "m.h5");
  expect_same_mesh(mesh, read_mesh<2>(folder / "m.h5"));
}

TEST(MeshFile, IsTakenAsBodyByNameOrWhole) {
  const TempFolder folder;
  const auto mesh = grid_mesh<2>(4, Pattern::right);
  const std::string path = folder / "m.h5";
  write_mesh(mesh, path);
  BodyShape body = body_of("slab", MeshFile{path, "body"}, 0);
  const NativeReader<2> reader = read_mesh<2>;
  const auto part = mesh_bodies<2>(std::span<const BodyShape>(&body, 1), reader);
  EXPECT_EQ(part.point, mesh.point);
  EXPECT_EQ(part.element, mesh.element);
  const Region* left = find_region(part, "slab.left");
  ASSERT_TRUE(left);
  EXPECT_EQ(left->faces, find_region(mesh, "body.left")->faces);
  EXPECT_EQ(left->points, find_region(mesh, "body.left")->points);
  body.shape = MeshFile{path, ""};
  const auto whole = mesh_bodies<2>(std::span<const BodyShape>(&body, 1), reader);
  EXPECT_EQ(whole.element, mesh.element);
  EXPECT_TRUE(find_region(whole, "slab.body.left"));
}

class DamagedMeshFile : public testing::Test {
 protected:
  DamagedMeshFile() { write_mesh(two_triangles(), path); }

  /// Writes a file that has everything right but one data set.
  template <class T>
  void write_with(const std::string& name, const std::vector<T>& values,
                  const std::vector<std::size_t>& shape) {
    const H5Reader good(path);
    const std::string other = folder / "damaged.h5";
    H5Writer file(other);
    file.attribute("", "format", "breccia mesh");
    file.attribute("", "version", good.integer_attribute("", "version"));
    file.attribute("", "dimension", good.integer_attribute("", "dimension"));
    for (const std::string& set : good.names("")) {
      if (set == name) {
        file.write(set, view_of(values, shape));
      } else if (set.ends_with("names")) {
        file.write_text(set, good.read_text(set));
      } else if (good.info(set).type == DataType::f64) {
        copy<double>(good, file, set);
      } else if (good.info(set).type == DataType::i64) {
        copy<std::int64_t>(good, file, set);
      } else {
        copy<std::int32_t>(good, file, set);
      }
    }
    file.commit();
    path = other;
  }

  std::string refusal() {
    return error_text([&] { read_mesh<2>(path); });
  }

  TempFolder folder;
  std::string path = folder / "mesh.h5";

 private:
  template <class T>
  static void copy(const H5Reader& from, H5Writer& to, const std::string& set) {
    to.write(set, view_of(from.read<T>(set), from.info(set).shape));
  }
};

TEST_F(DamagedMeshFile, MissingIsNamed) {
  path = folder / "nowhere.h5";
  EXPECT_THAT(refusal(), HasSubstr("nowhere.h5"));
}

TEST_F(DamagedMeshFile, ForeignIsNamed) {
  put_text(path, "solid cube\n");
  EXPECT_FALSE(looks_like_hdf5(path));
  EXPECT_THAT(refusal(), HasSubstr("mesh.h5"));
}

TEST_F(DamagedMeshFile, HalfAFileIsNamed) {
  const std::string bytes = file_text(path);
  EXPECT_TRUE(looks_like_hdf5(path));
  for (const std::size_t part : {bytes.size() / 2, bytes.size() - 1, std::size_t{100}}) {
    put_text(path, bytes.substr(0, part));
    EXPECT_THAT(refusal(), HasSubstr("mesh.h5"));
  }
}

TEST_F(DamagedMeshFile, OtherHdf5IsNamed) {
  H5Writer file(path);
  file.write("points", view_of(std::vector<double>{1, 2}));
  file.commit();
  EXPECT_THAT(refusal(), HasSubstr("no Breccia mesh"));
}

TEST_F(DamagedMeshFile, OtherDimensionIsNamed) {
  EXPECT_THAT(error_text([&] { read_mesh<3>(path); }),
              AllOf(HasSubstr("a mesh of dimension 2"), HasSubstr("scene has dimension 3")));
}

TEST_F(DamagedMeshFile, NewerVersionIsNamed) {
  H5Writer file(path);
  file.attribute("", "format", "breccia mesh");
  file.attribute("", "version", std::array<std::int64_t, 1>{99});
  file.commit();
  EXPECT_THAT(refusal(), HasSubstr("format version 99"));
}

TEST_F(DamagedMeshFile, CurvedEdgesOutOfRangeAreRefused) {
  auto mesh = two_triangles();
  mesh.curved = {{edge_of(0, 2), {0.4, 0.6}}};
  const std::vector<std::vector<Index>> edges = {{0, 4}, {2, 0}, {-1, 2}};
  for (const auto& edge : edges) {
    path = folder / "mesh.h5";
    write_mesh(mesh, path);
    write_with<Index>("curved_edges", edge, {1, 2});
    EXPECT_THAT(refusal(), HasSubstr("do not fit"));
  }
  path = folder / "mesh.h5";
  write_with<double>("curved_points", {std::nan(""), 0}, {1, 2});
  EXPECT_THAT(refusal(), HasSubstr("do not fit"));
}

TEST_F(DamagedMeshFile, NumbersOutOfRangeAreRefused) {
  write_with<Index>("elements", {0, 1, 2, 0, 2, 4}, {2, 3});
  EXPECT_THAT(refusal(), HasSubstr("out of range"));
}

TEST_F(DamagedMeshFile, WrongShapesAreRefused) {
  write_with<Index>("elements", {0, 1, 2, 3}, {1, 4});
  EXPECT_THAT(refusal(), HasSubstr("\"elements\" has not 3 columns"));
}

TEST_F(DamagedMeshFile, ListsThatDoNotFitAreRefused) {
  write_with<std::int64_t>("region_points_start", {0, 5}, {2});
  EXPECT_THAT(refusal(), HasSubstr("\"region_points_start\" do not fit"));
}

TEST_F(DamagedMeshFile, TooFewBodiesAreRefused) {
  write_with<Index>("bodies", {0}, {1});
  EXPECT_THAT(refusal(), HasSubstr("out of range"));
}

TEST(MeshFile, FullDiskLeavesTheOldFile) {
  const TempFolder folder;
  const std::string path = folder / "m.h5";
  write_mesh(two_triangles(), path);
  const std::string before = file_text(path);
  {
    const FileSizeLimit full(4096);
    EXPECT_THAT(error_text([&] { write_mesh(grid_mesh<2>(64, Pattern::cross), path); }),
                HasSubstr("m.h5"));
  }
  EXPECT_EQ(file_text(path), before);
  EXPECT_EQ(folder.entries(), 1U);
}

}  // namespace
}  // namespace breccia
