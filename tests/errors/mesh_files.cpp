// Damaged mesh files: each is refused with its name, the line where there is one, and a remedy.

#include "harness/temp_folder.hpp"
#include "unit/mesh_msh_samples.hpp"
#include "unit/mesh_samples.hpp"

#include <gmock/gmock.h>

#include <functional>
#include <ostream>

namespace breccia {
namespace {

using testing::AllOf;
using testing::HasSubstr;

struct Damage {
  std::string name, what, by, text;
};

std::ostream& operator<<(std::ostream& out, const Damage& damage) {
  return out << damage.name;
}

std::string refusal_of(const std::string& path, const std::string& region = "") {
  const BodyShape body = body_of("slab", MeshFile{path, region}, 0.1);
  return error_text([&] { mesh_bodies<2>(std::span<const BodyShape>(&body, 1)); });
}

class MshFile : public testing::TestWithParam<Damage> {};

TEST_P(MshFile, IsRefused) {
  const TempFolder folder;
  const std::string path = folder / "slab.msh";
  put_text(path, replaced(kTwoSquares22, GetParam().what, GetParam().by));
  EXPECT_THAT(refusal_of(path), AllOf(HasSubstr("slab.msh"), HasSubstr(GetParam().text)));
}

INSTANTIATE_TEST_SUITE_P(
    Damaged, MshFile,
    testing::Values(
        Damage{"NoHeading", "$MeshFormat", "solid cube", "not a Gmsh mesh file"},
        Damage{"NoElements", "$Elements", "$Comments", "ends too early"},
        Damage{"LetterInNumber", "2 1 0 0\n", "2 1 O 0\n", ":14: \"O\" is not a number"},
        Damage{"NotFinite", "2 1 0 0\n", "2 nan 0 0\n", "without finite coordinates"},
        Damage{"MissingNode", "1 1 2 5\n", "1 1 2 55\n", "uses node 55, which does not exist"},
        Damage{"NodeTwice", "2 1 0 0\n", "1 1 0 0\n", "node 1 is listed twice"},
        Damage{"TooFewNodes", "6\n1 0 0 0", "7\n1 0 0 0", "is not a whole number"},
        Damage{"Quadrangle", "4 2 2 1 1 1 2 5", "4 3 2 1 1 1 2 5", "elements of Gmsh type 3"},
        Damage{"ThirdOrder", "4 2 2 1 1 1 2 5", "4 21 2 1 1 1 2 5", "elements of Gmsh type 21"},
        Damage{"Inverted", " 1 2 5\n", " 2 1 5\n", "inverted"},
        Damage{"Duplicate", "7 2 2 2 2 2 6 5", "7 2 2 2 2 3 6 2", "have the same points"},
        Damage{"ZeroArea", "5 1 1 0\n", "5 1 0 0\n", "zero area"},
        Damage{"Orphan", "6\n1 0 0 0", "7\n8 3 3 0\n1 0 0 0", "used by no element"},
        Damage{"OffPlane", "5 1 1 0\n", "5 1 1 0.5\n", "off the plane z = 0"},
        Damage{"RepeatedPoint", " 1 2 5\n", " 1 5 5\n", "use a point twice"}),
    [](const auto& tested) { return tested.param.name; });

class CurvedMshFile : public testing::TestWithParam<Damage> {};

TEST_P(CurvedMshFile, IsRefused) {
  const TempFolder folder;
  const std::string path = folder / "slope.msh";
  put_text(path, replaced(kCurvedTriangle22, GetParam().what, GetParam().by));
  EXPECT_THAT(refusal_of(path), AllOf(HasSubstr("slope.msh"), HasSubstr(GetParam().text)));
}

INSTANTIATE_TEST_SUITE_P(
    Damaged, CurvedMshFile,
    testing::Values(
        Damage{"MiddleMissing", "2 3 4 5 6\n", "2 3 4 5 66\n",
               "uses node 66, which does not exist"},
        Damage{"OtherMiddle", "5 2 3 5\n", "5 2 3 6\n", "has two mid-edge nodes"},
        Damage{"MiddleIsACorner", "2\n1 8 2 7 5 2 3 5\n", "3\n3 2 2 1 1 4 2 5\n1 8 2 7 5 2 3 5\n",
               "is a corner of another element"},
        Damage{"MiddleNotFinite", "5 0.6 0.6 0\n", "5 nan 0.6 0\n", "without finite coordinates"},
        Damage{"MiddleOffPlane", "5 0.6 0.6 0\n", "5 0.6 0.6 1\n", "off the plane z = 0"}),
    [](const auto& tested) { return tested.param.name; });

TEST(MshFileCut, IsRefusedAtEveryLength) {
  const TempFolder folder;
  const std::string path = folder / "slab.msh";
  // Without the last line break the file is whole; any earlier cut is a loss.
  for (std::size_t length = 0; length + 2 < kTwoSquares22.size(); length += 7) {
    put_text(path, kTwoSquares22.substr(0, length));
    EXPECT_THAT(refusal_of(path), HasSubstr("slab.msh")) << length;
  }
}

TEST(MshFileCut, VersionFourIsRefusedAtEveryLength) {
  const TempFolder folder;
  const std::string path = folder / "slab.msh";
  for (std::size_t length = 0; length + 2 < kTwoSquares41.size(); length += 7) {
    put_text(path, kTwoSquares41.substr(0, length));
    EXPECT_THAT(refusal_of(path), HasSubstr("slab.msh")) << length;
  }
}

TEST(MshFileCounts, AbsurdOnesTakeNoMemory) {
  const TempFolder folder;
  const std::string path = folder / "slab.msh";
  put_text(path, replaced(kTwoSquares41, "2 1 0 3\n1\n2\n3", "2 1 0 2000000000\n1\n2\n3"));
  EXPECT_THAT(refusal_of(path), HasSubstr("number of nodes 2000000000 is out of range"));
}

TEST(MshFileMissing, IsNamed) {
  EXPECT_THAT(refusal_of("no/such/slab.msh"),
              AllOf(HasSubstr("no/such/slab.msh"), HasSubstr("cannot be read")));
}

TEST(MshFileRegion, UnknownRegionListsTheKnownOnes) {
  const TempFolder folder;
  put_text(folder / "slab.msh", kTwoSquares22);
  EXPECT_THAT(
      refusal_of(folder / "slab.msh", "rokc"),
      AllOf(HasSubstr("no region \"rokc\""), HasSubstr("rock, steel"), HasSubstr("mean 'rock'")));
}

TEST(MshFileRegion, CoincidentPointsOfOneBodyAreNamed) {
  const TempFolder folder;
  std::string text = replaced(kTwoSquares22, "6\n1 0 0 0", "8\n8 1 0 0\n9 1 1 0\n1 0 0 0");
  text = replaced(replaced(text, " 2 3 6\n", " 8 3 6\n"), " 2 6 5\n", " 8 6 9\n");
  text = replaced(text, "5 5 6\n", "5 9 6\n");
  put_text(folder / "slab.msh", text);
  EXPECT_THAT(refusal_of(folder / "slab.msh"), HasSubstr("coincide within one body"));
}

struct Description {
  std::string name;
  BodyShape body;
  std::string text;
};

std::ostream& operator<<(std::ostream& out, const Description& d) {
  return out << d.name;
}

BodyShape changed(BodyShape body, const std::function<void(BodyShape&)>& change) {
  change(body);
  return body;
}

const BodyShape kPlate = body_of("plate", Rectangle{{0, 0}, {1, 1}}, 0.1);

class BodyDescription : public testing::TestWithParam<Description> {};

TEST_P(BodyDescription, IsRefusedBeforeMeshing) {
  const BodyShape& body = GetParam().body;
  EXPECT_THAT(error_text([&] { mesh_bodies<2>(std::span<const BodyShape>(&body, 1)); }),
              AllOf(HasSubstr("body \"plate\""), HasSubstr(GetParam().text)));
}

INSTANTIATE_TEST_SUITE_P(
    Wrong, BodyDescription,
    testing::Values(
        Description{"NoSize", changed(kPlate, [](auto& b) { b.size = 0; }), "element size is 0 m"},
        Description{"TinySize", changed(kPlate, [](auto& b) { b.size = 1e-6; }),
                    "it would have about 2e+12 of them"},
        Description{"Radius", body_of("plate", Disc{{0, 0}, -1}, 0.1), "radius is -1 m"},
        Description{"Corners", body_of("plate", Rectangle{{0, 0}, {-1, 1}}, 0.1),
                    "extent along x is not positive"},
        Description{"Dimension", body_of("plate", Ball{{0, 0, 0}, 1}, 0.1),
                    "a ball is a shape of dimension 3 in a scene of dimension 2"},
        Description{"TwoCorners", body_of("plate", Polygon{{{0, 0}, {1, 0}}, {}}, 0.1),
                    "outline has 2 points"},
        Description{"Bow", body_of("plate", Polygon{{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, {}}, 0.1),
                    "outline crosses itself"},
        Description{"Closed", body_of("plate", Polygon{{{0, 0}, {1, 0}, {1, 1}, {0, 0}}, {}}, 0.1),
                    "repeats the point (0, 0) m"},
        Description{"Flat", body_of("plate", Polygon{{{0, 0}, {1, 0}, {2, 0}}, {}}, 0.1),
                    "encloses no area"},
        Description{
            "HoleOutside",
            body_of("plate", Polygon{{{0, 0}, {1, 0}, {1, 1}}, {{{5, 5}, {6, 5}, {6, 6}}}}, 0.1),
            "hole 0 is not inside the outline"},
        Description{"Refinement",
                    changed(kPlate,
                            [](auto& b) {
                              b.refinements = {{{}, 1, -0.1, 0}};
                            }),
                    "a refinement has size -0.1 m"},
        Description{"Line",
                    changed(kPlate,
                            [](auto& b) {
                              b.lines = {{"crack", {{0, 0}}}};
                            }),
                    "the line \"crack\" has no length"},
        Description{"PatternOfADisc",
                    changed(body_of("plate", Disc{{0, 0}, 1}, 0.1),
                            [](auto& b) { b.pattern = Pattern::cross; }),
                    "only a rectangle or a box"},
        Description{"LineInAPattern",
                    changed(kPlate,
                            [](auto& b) {
                              b.pattern = Pattern::cross;
                              b.lines = {{"crack", {{0, 0}, {1, 1}}}};
                            }),
                    "only a mesh made by Gmsh can follow"}),
    [](const auto& tested) { return tested.param.name; });

TEST(BodyDescriptions, PartsOfOneSolidHaveOneOrigin) {
  std::vector<BodyShape> bodies = {kPlate, body_of("rest", MeshFile{"a.msh", ""}, 0)};
  bodies[0].part_of = bodies[1].part_of = "wall";
  EXPECT_THAT(error_text([&] { mesh_bodies<2>(bodies); }),
              AllOf(HasSubstr("body \"rest\""), HasSubstr("bodies of other origin")));
}

TEST(BodyDescriptions, NamesAreUnique) {
  std::vector<BodyShape> bodies = {kPlate, kPlate};
  for (auto& body : bodies) body.pattern = Pattern::right;
  EXPECT_THAT(error_text([&] { mesh_bodies<2>(bodies); }),
              HasSubstr("body \"plate\": two bodies have this name"));
}

}  // namespace
}  // namespace breccia
